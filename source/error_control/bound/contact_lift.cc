// SPDX-License-Identifier: LGPL-2.1-or-later
// The contact part of the bound: the lift in the body, its energy, and the sum.

#include <signorini/discretization/mesh/cut_quadrature.h>
#include <signorini/discretization/space/body_measure.h>
#include <signorini/discretization/space/cell_values.h>
#include <signorini/discretization/space/internal_forces.h>
#include <signorini/error_control/bound/contact_lift.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_nothing.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <sstream>

namespace Signorini {
namespace {
/** Returns a function less the linear one with these values at 0 and 1. */
EdgeFunction without_chord(const EdgeFunction &function, const double first, const double last) {
  std::vector<EdgeFunction::Part> parts = function.parts();
  for (EdgeFunction::Part &part : parts) {
    part.first -= (1. - part.start) * first + part.start * last;
    part.last -= (1. - part.end) * first + part.end * last;
  }
  return EdgeFunction(std::move(parts));
}

/** Returns the remainder r_F of a face from the deficit q - w_{h,n}: all of it where the
 * face presses and w_h touches at both ends. */
EdgeFunction remainder(const PenetrationFace &face, const EdgeFunction &deficit,
                       const double rounding) {
  const bool presses = face.presses_everywhere();
  double first = deficit.value(0.), last = deficit.value(1.), size = 0.;
  for (const EdgeFunction::Part &lack : deficit.parts())
    size = std::max({size, std::abs(lack.first), std::abs(lack.bubble)});
  // r_F leaves out the linear function between the deficits at the ends, on which the pressure then
  // works. Where it is below a tenth of the deficit, r_F keeps it: its energy is less than that
  // work.
  const bool follows =
    presses && std::max(std::abs(first), std::abs(last)) < std::max(0.1 * size, rounding);
  if (follows)
    first = last = 0.;
  std::vector<EdgeFunction::Part> parts = without_chord(deficit, first, last).parts();
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const EdgeFunction::Part &lack = deficit.parts()[i];
    EdgeFunction::Part &r = parts[i];
    const bool rises = r.largest() > 0.;
    const auto at_end = [&](const double missing, const double bowed) {
      return std::max(missing, presses ? std::min(0., bowed) : 0.);
    };
    r.first = at_end(lack.first, r.first);
    r.last = at_end(lack.last, r.last);
    // The least bubble with r above the deficit: A (1 - τ) + B τ ≥ 4 b τ (1 - τ) for τ in [0,1]
    // holds if 4 b ≤ (√A + √B)².
    if (!presses || (!follows && rises))
      r.bubble = std::max(
        0., lack.bubble -
              0.25 * std::pow(std::sqrt(r.first - lack.first) + std::sqrt(r.last - lack.last), 2));
  }
  // These are zero, up to rounding.
  parts.front().first = parts.back().last = 0.;
  return EdgeFunction(std::move(parts));
}

/** Returns deficit - r; r has the same parts, or none. */
EdgeFunction difference(const EdgeFunction &deficit, const EdgeFunction &r) {
  std::vector<EdgeFunction::Part> parts = deficit.parts();
  for (std::size_t i = 0; i < r.parts().size(); ++i) {
    parts[i].first -= r.parts()[i].first;
    parts[i].last -= r.parts()[i].last;
    parts[i].bubble -= r.parts()[i].bubble;
  }
  return EdgeFunction(std::move(parts));
}

/** The normal and the tangential part of q - w_h on a face, and the part r_F of it that is lifted;
 * term() is the work on the rest. */
struct FaceLift {
  FaceLift(const BoundData &data, const ContactTrace &trace, const PenetrationFace &face,
           const std::vector<FaceVector> &w)
    : n_components(!face.is_contact()           ? 0
                   : data.has_tangential_part() ? 2
                                                : 1)
    , w(w) {
    if (n_components == 0)
      return;
    for (unsigned int c = 0; c < n_components; ++c)
      deficit[c] = trace.deficit(face, contact_components[c], w);
    r[0] = remainder(face, deficit[0], trace.rounding(face));
    if (face.lifts_slip)
      r[1] = without_chord(deficit[1], deficit[1].value(0.), deficit[1].value(1.));
  }
  /** Returns ∫_F τ_n (ũ_n - g - w_n) (component 0), or ∫_F s |v| + τ_t v. */
  double term(const ContactTrace &trace, const PenetrationFace &face, const unsigned int c) const {
    // Where the face presses, w_n is d itself, raised by r - deficit; r stands for its difference
    // from w_h there. Where friction holds the face, w_t is the slip itself. Values below rounding
    // are dropped: the bound takes the root of this term, and the root of 1e-16 would be seen.
    const bool follows = c == 0 ? face.presses_everywhere() : face.lifts_slip;
    const double rounding = trace.rounding(face);
    double term = 0.;
    // The parts are those of d and p_H, and those of w_n; those of v between its roots.
    face.for_each_point(c == 0 ? r[0] : difference(deficit[1], r[1]).split_at_roots(),
                        [&](const double t, const double weight) {
                          const double missing =
                                         follows
                                           ? deficit[c].value(t)
                                           : trace.misfit(face, contact_components[c], t) -
                                               trace.closing(face, contact_components[c], t, w),
                                       v = missing - r[c].value(t);
                          if (std::abs(v) > rounding)
                            term += ((c == 1 ? trace.tangential_bound(face, t) * std::abs(v) : 0.) +
                                     face.traction_at(c, t) * v) *
                                    weight;
                        });
    return term;
  }

  unsigned int n_components;
  const std::vector<FaceVector> &w;
  std::array<EdgeFunction, 2> deficit;
  Remainders r;
};

/** Sums up. */
ContactBound evaluate(const BoundData &data, const ContactTrace &trace, const LiftField &lift,
                      const std::vector<FaceLift> &on_faces) {
  ContactBound bound;
  bound.cell_energies = lift.cell_energies();
  const MPI_Comm communicator = data.space.mesh().communicator();
  bound.lift_energy = Utilities::MPI::sum(bound.cell_energies.l1_norm(), communicator);
  // A w_h acts at contact nodes only: its work there is |||w_h|||², however far from contact that
  // is.
  const DualVector forces =
    internal_forces(DisplacedBody(data.space, data.scene, lift.w_h())).forces;
  double largest = 0.;
  for (unsigned int i = 0; i < trace.faces().size(); ++i) {
    const PenetrationFace &face = trace.faces()[i];
    double term = 0., work = 0.;
    for (std::size_t k = 0; k < face.dofs.size(); ++k)
      for (const types::global_dof_index dof : face.dofs[k])
        work += (k < 2 ? 0.5 : 1.) * lift.w_h()[dof] * forces[dof];
    for (unsigned int c = 0; c < on_faces[i].n_components; ++c)
      term += on_faces[i].term(trace, face, c);
    bound.contact_term += term;
    bound.face_terms.push_back(2. * term);
    const auto cell = trace.surface().faces()[i].cell;
    const double part =
      2. * term + work +
      Utilities::MPI::sum(bound.cell_energies[cell->active_cell_index()], communicator);
    if (i == 0 || part > largest) {
      largest = part;
      bound.dominant_part = trace.side_point(face, 0.5);
    }
  }
  return bound;
}
} // namespace

ContactLift::ContactLift(const BoundData &data, const std::vector<FaceTractions> &tractions)
  : trace(data, tractions) {
  if (trace.obstacle()) {
    no_bound =
      "u_n - g > 0 where the contact side meets a side that holds the body: no displacement "
      "of finite energy removes the penetration, on " +
      name_of(*trace.obstacle(), data.scene);
    return;
  }
  std::optional<Displacement> w_h = nodal_lift(data, trace);
  if (!w_h) {
    no_bound = "contact sides meet in a corner that is too sharp";
    return;
  }
  const std::vector<FaceVector> w = trace.traces(*w_h);
  std::vector<FaceLift> on_faces;
  std::vector<Remainders> remainders;
  for (const PenetrationFace &face : trace.faces()) {
    on_faces.emplace_back(data, trace, face, w);
    remainders.push_back(on_faces.back().r);
    // r_F m would jump.
    if (face.mixes() && !(remainders.back()[0].is_zero() && remainders.back()[1].is_zero())) {
      no_bound = "the body presses where another plane becomes the nearest one, on " +
                 name_of(trace.side_point(face, 0.5), data.scene);
      return;
    }
  }
  bound =
    evaluate(data, trace, LiftField(data, trace, std::move(*w_h), std::move(remainders)), on_faces);
}

namespace {
/** Returns the modulus in r² of a displacement along m (component 0) or its tangent divided by that
 * in r'²: C_nn/C_nt or C_nt/C_tt where m = n. */
double ratio_of_moduli(const Scene<2> &scene, const PenetrationFace &face,
                       const unsigned int component) {
  const auto C = scene.material->hooke(face.point(0.5));
  const Tensor<1, 2> n = face.normal, t = direction_of(Component::tangential, n),
                     along = face.direction(contact_components[component], 0.5);
  const auto across = symmetrize(outer_product(along, n)),
             lengthwise = symmetrize(outer_product(along, t));
  return (across * (C * across)) / (lengthwise * (C * lengthwise));
}
} // namespace

LiftField::LiftField(const BoundData &data, const ContactTrace &trace, Displacement w_h,
                     std::vector<Remainders> remainders)
  : data_(data)
  , trace_(trace)
  , maps_(data.space.mesh(), data.scene.geometry.sides)
  , w_h_(std::move(w_h))
  , remainders_(std::move(remainders)) {
  for (unsigned int i = 0; i < remainders_.size(); ++i)
    for (unsigned int c = 0; c < 2; ++c)
      if (const EdgeFunction &r = remainders_[i][c]; !r.is_zero()) {
        const auto &cell = trace.surface().faces()[i].cell;
        const unsigned int face_no = trace.surface().faces()[i].face_no;
        const PenetrationFace &face = trace.faces()[i];
        const double height = cell->face(face_no)->center().distance(
          cell->face(GeometryInfo<2>::opposite_face[face_no])->center());
        const double depth = face.length() * std::sqrt(3. * ratio_of_moduli(data.scene, face, c) *
                                                       r.square_integral() / r.slope_integral());
        columns_.emplace(cell->active_cell_index(),
                         Column{i, face_no, c, std::min(1., depth / height)});
      }
}

std::vector<double> LiftField::cuts(const CellIterator &cell, const unsigned int d,
                                    const unsigned int n_equal) const {
  std::vector<double> cuts;
  for (unsigned int i = 0; i <= n_equal; ++i)
    cuts.push_back(static_cast<double>(i) / n_equal);
  const auto [begin, end] = columns_.equal_range(cell->active_cell_index());
  for (auto entry = begin; entry != end; ++entry)
    if (const auto &[face, face_no, component, depth] = entry->second; face_no / 2 == d)
      cuts.push_back(face_no % 2 == 0 ? depth : 1. - depth);
    else
      for (const EdgeFunction::Part &part : remainders_[face][component].parts())
        cuts.push_back(part.end);
  for (const unsigned int edge : {0, 1}) {
    // Edges 2 and 3 run along x, edges 0 and 1 along y.
    const auto line = cell->face(2 * (1 - d) + edge);
    const auto crossings = data_.scene.law_kinks.cut(line->vertex(0), line->vertex(1));
    cuts.insert(cuts.end(), crossings.begin(), crossings.end());
  }
  std::sort(cuts.begin(), cuts.end());
  cuts.erase(std::unique(cuts.begin(), cuts.end(),
                         [](const double a, const double b) { return b - a < 1e-13; }),
             cuts.end());
  return cuts;
}

double LiftField::energy(const CellIterator &cell, TabulatedRule &rule,
                         const std::vector<Point<2>> &map_nodes) const {
  // Sums over the nodes of the map in one direction after the other are faster than FEValues, which
  // tabulates maps for each rule.
  std::vector<Tensor<1, 2>> from_first;
  for (const Point<2> &x : map_nodes)
    from_first.push_back(x - map_nodes[0]);
  const FieldValues<2> map = rule.evaluate(CellField(maps_.degree(), from_first));
  std::vector<Tensor<2, 2>> gradients = rule.evaluate(CellField(cell, w_h_)).gradients, inverse;
  for (std::size_t q = 0; q < gradients.size(); ++q) {
    inverse.push_back(invert(map.gradients[q]));
    gradients[q] = gradients[q] * inverse[q];
  }
  const auto [begin, end] = columns_.equal_range(cell->active_cell_index());
  for (std::size_t q = 0; q < gradients.size(); ++q) {
    const Point<2> &x = rule.rule().point(q);
    for (auto entry = begin; entry != end; ++entry) {
      const auto &[face, face_no, component, depth] = entry->second;
      const unsigned int across = face_no / 2;
      const bool from_above = face_no % 2 == 1;
      const double psi = 1. - (from_above ? 1. - x[across] : x[across]) / depth;
      const EdgeFunction &r = remainders_[face][component];
      const double t = x[1 - across], value = r.value(t);
      Tensor<1, 2> gradient, along;
      gradient[across] = (from_above ? 1. : -1.) / depth * value;
      gradient[1 - across] = psi * r.slope(t);
      along[1 - across] = psi * value;
      const PenetrationFace &on = trace_.faces()[face];
      if (psi > 0.)
        gradients[q] += (outer_product(on.direction(contact_components[component], t), gradient) +
                         outer_product(on.turning(contact_components[component], t), along)) *
                        inverse[q];
    }
  }
  EnergyMeasure<2> measure(data_.scene);
  double sum = 0.;
  for (std::size_t q = 0; q < gradients.size(); ++q)
    sum += measure.at(map_nodes[0] + map.values[q]).density(strain_of(gradients[q])) *
           rule.rule().weight(q) * determinant(map.gradients[q]);
  return sum;
}

bool LiftField::needs_equal_parts(const CellIterator &cell) const {
  const Kinks<2> &kinks = data_.scene.law_kinks;
  const auto is_oblique = [&](const KinkLine<2> &line) {
    if (!crosses<2>(line, cell))
      return false;
    if (data_.space.mesh().is_curved())
      return true;
    std::array<double, 4> d;
    for (const unsigned int v : cell->vertex_indices())
      d[v] = line.signed_distance(cell->vertex(v));
    // The distance is bilinear. It vanishes on a coordinate line where it is a product of functions
    // of one coordinate each.
    const auto [lowest, highest] = std::minmax_element(d.begin(), d.end());
    return std::abs(d[0] * d[3] - d[1] * d[2]) > 1e-12 * std::pow(*highest - *lowest, 2);
  };
  return kinks.boxes().divides(cell->bounding_box()) ||
         std::any_of(kinks.lines().begin(), kinks.lines().end(), is_oblique);
}

dealii::Vector<double> LiftField::cell_energies() const {
  const bool constant = data_.scene.material->is_constant_on_cells();
  const std::size_t n_cells = data_.space.mesh().triangulation().n_active_cells();
  const auto n_equal_parts = [&](const CellIterator &cell) {
    if (!needs_equal_parts(cell))
      return 1U;
    // Boxes of the law are hardly smaller.
    constexpr double smallest = 1. / 512.;
    const double n = cell->diameter() / (smallest * data_.scene.geometry.diameter());
    return static_cast<unsigned int>(std::clamp(n, 1., 24.));
  };
  // Products of derivatives of w_h, or of r_F, which has the degree two; more where E or maps vary.
  const auto n_points = [&](const unsigned int degree, const bool is_cut) {
    return (constant ? std::max(is_cut ? 2U : 1U, degree) + 1 : degree + 3) +
           (data_.space.mesh().is_curved() ? 3 : 0);
  };
  // The rules of cells that are not cut, by degree; that of the last one that is cut.
  std::map<unsigned int, std::unique_ptr<TabulatedRule>> rules;
  const FE_Nothing<2> no_functions;
  ValuesCache<2> nodes(update_quadrature_points,
                       [](const unsigned int degree) { return QGaussLobatto<2>(degree + 1); });
  dealii::Vector<double> energies(n_cells), nodal;
  for (const auto &cell : data_.space.dofs().active_cell_iterators()) {
    if (!cell->is_locally_owned())
      continue;
    nodal.reinit(cell->get_fe().n_dofs_per_cell());
    cell->get_dof_values(w_h_, nodal);
    const bool has_column = columns_.count(cell->active_cell_index()) > 0;
    if (nodal.all_zero() && !has_column)
      continue;
    unsigned int n_equal = 1;
    std::vector<double> x = {0., 1.}, y = x;
    if (has_column || needs_cuts<2>(data_.scene.law_kinks, cell)) {
      n_equal = n_equal_parts(cell);
      x = cuts(cell, 0, n_equal);
      y = cuts(cell, 1, n_equal);
    }
    const bool is_cut = x.size() > 2 || y.size() > 2;
    const unsigned int degree = cell->get_fe().degree;
    std::unique_ptr<TabulatedRule> &rule = rules[is_cut ? 0 : degree];
    if (is_cut || rule == nullptr) {
      // On parts of half the size, one point less has the same effect.
      constexpr int least = 6;
      const int n_gauss = n_points(degree, is_cut);
      const QGauss<1> gauss(std::max(std::min(least, n_gauss), n_gauss - std::ilogb(n_equal)));
      rule = std::make_unique<TabulatedRule>(
        QAnisotropic<2>(split_quadrature(gauss, x), split_quadrature(gauss, y)));
    }
    const FEValues<2> &map = nodes.reinit(maps_.of(cell), no_functions, maps_.degree(),
                                          Triangulation<2>::cell_iterator(cell));
    energies[cell->active_cell_index()] = energy(cell, *rule, map.get_quadrature_points());
  }
  return energies;
}
} // namespace Signorini
