// SPDX-License-Identifier: LGPL-2.1-or-later
// The global minimisation over tractions on edges.

#include <signorini/error_control/equilibration/best_stress.h>
#include <signorini/error_control/loads/cell_loads.h>
#include <signorini/postprocessing/fields/forces.h>
#include <signorini/problem/scene/corners.h>
#include <signorini/solvers/stiffness/condensed_inverse.h>

#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparse_matrix.h>

#include <algorithm>
#include <cmath>

namespace Signorini {
namespace {
/** The weight of the squares of what cells lack in balance, relative to their energies. */
constexpr double penalty = 1e6;
/** What may be lacking, relative to the largest trace. */
constexpr double tolerance = 1e-14, largest_lacking = 1e-9;
/** The highest degree of stresses, for which the functions of AiryCell are independent enough. */
constexpr unsigned int max_degree = 11;

double penalty_of(const CellFit &fit) {
  return penalty * fit.airy->mean_energy();
}
} // namespace

std::string BestStress::objection(const BoundData &data) {
  if (data.space.mesh().is_curved())
    return "the mesh is graded, and sides are curved";
  if (data.space.strain_operator() != StrainOperator::symmetric_gradient)
    return "the strain is that of B-bar, with elements of a degree above one";
  return find_contradiction(data.scene);
}

BestStress::BestStress(const BoundData &data)
  : data_(data)
  , mesh_(data.space, data.scene)
  , cells_(cells_in_order(data.space))
  , lift_(data_, cells_.size(), prescribed_edges())
  , fitter_(data_)
  , x_(mesh_.n_coefficients())
  , normal_rest_(mesh_.edges().size(), 0.)
  , shear_rest_(mesh_.edges().size(), 0.) {
  give_tractions();
  give_contact();
  for (std::size_t cell = 0; cell < cells_.size(); ++cell)
    lift_norms_.push_back(lift_.cells()[cell] ? fitter_.lift_norm(lift_, cell, mesh_.cells()[cell])
                                              : 0.);
  add_plate_conditions();
  for (std::size_t cell = 0; cell < cells_.size(); ++cell)
    fits_.push_back(fitter_.fit(cells_[cell], mesh_.cells()[cell]));
  for (TractionCondition &condition : conditions_)
    condition.weight = penalty_of(fits_[0]) * fits_[0].size * fits_[0].size * condition.row.size() /
                       std::pow(condition.norm(), 2);
  bool is_balanced = minimise();
  while (is_balanced && (fix_pulling_edges() || raise_degrees()))
    is_balanced = minimise();
  if (!is_balanced)
    failure_ =
      "no stress in equilibrium was found: the tractions of the contact sides cannot carry "
      "the loads, or rounding";
}

BestStress::Vector BestStress::lacking_traces(const std::size_t cell) const {
  Vector y = mesh_.traces(mesh_.cells()[cell], x_);
  y -= fits_[cell].shift;
  return y;
}

double BestStress::misfit(const std::size_t cell) const {
  const CellFit &fit = fits_[cell];
  const Vector y = lacking_traces(cell);
  return fit.size * std::sqrt(fit.rest * fit.rest + std::max(0., y * fit.airy->multiply(y)));
}

double BestStress::oscillation(const std::size_t cell) const {
  const TractionCell &place = mesh_.cells()[cell];
  const CellFit &fit = fits_[cell];
  const auto has_rest = [&](const TractionSide &side) {
    return normal_rest_[side.edge] + shear_rest_[side.edge] > 0.;
  };
  if (fit.load_rest == 0. && std::none_of(place.sides.begin(), place.sides.end(), has_rest))
    return 0.;
  const OscillationConstants constants{CellShape(place.corners)};
  double sum = constants.body * fit.load_rest;
  for (unsigned int k = 0; k < 4; ++k)
    sum += constants.normal[k] * normal_rest_[place.sides[k].edge] +
           constants.edge[k] * shear_rest_[place.sides[k].edge];
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
  Minimisation minimisation(mesh_, fits_, conditions_);
  std::vector<Vector> multipliers(fits_.size(), Vector(3));
  for (TractionCondition &condition : conditions_)
    condition.multiplier = 0.;
  constexpr unsigned int max_steps = 8;
  double scale = 0.;
  for (const CellFit &fit : fits_)
    scale = std::max(scale, fit.shift.linfty_norm());
  for (unsigned int step = 0; step <= max_steps; ++step) {
    Vector forces(x_.size());
    double lacking = 0.;
    for (std::size_t c = 0; c < fits_.size(); ++c) {
      const CellFit &fit = fits_[c];
      const TractionCell &cell = mesh_.cells()[c];
      const Vector y = lacking_traces(c);
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
      mesh_.restrict_rows(cell, column);
      const std::vector<unsigned int> numbers = mesh_.numbers(cell);
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

bool BestStress::raise_degrees() {
  double mesh_square = 0., oscillation_square = 0.;
  for (std::size_t c = 0; c < fits_.size(); ++c) {
    mesh_square += std::pow(misfit(c), 2);
    oscillation_square += std::pow(oscillation(c), 2);
  }
  if (oscillation_square <= 0.01 * mesh_square)
    return false;
  const double share = std::sqrt(mesh_square / fits_.size());
  bool raised = false;
  for (std::size_t c = 0; c < fits_.size(); ++c) {
    TractionCell cell = mesh_.cells()[c];
    const double allowed = 0.1 * std::max(misfit(c), share),
                 body = OscillationConstants(CellShape(cell.corners)).body /
                        std::sqrt(fits_[c].min_eigenvalue);
    if (body * fits_[c].load_rest <= allowed || cell.degree >= max_degree)
      continue;
    mesh_.raise(c, std::min(cell.degree + 2, max_degree));
    fits_[c] = fitter_.fit(cells_[c], mesh_.cells()[c]);
    raised = true;
  }
  return raised;
}

StressBound BestStress::bound() const {
  StressBound result;
  result.algebra = lacking_;
  result.lift_misfit = lift_.max_misfit();
  double lift_square = 0.;
  for (std::size_t c = 0; c < fits_.size(); ++c) {
    // The misfit is that of u_h, which is at most |||z|||_K away from that of u_h + z.
    const double mesh = misfit(c), rest = oscillation(c) + lift_norms_[c];
    lift_square += lift_norms_[c] * lift_norms_[c];
    result.misfit.push_back(mesh);
    result.oscillation.push_back(rest);
    result.square += std::pow(mesh + rest, 2);
    result.oscillation_square += rest * rest;
    result.smallest_square += std::pow(std::max(0., mesh - rest), 2);
  }
  result.lift = std::sqrt(lift_square);
  return result;
}
} // namespace Signorini
