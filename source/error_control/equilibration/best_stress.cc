// SPDX-License-Identifier: LGPL-2.1-or-later
// The steps of the best stress, and the sums of its bound.

#include <signorini/base/parallel.h>
#include <signorini/error_control/equilibration/best_stress.h>
#include <signorini/error_control/loads/oscillation.h>
#include <signorini/problem/scene/corners.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Signorini {
namespace {
/** What may be lacking, relative to the largest trace. */
constexpr double largest_lacking = 1e-9;
} // namespace

std::string BestStress::objection(const BoundData &data) {
  if (data.space.mesh().is_curved() && data.space.mesh().is_graded())
    return "the mesh is graded, and sides are curved";
  if (data.space.strain_operator() != StrainOperator::symmetric_gradient &&
      data.space.max_element_degree() > 1)
    return "the strain is that of B-bar, with elements of a degree above one";
  return find_contradiction(data.scene);
}

BestStress::BestStress(const BoundData &data)
  : data_(data)
  , stress_mesh_(data_)
  , fitter_(data_)
  , lift_(lift_of(data_))
  , lift_norms_(stress_mesh_.is_own() ? Vector() : add_lift(data_, lift_, 0, {}, nullptr)) {
  bool is_balanced = true;
  do {
    set_up();
    do {
      lacking_ = minimise(*mesh_, fits_, conditions_,
                          fields_ ? fields_->u_h.moments : Vector(x_.size()), x_);
      is_balanced = lacking_ <= largest_lacking;
    } while (is_balanced && fix_pulling_edges());
  } while (is_balanced && resolve_loads(total_misfit(), true));
  if (!is_balanced)
    failure_ =
      "no stress in equilibrium was found: the tractions of the contact sides cannot carry "
      "the loads, or rounding";
}

double BestStress::likely_misfit() const {
  if (!fields_) {
    double square = 0.;
    for (const CellFit &fit : fits_)
      square += std::pow(fit.size * fit.rest, 2);
    return std::sqrt(square);
  }
  if (!data_.space.mesh().has_parents())
    return std::numeric_limits<double>::infinity();
  // Where cells of u_h are no parts of cells of the stress, osc_K counts with |||u_h|||_K.
  const double distance = fields_->distances.l2_norm();
  return 0.03 * distance *
         (stress_mesh_.is_aligned() ? 1. : 5. * distance / std::sqrt(fields_->u_h.strain));
}

void BestStress::set_up() {
  const bool is_own = stress_mesh_.is_own();
  bool has_integrals = false;
  do {
    prepare_mesh();
    // The distance of u_h to π^{2h} u_h, which the loads are compared with, is the same on all
    // meshes.
    has_integrals = is_own && !fields_;
    if (has_integrals)
      integrate_u();
  } while (resolve_friction() ||
           resolve_loads(likely_misfit(), !is_own || !stress_mesh_.is_aligned()));
  if (is_own && !has_integrals)
    integrate_u();
}

void BestStress::prepare_mesh() {
  mesh_.emplace(stress_mesh_, data_.scene);
  cells_.clear();
  for (const auto &cell : stress_mesh_.triangulation().active_cell_iterators())
    cells_.push_back(cell);
  x_.reinit(mesh_->n_coefficients());
  give_tractions();
  give_contact();
  conditions_.clear();
  add_plate_conditions();
  fit_cells();
  for (TractionCondition &condition : conditions_)
    condition.weight = penalty_of(fits_[0]) * fits_[0].size * fits_[0].size * condition.row.size();
}

void BestStress::fit_cells() {
  std::map<CellId, CellFit> known;
  for (std::size_t cell = 0; cell < fits_.size(); ++cell)
    known.emplace(fitted_[cell], std::move(fits_[cell]));
  fits_ = std::vector<CellFit>(cells_.size());
  fitted_.clear();
  std::vector<std::size_t> fresh;
  for (std::size_t cell = 0; cell < cells_.size(); ++cell) {
    fitted_.push_back(cells_[cell]->id());
    const auto found = known.find(fitted_.back());
    if (found != known.end() && found->second.airy->degree() == mesh_->cells()[cell].degree)
      fits_[cell] = found->second;
    else
      fresh.push_back(cell);
  }
  const auto fit = [&](CellFitter &fitter, const std::size_t begin, const std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      fits_[fresh[i]] =
        fitter.fit(cells_[fresh[i]], mesh_->cells()[fresh[i]], !stress_mesh_.is_own());
  };
  if (data_.scene.material->is_constant())
    return fit(fitter_, 0, fresh.size());
  // Without classes of cells that share what they know, threads do not meet.
  work_on_ranges(n_available_threads(data_.space.mesh().communicator()), fresh.size(),
                 [&](const std::size_t begin, const std::size_t end) {
                   CellFitter fitter(data_);
                   fit(fitter, begin, end);
                 });
}

void BestStress::integrate_u() {
  CellForce force;
  if (data_.scene.body_force != nullptr)
    force = [this](const auto &cell, const std::vector<Point<2>> &points) {
      std::vector<Tensor<1, 2>> f;
      if (!stress_mesh_.is_aligned()) {
        dealii::Vector<double> value(2);
        for (const Point<2> &x : points) {
          data_.scene.body_force->vector_value(x, value);
          f.push_back(Tensor<1, 2>({value[0], value[1]}));
        }
        return f;
      }
      const unsigned int number = stress_mesh_.find(cell)->active_cell_index();
      const CellFit &fit = fits_[number];
      const CellShape shape(mesh_->cells()[number].corners);
      for (const Point<2> &x : points)
        f.push_back(
          fit.airy->value(fit.load, fit.airy->on_diagonals((x - shape.crossing) / fit.size)) /
          fit.size);
      return f;
    };
  const CellField u(data_.space.dofs().begin_active(), data_.U);
  fields_ = integrate_fields(data_, *mesh_, lift_, u.on_face(0, 0.), force);
}

double BestStress::misfit(const std::size_t cell) const {
  const CellFit &fit = fits_[cell];
  const Vector y = lacking_traces(mesh_->cells()[cell], fit, *mesh_, x_);
  return fit.size * std::sqrt(fit.rest * fit.rest + std::max(0., y * fit.airy->multiply(y)));
}

double BestStress::misfit_square() const {
  double square = 0.;
  for (std::size_t c = 0; c < fits_.size(); ++c)
    square += std::pow(misfit(c), 2);
  return square;
}

double BestStress::distance(const FieldIntegrals &v) const {
  auto [square, size] = v.without_stress(x_);
  const double stress = misfit_square();
  // The terms cancel, up to rounding and what cells lack of balance.
  constexpr double rounding = 1e-14;
  square = std::max(0., square + stress) + (rounding + lacking_) * (size + stress);
  // With f in place of f_K: ∫ (f - f_K).v ≤ Σ osc_K |||v|||_K.
  if (!stress_mesh_.is_aligned())
    square += 2. * total_oscillation() * std::sqrt(v.strain);
  return std::sqrt(square);
}

double BestStress::total_oscillation() const {
  double square = 0.;
  for (std::size_t c = 0; c < fits_.size(); ++c)
    square += std::pow(oscillation(c), 2);
  return std::sqrt(square);
}

double BestStress::oscillation(const std::size_t cell) const {
  const TractionCell &place = mesh_->cells()[cell];
  const CellFit &fit = fits_[cell];
  const auto has_rest = [&](const TractionSide &side) {
    return rests_[0][side.edge] + rests_[1][side.edge] > 0.;
  };
  if (fit.load_rest == 0. && std::none_of(place.sides.begin(), place.sides.end(), has_rest))
    return 0.;
  const OscillationConstants constants(CellShape(place.corners), fit.airy->degree() - 1);
  double sum = constants.body * fit.load_rest;
  for (unsigned int k = 0; k < 4; ++k)
    sum += constants.normal[k] * rests_[0][place.sides[k].edge] +
           constants.edge[k] * rests_[1][place.sides[k].edge];
  return sum / std::sqrt(fit.min_eigenvalue);
}

double BestStress::total_misfit() const {
  return fields_ ? distance(fields_->u_h) : std::sqrt(misfit_square());
}

bool BestStress::resolve_loads(const double total, const bool by_degree) {
  if (total_oscillation() <= 0.1 * total)
    return false;
  const double allowed = 0.1 * total / std::sqrt(fits_.size());
  std::vector<StressMesh::Cell> unresolved;
  for (std::size_t c = 0; c < fits_.size(); ++c)
    if (oscillation(c) >
        (fields_ ? allowed : std::max(allowed, 0.1 * fits_[c].size * fits_[c].rest)))
      unresolved.push_back(cells_[c]);
  return stress_mesh_.refine(unresolved, by_degree);
}

void BestStress::add_own(StressBound &result) const {
  const double mesh = distance(fields_->u_h), rest = total_oscillation(),
               geometry = this->geometry();
  result.square = std::pow(mesh + rest + geometry, 2);
  result.oscillation_square = rest * rest;
  result.geometry_square = geometry * geometry;
  result.complementary_energy = complementary_energy();
  const double whole = fields_->distances.l2_norm();
  for (const double norm : fields_->distances) {
    const double share = whole > 0. ? norm / whole : 1. / std::sqrt(fields_->distances.size());
    result.misfit.push_back(share * mesh);
    result.oscillation.push_back(share * rest);
  }
  if (!data_.space.mesh().has_parents() || !is_guaranteed() || data_.space.max_element_degree() > 1)
    return;
  result.interpolated_part = {std::pow(distance(fields_->post) + rest, 2), fields_->post.lift};
}

Bracket BestStress::complementary_energy() const {
  // 1/2 ‖τ‖² less the work of the tractions that are not given.
  double work = 0.;
  for (const TractionEdge &edge : mesh_->edges()) {
    if (edge.side == TractionEdge::no_side ||
        data_.scene.boundary[edge.side].role == Role::traction)
      continue;
    for (unsigned int i = edge.first; i < edge.first + edge.n_coefficients(); ++i)
      work += x_[i] * fields_->u_h.moments[i];
    const Tensor<1, 2> n = edge.normal(data_.scene.geometry), t({-n[1], n[0]});
    work += edge.length() * fields_->translation *
            (x_[edge.position(0, 0)] * n + x_[edge.position(1, 0)] * t);
  }
  Bracket energy = {-work, -work};
  for (std::size_t c = 0; c < fits_.size(); ++c) {
    const double norm = misfit(c), rest = oscillation(c);
    energy.lower += 0.5 * std::pow(std::max(0., norm - rest), 2);
    energy.upper += 0.5 * std::pow(norm + rest, 2);
  }
  return energy;
}

double BestStress::geometry() const {
  if (is_guaranteed())
    return 0.;
  const Mapping<2> &mapping = data_.space.mesh().mapping();
  FEFaceValues<2> values(mapping, data_.space.element(), QMidpoint<1>(),
                         update_gradients | update_quadrature_points);
  double square = 0.;
  std::vector<SymmetricTensor<2, 2>> strain(1);
  for (const auto &cell : data_.space.dofs().active_cell_iterators())
    for (const unsigned int f : cell->face_indices()) {
      const auto face = cell->face(f);
      if (!cell->at_boundary(f) ||
          data_.scene.boundary[face->boundary_id()].role == Role::clamped ||
          data_.scene.boundary[face->boundary_id()].role == Role::displacement)
        continue;
      values.reinit(cell, f);
      const Point<2> &middle = values.quadrature_point(0);
      const Tensor<1, 2> d = face->vertex(1) - face->vertex(0);
      const double length = d.norm(), bulge = middle.distance(face->vertex(0) + 0.5 * d) / length;
      values[FEValuesExtractors::Vector(0)].get_function_symmetric_gradients(data_.U.entries(),
                                                                             strain);
      const SymmetricTensor<4, 2> hooke = data_.scene.material->hooke(middle);
      const double turned = (Tensor<2, 2>(hooke * strain[0]) * d).norm() / length;
      square +=
        std::pow(4. * bulge * turned * turning_constant(length, cell->measure() / length), 2) /
        Law(hooke).min_eigenvalue;
    }
  return std::sqrt(square);
}

StressBound BestStress::bound() const {
  StressBound result;
  result.algebra = lacking_;
  result.lift_misfit = lift_.max_misfit();
  result.lift = fields_ ? fields_->u_h.lift : lift_norms_.l2_norm();
  if (stress_mesh_.is_own()) {
    add_own(result);
    return result;
  }
  double smallest_square = 0.;
  for (std::size_t c = 0; c < fits_.size(); ++c) {
    // The misfit is that of u_h, which is at most |||z|||_K away from that of u_h + z.
    const double mesh = misfit(c), rest = oscillation(c) + lift_norms_[c];
    result.misfit.push_back(mesh);
    result.oscillation.push_back(rest);
    result.square += std::pow(mesh + rest, 2);
    result.oscillation_square += rest * rest;
    smallest_square += std::pow(std::max(0., mesh - rest), 2);
  }
  // With η² = 2 J(u_h) + 2 J*(τ) - 2 ∫ τ_n d, J* loses no digits. J(u_h) must be that of a function
  // with the boundary values of u, under loads that are resolved.
  if (result.lift <= 1e-10 * energy_norm() && result.oscillation_square <= 0.01 * result.square)
    result.complementary_energy = {0.5 * smallest_square - data_.energy,
                                   0.5 * result.square - data_.energy};
  return result;
}
} // namespace Signorini
