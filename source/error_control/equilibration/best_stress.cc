// SPDX-License-Identifier: LGPL-2.1-or-later
// The global minimisation over tractions on edges.

#include <signorini/error_control/equilibration/best_stress.h>
#include <signorini/error_control/hp/indicators.h>
#include <signorini/error_control/loads/oscillation.h>
#include <signorini/postprocessing/fields/forces.h>
#include <signorini/problem/scene/corners.h>
#include <signorini/solvers/stiffness/condensed_inverse.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparse_matrix.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace Signorini {
namespace {
/** The weight of the squares of what cells lack in balance, relative to their energies. */
constexpr double penalty = 1e6;
/** What may be lacking, relative to the largest trace. */
constexpr double tolerance = 1e-14, largest_lacking = 1e-9;

double norm_of(const std::vector<double> &norms) {
  return std::sqrt(std::inner_product(norms.begin(), norms.end(), norms.begin(), 0.));
}

double penalty_of(const CellFit &fit) {
  return penalty * fit.airy->mean_energy();
}
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
  , lift_norms_(add_lift(data_, lift_, 0, {}, nullptr)) {
  bool is_balanced = true;
  do {
    do
      set_up();
    while (fields_ && data_.space.mesh().has_parents() &&
           resolve_loads(0.3 * fields_->distance(), false));
    do
      is_balanced = minimise();
    while (is_balanced && fix_pulling_edges());
  } while (is_balanced && resolve_loads(total_misfit(), true));
  if (!is_balanced)
    failure_ =
      "no stress in equilibrium was found: the tractions of the contact sides cannot carry "
      "the loads, or rounding";
}

void BestStress::set_up() {
  mesh_.emplace(stress_mesh_, data_.scene);
  cells_.clear();
  for (const auto &cell : stress_mesh_.triangulation().active_cell_iterators())
    cells_.push_back(cell);
  x_.reinit(mesh_->n_coefficients());
  give_tractions();
  give_contact();
  conditions_.clear();
  add_plate_conditions();
  std::map<CellId, CellFit> known;
  for (std::size_t cell = 0; cell < fits_.size(); ++cell)
    known.emplace(fitted_[cell], std::move(fits_[cell]));
  fits_.clear();
  fitted_.clear();
  for (std::size_t cell = 0; cell < cells_.size(); ++cell) {
    fitted_.push_back(cells_[cell]->id());
    const auto found = known.find(fitted_.back());
    fits_.push_back(found != known.end() &&
                        found->second.airy->degree() == mesh_->cells()[cell].degree
                      ? found->second
                      : fitter_.fit(cells_[cell], mesh_->cells()[cell], !stress_mesh_.is_own()));
  }
  for (TractionCondition &condition : conditions_)
    condition.weight = penalty_of(fits_[0]) * fits_[0].size * fits_[0].size * condition.row.size() /
                       std::pow(condition.norm(), 2);
  if (stress_mesh_.is_own())
    integrate_u();
}

void BestStress::integrate_u() {
  CellForce force;
  if (data_.scene.body_force != nullptr)
    force = [this](const auto &cell, const std::vector<Point<2>> &points) {
      const unsigned int number = stress_mesh_.find(cell)->active_cell_index();
      const CellFit &fit = fits_[number];
      const CellShape shape(mesh_->cells()[number].corners);
      std::vector<Tensor<1, 2>> f;
      for (const Point<2> &x : points)
        f.push_back(
          fit.airy->value(fit.load, fit.airy->on_diagonals((x - shape.crossing) / fit.size)) /
          fit.size);
      return f;
    };
  const CellField u(data_.space.dofs().begin_active(), data_.U);
  fields_ = integrate_fields(data_, *mesh_, u.on_face(0, 0.), force);
}

BestStress::Vector BestStress::lacking_traces(const std::size_t cell) const {
  Vector y = mesh_->traces(mesh_->cells()[cell], x_);
  y -= fits_[cell].shift;
  return y;
}

double BestStress::misfit(const std::size_t cell) const {
  const CellFit &fit = fits_[cell];
  const Vector y = lacking_traces(cell);
  return fit.size * std::sqrt(fit.rest * fit.rest + std::max(0., y * fit.airy->multiply(y)));
}

double BestStress::distance(const FieldIntegrals &v) const {
  double square = v.without_stress(x_), size = v.strain;
  for (std::size_t c = 0; c < fits_.size(); ++c)
    size += std::pow(misfit(c), 2);
  square += size - v.strain;
  // The terms cancel, up to rounding.
  constexpr double rounding = 1e-14;
  return std::sqrt(std::max(0., square) + rounding * size);
}

double BestStress::oscillation(const std::size_t cell) const {
  const TractionCell &place = mesh_->cells()[cell];
  const CellFit &fit = fits_[cell];
  const auto has_rest = [&](const TractionSide &side) {
    return rests_[0][side.edge] + rests_[1][side.edge] > 0.;
  };
  if (fit.load_rest == 0. && std::none_of(place.sides.begin(), place.sides.end(), has_rest))
    return 0.;
  const OscillationConstants constants{CellShape(place.corners)};
  double sum = constants.body * fit.load_rest;
  for (unsigned int k = 0; k < 4; ++k)
    sum += constants.normal[k] * rests_[0][place.sides[k].edge] +
           constants.edge[k] * rests_[1][place.sides[k].edge];
  return sum / std::sqrt(fit.min_eigenvalue);
}

namespace {
/** The unknown coefficients, and the factors of the augmented matrix. */
class Minimisation {
public:
  Minimisation(const TractionMesh &mesh, const std::vector<CellFit> &fits,
               const std::vector<TractionCondition> &conditions)
    : mesh_(mesh)
    , numbers_(mesh.n_coefficients(), TractionMesh::none) {
    for (const TractionEdge &edge : mesh.edges())
      for (unsigned int c = 0; c < 2; ++c)
        for (unsigned int i = 0; i <= edge.degree && edge.is_free[c]; ++i)
          numbers_[edge.position(c, i)] = n_unknowns_++;
    if (n_unknowns_ == 0)
      return;
    assemble(fits, conditions);
    factorise();
  }
  /** Adds the solution for the forces on all coefficients to x. */
  void add_solution(const dealii::Vector<double> &forces, dealii::Vector<double> &x) const {
    if (n_unknowns_ == 0)
      return;
    std::vector<double> solution(n_unknowns_);
    for (std::size_t i = 0; i < numbers_.size(); ++i)
      if (numbers_[i] != TractionMesh::none)
        solution[numbers_[i]] = forces[i];
    factors_->solve(solution);
    for (std::size_t i = 0; i < numbers_.size(); ++i)
      if (numbers_[i] != TractionMesh::none)
        x[i] += solution[numbers_[i]];
  }

private:
  /** Returns the traces of a cell that have an unknown, and the numbers of those. */
  std::pair<std::vector<unsigned int>, std::vector<types::global_dof_index>>
  unknowns_of(const TractionCell &cell) const {
    std::pair<std::vector<unsigned int>, std::vector<types::global_dof_index>> unknowns;
    const std::vector<unsigned int> coefficients = mesh_.numbers(cell);
    for (unsigned int row = 0; row < coefficients.size(); ++row)
      if (coefficients[row] != TractionMesh::none &&
          numbers_[coefficients[row]] != TractionMesh::none) {
        unknowns.first.push_back(row);
        unknowns.second.push_back(numbers_[coefficients[row]]);
      }
    return unknowns;
  }
  void assemble(const std::vector<CellFit> &fits,
                const std::vector<TractionCondition> &conditions) {
    const AffineConstraints<double> none;
    DynamicSparsityPattern entries(n_unknowns_);
    for (const TractionCell &cell : mesh_.cells())
      none.add_entries_local_to_global(unknowns_of(cell).second, entries);
    std::vector<std::vector<types::global_dof_index>> unknowns_in(conditions.size());
    std::vector<std::vector<double>> rows(conditions.size());
    for (std::size_t k = 0; k < conditions.size(); ++k) {
      for (const auto &[i, factor] : conditions[k].row)
        if (numbers_[i] != TractionMesh::none) {
          unknowns_in[k].push_back(numbers_[i]);
          rows[k].push_back(factor);
        }
      none.add_entries_local_to_global(unknowns_in[k], entries);
    }
    pattern_.copy_from(entries);
    matrix_.reinit(pattern_);
    for (std::size_t c = 0; c < fits.size(); ++c) {
      const auto [rows_of_cell, numbers] = unknowns_of(mesh_.cells()[c]);
      FullMatrix<double> whole = energy_of_tractions(mesh_.cells()[c], fits[c]),
                         here(numbers.size(), numbers.size());
      here.extract_submatrix_from(whole, rows_of_cell, rows_of_cell);
      none.distribute_local_to_global(here, numbers, matrix_);
    }
    for (std::size_t k = 0; k < conditions.size(); ++k) {
      FullMatrix<double> here(rows[k].size(), rows[k].size());
      for (std::size_t i = 0; i < rows[k].size(); ++i)
        for (std::size_t j = 0; j < rows[k].size(); ++j)
          here(i, j) = conditions[k].weight * rows[k][i] * rows[k][j];
      none.distribute_local_to_global(here, unknowns_in[k], matrix_);
    }
  }
  void factorise() {
    std::vector<int> start = {0}, column;
    std::vector<double> value;
    for (unsigned int i = 0; i < n_unknowns_; ++i) {
      // deal.II puts the diagonal first.
      const std::size_t begin = column.size();
      for (auto entry = ++matrix_.begin(i); entry != matrix_.end(i); ++entry) {
        if (entry->column() > i &&
            (column.size() == begin || column.back() < static_cast<int>(i))) {
          column.push_back(i);
          value.push_back(matrix_.diag_element(i));
        }
        column.push_back(entry->column());
        value.push_back(entry->value());
      }
      if (column.size() == begin || column.back() < static_cast<int>(i)) {
        column.push_back(i);
        value.push_back(matrix_.diag_element(i));
      }
      start.push_back(column.size());
    }
    Rows rows;
    rows.n = n_unknowns_;
    rows.start = start.data();
    rows.column = column.data();
    rows.value = value.data();
    factors_ = std::make_unique<SparseCholesky>(rows);
  }
  /** Returns Eᵀ (S + penalty BᵀB) E by traces. */
  FullMatrix<double> energy_of_tractions(const TractionCell &cell, const CellFit &fit) const {
    FullMatrix<double> S = fit.airy->penalised_energy(penalty_of(fit)), result;
    S *= fit.size * fit.size;
    mesh_.restrict_rows(cell, S);
    result.copy_transposed(S);
    mesh_.restrict_rows(cell, result);
    return result;
  }

  const TractionMesh &mesh_;
  std::vector<unsigned int> numbers_;
  unsigned int n_unknowns_ = 0;
  SparsityPattern pattern_;
  SparseMatrix<double> matrix_;
  std::unique_ptr<const SparseCholesky> factors_;
};
} // namespace

bool BestStress::minimise() {
  Minimisation minimisation(*mesh_, fits_, conditions_);
  std::vector<Vector> multipliers(fits_.size(), Vector(3));
  for (TractionCondition &condition : conditions_)
    condition.multiplier = 0.;
  constexpr unsigned int max_steps = 8;
  double scale = 0.;
  for (unsigned int step = 0; step <= max_steps; ++step) {
    Vector forces(x_.size());
    if (fields_)
      forces = fields_->u_h.moments;
    double lacking = 0.;
    for (std::size_t c = 0; c < fits_.size(); ++c) {
      const CellFit &fit = fits_[c];
      const TractionCell &cell = mesh_->cells()[c];
      const Vector y = lacking_traces(c);
      scale = std::max({scale, fit.shift.linfty_norm(), y.linfty_norm()});
      Vector unbalanced(3), trace_forces = fit.airy->multiply(y);
      fit.airy->balance().vmult(unbalanced, y);
      lacking = std::max(lacking, unbalanced.linfty_norm());
      unbalanced *= penalty_of(fit);
      if (step > 0)
        multipliers[c] += unbalanced;
      unbalanced += multipliers[c];
      fit.airy->balance().Tvmult_add(trace_forces, unbalanced);
      FullMatrix<double> column(y.size(), 1);
      for (unsigned int i = 0; i < y.size(); ++i)
        column(i, 0) = -fit.size * fit.size * trace_forces[i];
      mesh_->restrict_rows(cell, column);
      const std::vector<unsigned int> numbers = mesh_->numbers(cell);
      for (unsigned int i = 0; i < y.size(); ++i)
        if (numbers[i] != TractionMesh::none)
          forces[numbers[i]] += column(i, 0);
    }
    for (TractionCondition &condition : conditions_) {
      double rest = -condition.value;
      for (const auto &[i, factor] : condition.row)
        rest += factor * x_[i];
      lacking = std::max(lacking, std::abs(rest) / condition.norm());
      const double force = condition.weight * rest;
      if (step > 0)
        condition.multiplier += force;
      for (const auto &[i, factor] : condition.row)
        forces[i] -= factor * (condition.multiplier + force);
    }
    lacking_ = scale > 0. ? lacking / scale : 0.;
    // One more step than needed: what rounding left of the first.
    if (step == max_steps || (step > 1 && lacking_ <= tolerance))
      break;
    minimisation.add_solution(forces, x_);
  }
  return lacking_ <= largest_lacking;
}

double BestStress::total_misfit() const {
  if (fields_)
    return distance(fields_->u_h);
  double square = 0.;
  for (std::size_t c = 0; c < fits_.size(); ++c)
    square += std::pow(misfit(c), 2);
  return std::sqrt(square);
}

bool BestStress::resolve_loads(const double total, const bool by_degree) {
  double square = 0.;
  for (std::size_t c = 0; c < fits_.size(); ++c)
    square += std::pow(oscillation(c), 2);
  if (square <= 0.01 * total * total)
    return false;
  const double allowed = 0.1 * total / std::sqrt(fits_.size());
  std::vector<StressMesh::Cell> unresolved;
  for (std::size_t c = 0; c < fits_.size(); ++c)
    if (oscillation(c) > (fields_ ? allowed : std::max(allowed, 0.1 * misfit(c))))
      unresolved.push_back(cells_[c]);
  return stress_mesh_.refine(unresolved, by_degree);
}

void BestStress::add_own(StressBound &result) const {
  double rest_square = 0.;
  for (std::size_t c = 0; c < fits_.size(); ++c)
    rest_square += std::pow(oscillation(c), 2);
  const double mesh = distance(fields_->u_h), rest = std::sqrt(rest_square),
               geometry = this->geometry();
  result.square = std::pow(mesh + rest, 2) + geometry * geometry;
  result.oscillation_square = rest * rest;
  result.geometry_square = geometry * geometry;
  result.complementary_energy = complementary_energy();
  const double whole = fields_->distance();
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
  result.lift = norm_of(lift_norms_);
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
