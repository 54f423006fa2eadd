// SPDX-License-Identifier: LGPL-2.1-or-later
// The misfit on a mesh of its own: the integrals of u_h that it needs.

#include <signorini/discretization/mesh/cut_quadrature.h>
#include <signorini/error_control/equilibration/carrier.h>
#include <signorini/error_control/equilibration/edge_polynomials.h>
#include <signorini/error_control/equilibration/energy_misfit.h>
#include <signorini/error_control/equilibration/law.h>
#include <signorini/error_control/equilibration/oscillation.h>
#include <signorini/error_control/equilibration/triangle_parts.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace Signorini {
namespace {
/** Returns u_h and, where cells have parents, π^{2h} u_h, which shows where the error is. */
std::vector<EvaluatedField> fields_of(const BoundData &data) {
  std::vector<EvaluatedField> fields = {{&data.U}};
  if (data.space.mesh().has_parents())
    fields.push_back({&data.U, 1});
  return fields;
}

/** Visits the parts of cells with these fields. */
class PartVisitor {
public:
  PartVisitor(const BoundData &data, const Kinks<2> &kinks, const ExactMaps &maps)
    : data_(data)
    , kinks_(kinks)
    , maps_(maps)
    , u_(evaluator_of(data, fields_of(data), maps)) {}
  /** Calls visit(evaluator, is_rough) for the points of all smooth parts of a cell at once, and for
   * those of each rough one. @param load_degree that of polynomials which are multiplied with the
   * fields. */
  template <typename Visitor>
  void operator()(const DoFHandler<2>::active_cell_iterator &cell, const unsigned int load_degree,
                  const Visitor &visit) {
    const unsigned int n = n_points(cell->get_fe().degree, load_degree);
    const bool is_curved = data_.space.mesh().is_curved();
    if (is_curved ? !varies_fast(kinks_, cell) : !needs_cuts<2>(kinks_, cell)) {
      u_.reinit(cell, n);
      visit(u_, false);
      return;
    }
    // On curved bodies data is smooth in its boxes, or the bound is an estimate.
    if (is_curved) {
      u_.reinit_once(cell, cut_quadrature(kinks_, cell, n, maps_.of(cell)));
      visit(u_, false);
      return;
    }
    const auto visit_points = [&](const std::vector<Point<2>> &points,
                                  const std::vector<double> &weights, const bool is_rough) {
      if (points.empty())
        return;
      u_.reinit_once(cell, Quadrature<2>(points, weights));
      visit(u_, is_rough);
    };
    const QWitherdenVincentSimplex<2> rule(3);
    const CellShape shape(corners_of(cell));
    std::vector<Point<2>> smooth;
    std::vector<double> smooth_weights;
    for (const auto &triangle : triangle_parts(shape, kinks_))
      for (const TrianglePart &part : triangle) {
        std::vector<Point<2>> points;
        std::vector<double> weights;
        add_points(rule, part.corners, shape, part.is_rough ? points : smooth,
                   part.is_rough ? weights : smooth_weights);
        visit_points(points, weights, true);
      }
    visit_points(smooth, smooth_weights, false);
  }

private:
  /** Returns the number of points per direction: for products of functions of degree two on
   * parallelograms; more where maps or the law vary, or a load that is integrated itself. */
  unsigned int n_points(const unsigned int degree, const unsigned int load_degree) const {
    const unsigned int of_fields = degree << (data_.space.mesh().has_parents() ? 1 : 0),
                       n = std::max(of_fields +
                                      (data_.scene.material->is_constant_on_cells() ? 1 : 3),
                                    (of_fields + load_degree + 1) / 2 + 1);
    if (!EquilibrationMesh::aligns(data_) && data_.scene.body_force != nullptr)
      return n + 6;
    return data_.space.mesh().is_curved() ? n + 2 : n;
  }

  const BoundData &data_;
  const Kinks<2> kinks_;
  const ExactMaps &maps_;
  CellEvaluator<2> u_;
};

/** The energies on the cells of a chunk, and the norms of π^{2h} u_h - u_h or of u_h. */
struct ChunkEnergies {
  double strain = 0.;
  std::vector<std::pair<unsigned int, double>> distances;
};

/** Returns the energies of u_h, and of the difference of the last field to u_h or of u_h, on a part
 * of a cell; from above where the law is rough. */
std::array<double, 2> energies(EnergyMeasure<2> &measure, const CellEvaluator<2> &u,
                               const unsigned int last, const bool is_rough) {
  std::array<double, 2> sums = {{0., 0.}}, largest = sums;
  double area = 0.;
  for (unsigned int q = 0; q < u.size(); ++q) {
    measure.at(u.points()[q]);
    const Tensor<2, 2> of_u = u.gradient(q);
    const std::array<Tensor<2, 2>, 2> gradients = {
      {of_u, last > 0 ? u.gradient(q, last) - of_u : of_u}};
    area += u.measure(q);
    for (unsigned int k = 0; k < 2; ++k) {
      const double density = measure.density(strain_of(gradients[k]));
      sums[k] += u.measure(q) * density;
      largest[k] = std::max(largest[k], density);
    }
  }
  for (unsigned int k = 0; k < 2 && is_rough; ++k)
    sums[k] = area * largest[k];
  return sums;
}

/** Returns u_h at a corner of the smallest cell of each body. Coordinates round hanging nodes off
 * their edges by a share of tiny cells, which leaves a force there: as the translation c, this u_h
 * gives it no work. */
std::vector<Tensor<1, 2>> displacements_of_smallest_cells(const BoundData &data) {
  const Geometry<2> &geometry = data.scene.geometry;
  std::vector<Tensor<1, 2>> displacements(geometry.n_bodies());
  std::vector<int> levels(displacements.size(), -1);
  for (const auto &cell : data.space.dofs().active_cell_iterators())
    if (const unsigned int body = geometry.body_of(cell); cell->level() > levels[body]) {
      levels[body] = cell->level();
      displacements[body] = CellField(cell, data.U).on_face(0, 0.);
    }
  return displacements;
}
} // namespace

EnergyMisfit::EnergyMisfit(const BoundData &data)
  : data_(data)
  , maps_(data.space.mesh(), data.scene.geometry.sides)
  , translations_(displacements_of_smallest_cells(data))
  , lift_(data)
  , distances_(data.space.mesh().triangulation().n_active_cells()) {
  integrate_energies();
  double square = 0.;
  lift_.visit_cells(data, maps_, [&](const LiftedCell &lifted) {
    square += lifted.energy();
    for (unsigned int q = 0; q < lifted.u.size(); ++q)
      strain_ += lifted.points[q].weight *
                 ((components_of(strain_of(lifted.u.gradient(q))) * 2. + lifted.points[q].strain) *
                  lifted.points[q].stress);
  });
  lift_norm_ = std::sqrt(square);
}

void EnergyMisfit::integrate_energies() {
  const unsigned int last = static_cast<unsigned int>(fields_of(data_).size()) - 1;
  integrate_by_chunks<ChunkEnergies, 2>(
    data_.space,
    [&](const Cells<2> &cells) {
      PartVisitor visit(data_, data_.scene.law_kinks, maps_);
      EnergyMeasure<2> measure(data_.scene);
      ChunkEnergies chunk;
      for (const auto &cell : cells) {
        double distance = 0.;
        visit(cell, 0, [&](const CellEvaluator<2> &u, const bool is_rough) {
          const auto [of_u, difference] = energies(measure, u, last, is_rough);
          chunk.strain += of_u;
          distance += difference;
        });
        chunk.distances.emplace_back(cell->active_cell_index(), std::sqrt(distance));
      }
      return chunk;
    },
    [this](const ChunkEnergies &chunk) {
      strain_ += chunk.strain;
      for (const auto &[cell, distance] : chunk.distances)
        distances_[cell] = distance;
    });
  const MPI_Comm communicator = data_.space.mesh().communicator();
  strain_ = Utilities::MPI::sum(strain_, communicator);
  Utilities::MPI::sum(distances_, communicator, distances_);
}

std::vector<Tensor<1, 2>> EnergyMisfit::force(const EquilibrationMesh &mesh,
                                              const EquilibratedStress &stress, const Cell &cell,
                                              const std::vector<Point<2>> &points) const {
  if (is_aligned()) {
    const unsigned int number = mesh.find(cell)->active_cell_index();
    return stress.fits[number].force(stress.tractions.space.cells()[number], points);
  }
  std::vector<Tensor<1, 2>> f;
  dealii::Vector<double> value(2);
  for (const Point<2> &x : points) {
    data_.scene.body_force->vector_value(x, value);
    f.push_back(Tensor<1, 2>({value[0], value[1]}));
  }
  return f;
}

EnergyMisfit::Works EnergyMisfit::works(const EquilibrationMesh &mesh,
                                        const EquilibratedStress &stress) const {
  const dealii::Vector<double> none(stress.tractions.x.size());
  Works works = {0., none, none};
  if (data_.scene.body_force != nullptr)
    add_load_works(mesh, stress, works);
  add_moments(stress.tractions.space, works);
  add_pair_moments(stress.tractions.space, works);
  return works;
}

void EnergyMisfit::add_load_works(const EquilibrationMesh &mesh, const EquilibratedStress &stress,
                                  Works &works) const {
  const Kinks<2> none;
  integrate_by_chunks<double, 2>(
    data_.space,
    [&](const Cells<2> &cells) {
      // f_K is smooth in cells of u_h, but may have a higher degree than the fields.
      const Kinks<2> &kinks = is_aligned() ? none : data_.scene.kinks;
      PartVisitor visit(data_, kinks, maps_);
      double sum = 0.;
      for (const auto &cell : cells) {
        const unsigned int degree =
          is_aligned() ? stress.fits[mesh.find(cell)->active_cell_index()].load_degree() : 0;
        visit(cell, degree, [&](const CellEvaluator<2> &u, bool) {
          const auto f = force(mesh, stress, cell, u.points());
          for (unsigned int q = 0; q < u.size(); ++q)
            sum += u.measure(q) * (f[q] * (u.value(q) - translation_of(cell)));
        });
      }
      return sum;
    },
    [&works](const double sum) { works.load += sum; });
  works.load = Utilities::MPI::sum(works.load, data_.space.mesh().communicator());
  lift_.visit_cells(data_, maps_, [&](const LiftedCell &lifted) {
    const auto f = force(mesh, stress, lifted.u.cell(), lifted.u.points());
    for (std::size_t q = 0; q < f.size(); ++q)
      works.load += lifted.points[q].weight * (f[q] * lifted.points[q].z);
  });
}

void EnergyMisfit::add_moments(const TractionSpace &space, Works &works) const {
  // Arcs take more points than segments, on which the integrands are polynomials. Points are those
  // of the edge itself: rounding of maps would leave a force on small cells, which does work on c.
  const unsigned int more = data_.space.mesh().is_curved() ? 15 : 7;
  dealii::Vector<double> given(2);
  for (const auto &cell : data_.space.dofs().active_cell_iterators())
    for (unsigned int side = 0; side < 4; ++side) {
      const unsigned int f = face_in_circle[side];
      if (!cell->at_boundary(f))
        continue;
      const CellField u(cell, data_.U);
      const Side<2> face("", shape_of(cell, data_.scene.geometry.sides).edge(side));
      const Quadrature<1> rule = split_quadrature(QGauss<1>(u.degree() + more),
                                                  data_.scene.kinks.cut(face, 0., face.length()));
      const BoundaryCondition<2> &condition = data_.scene.boundary[cell->face(f)->boundary_id()];
      const TractionEdge &edge = space.edges()[space.edge_at(cell, f)];
      for (unsigned int q = 0; q < rule.size(); ++q) {
        const double length = rule.point(q)[0], share = length / face.length(),
                     s = side < 2 ? share : 1. - share, weight = rule.weight(q);
        const Point<2> x = face.point(length);
        const Tensor<1, 2> t = face.tangent(length, 0.), n({t[1], -t[0]});
        const auto L = legendre_values(edge.degree, edge.position_of(x));
        Tensor<1, 2> v = u.on_face(f, s) - translation_of(cell);
        if (condition.role == Role::displacement || condition.role == Role::traction)
          condition.data->vector_value(x, given);
        if (condition.role == Role::displacement)
          v = Tensor<1, 2>({given[0], given[1]}) - translation_of(cell);
        // Tractions that are given on arcs are no coefficients.
        if (condition.role == Role::traction && !edge.line.is_flat())
          works.load += weight * (given[0] * v[0] + given[1] * v[1]);
        for (unsigned int i = 0; i <= edge.degree; ++i)
          for (unsigned int c = 0; c < 2; ++c)
            works.moments[edge.position(c, i)] += weight * L[i] * edge.axis(c, n) * v;
      }
    }
}

void EnergyMisfit::add_pair_moments(const TractionSpace &space, Works &works) const {
  constexpr unsigned int n_points = 8;
  const ContactSurface<2> &surface = data_.multipliers.surface();
  for (const Piece<2> &piece : surface.pieces()) {
    const CarriedPiece carried = seen_from_carrier(surface, piece);
    if (!carried.other)
      continue;
    const ContactFace<2> &carrier = surface.faces()[carried.own.face];
    const TractionEdge &edge = space.edges()[space.contact_edge_at(carrier.cell, carrier.face_no)];
    const SurfaceRule<2> rule = surface.rule(piece, n_points);
    for (const auto &[face, points, sign] : surface.faces_at(piece, rule)) {
      const CellField u(data_.space.dof_cell(face.cell), data_.U);
      for (std::size_t q = 0; q < rule.size(); ++q) {
        const auto L = legendre_values(edge.degree, edge.position_of(rule.points[q]));
        const double s = points[q][0];
        const Tensor<1, 2> v = u.on_face(face.face_no, s) - translation_of(face.cell);
        for (unsigned int c = 0; c < 2; ++c)
          for (unsigned int i = 0; i <= edge.degree; ++i) {
            const Tensor<1, 2> traction = sign * rule.weights[q] * L[i] *
                                          direction_of(contact_components[c], rule.directions[q]);
            works.moments[edge.position(c, i)] += traction * v;
            works.translated[edge.position(c, i)] += traction * translation_of(face.cell);
          }
      }
    }
  }
}

double EnergyMisfit::expected(const EquilibratedStress & /*stress*/) const {
  if (!data_.space.mesh().has_parents())
    return std::numeric_limits<double>::infinity();
  // Where cells of u_h are no parts of cells of the stress, osc_K counts with |||u_h|||_K.
  const double distance = distances_.l2_norm();
  return 0.03 * distance * (is_aligned() ? 1. : 5. * distance / std::sqrt(strain_));
}

EnergyMisfit::Square EnergyMisfit::square(const EquilibratedStress &stress,
                                          const Works &works) const {
  const double strain = strain_ + stress.distance_square(), load = works.load;
  double value = strain - 2. * load, size = strain + 2. * std::abs(load);
  for (const TractionEdge &edge : stress.tractions.space.edges())
    for (unsigned int i = edge.first; i < edge.first + edge.n_coefficients() && !edge.is_shared;
         ++i) {
      const double work = 2. * works.moments[i] * stress.tractions.x[i];
      value -= work;
      size += std::abs(work);
    }
  // The terms cancel, up to that, rounding and the residual forces of cells.
  return {value, (1e-14 + stress.defect) * size};
}

double EnergyMisfit::load_square(const EquilibratedStress &stress) const {
  double square = 0.;
  for (std::size_t c = 0; c < stress.fits.size() && !is_aligned(); ++c)
    square += std::pow(stress.load_oscillation(c), 2);
  return square;
}

double EnergyMisfit::load_term(const EquilibratedStress &stress) const {
  return 2. * std::sqrt(load_square(stress) * strain_);
}

double EnergyMisfit::distance(const EquilibratedStress &stress, const Works &works) const {
  const double oscillation = load_term(stress);
  const auto [value, rounding] = square(stress, works);
  constexpr double most = 100.;
  if (!(value >= -most * rounding - oscillation))
    return std::numeric_limits<double>::infinity();
  return std::sqrt(std::max(0., value) + rounding + oscillation);
}

double EnergyMisfit::allowed_load(const EquilibratedStress &stress, const Works &works) const {
  if (is_aligned())
    return distance(stress, works);
  const auto [value, rounding] = square(stress, works);
  return 0.5 * std::max(value, rounding) / std::sqrt(strain_);
}

Bracket EnergyMisfit::complementary_energy(const EquilibratedStress &stress,
                                           const Works &works) const {
  // 1/2 ‖τ‖² less the work of the tractions that are not given.
  const auto &x = stress.tractions.x;
  double work = 0.;
  for (std::size_t e = 0; e < stress.tractions.space.edges().size(); ++e) {
    const TractionEdge &edge = stress.tractions.space.edges()[e];
    if (edge.side == TractionEdge::no_side ||
        data_.scene.boundary[edge.side].role == Role::traction ||
        !stress.tractions.space.shared_parts(e).empty())
      continue;
    for (unsigned int i = edge.first; i < edge.first + edge.n_coefficients(); ++i)
      work += x[i] * (works.moments[i] + works.translated[i]);
    // Shared tractions push both bodies: a translation of both would do no work.
    if (edge.is_shared)
      continue;
    const auto forces = edge.resultants(data_.scene.geometry, {});
    const Tensor<1, 2> &c = translations_[data_.scene.geometry.body_of_side(edge.side)];
    for (std::size_t i = 0; i < forces.size(); ++i)
      work += x[edge.first + i] * (forces[i][0] * c[0] + forces[i][1] * c[1]);
  }
  Bracket energy = {-work, -work};
  for (std::size_t c = 0; c < stress.fits.size(); ++c) {
    const double norm = stress.distance(c), rest = stress.oscillation(c);
    energy.lower += 0.5 * std::pow(std::max(0., norm - rest), 2);
    energy.upper += 0.5 * std::pow(norm + rest, 2);
  }
  return energy;
}

std::vector<double> EnergyMisfit::oscillations_by_cell(const EquilibratedStress &stress) const {
  // Σ osc_K²/(Σ osc_K²)^{1/2} is the term that f instead of f_K adds.
  const double factor = load_term(stress) > 0. ? load_term(stress) / load_square(stress) : 0.;
  std::map<CellId, double> squares;
  for (std::size_t c = 0; c < stress.fits.size(); ++c)
    squares[stress.fits[c].id] =
      std::pow(stress.oscillation(c), 2) + factor * std::pow(stress.load_oscillation(c), 2);
  std::vector<double> oscillations;
  for (const auto &cell : data_.space.mesh().triangulation().active_cell_iterators())
    oscillations.push_back(std::sqrt(squares.at(cell->id())));
  return oscillations;
}

StressBound EnergyMisfit::bound(const EquilibratedStress &stress, const Works &works) const {
  const double mesh = distance(stress, works), rest = std::sqrt(stress.oscillation_square());
  StressBound result;
  result.energy_norm = std::sqrt(strain_);
  result.lift_misfit = lift_.max_misfit();
  result.lift = lift_norm_;
  result.square = std::pow(mesh + rest, 2);
  result.oscillation_square = rest * rest;
  result.complementary_energy = complementary_energy(stress, works);
  const double whole = distances_.l2_norm();
  for (const double norm : distances_) {
    const double share = whole > 0. ? norm / whole : 1. / std::sqrt(distances_.size());
    result.misfit.push_back(share * mesh);
    result.oscillation.push_back(share * rest);
  }
  if (data_.space.mesh().is_graded())
    result.oscillation = oscillations_by_cell(stress);
  return result;
}
} // namespace Signorini
