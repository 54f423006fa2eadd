// SPDX-License-Identifier: LGPL-2.1-or-later
// The global minimisation over tractions on edges.

#include <signorini/error_control/equilibration/traction_solver.h>
#include <signorini/solvers/stiffness/condensed_inverse.h>

#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparse_matrix.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace Signorini {
namespace {
/** The weight of the squares of what cells lack in balance, relative to their energies. */
constexpr double penalty = 1e6;
/** What is rounding of balances, relative to the largest trace. */
constexpr double tolerance = 1e-14;

/** The unknown coefficients, and the factors of the augmented matrix. */
class TractionSolver {
public:
  /** @param penalties the weights of cells. */
  TractionSolver(const TractionMesh &mesh, const std::vector<CellFit> &fits,
                 const std::vector<double> &penalties,
                 const std::vector<TractionCondition> &conditions)
    : mesh_(mesh)
    , numbers_(mesh.n_coefficients(), TractionMesh::none) {
    for (const TractionEdge &edge : mesh.edges())
      for (unsigned int c = 0; c < 2; ++c)
        for (unsigned int i = 0; i <= edge.degree && edge.is_free[c]; ++i)
          numbers_[edge.position(c, i)] = n_unknowns_++;
    if (n_unknowns_ == 0)
      return;
    assemble(fits, penalties, conditions);
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
  void assemble(const std::vector<CellFit> &fits, const std::vector<double> &penalties,
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
      FullMatrix<double> whole = energy_of_tractions(mesh_.cells()[c], fits[c], penalties[c]),
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
    std::vector<std::pair<int, double>> row;
    for (unsigned int i = 0; i < n_unknowns_; ++i) {
      row.clear();
      for (auto entry = matrix_.begin(i); entry != matrix_.end(i); ++entry)
        row.emplace_back(entry->column(), entry->value());
      // deal.II puts the diagonal first.
      std::rotate(row.begin(), row.begin() + 1,
                  std::lower_bound(row.begin() + 1, row.end(), row.front()));
      for (const auto &[j, entry] : row) {
        column.push_back(j);
        value.push_back(entry);
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
  FullMatrix<double> energy_of_tractions(const TractionCell &cell, const CellFit &fit,
                                         const double weight) const {
    FullMatrix<double> S = fit.airy->penalised_energy(weight), result;
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

namespace {
/** Returns the weight of the square of what each cell lacks in balance: relative to the energies of
 * the softest cell that shares an edge with it. A stiff one of its own would give way. */
std::vector<double> penalties_of(const TractionMesh &mesh, const std::vector<CellFit> &fits) {
  std::vector<double> on_edge(mesh.edges().size(), 0.), penalties(fits.size(), 0.);
  for (std::size_t c = 0; c < fits.size(); ++c)
    for (const TractionSide &side : mesh.cells()[c].sides)
      on_edge[side.edge] =
        std::max(on_edge[side.edge], fits[c].airy->mean_energy() * fits[c].size * fits[c].size);
  for (std::size_t c = 0; c < fits.size(); ++c)
    for (const TractionSide &side : mesh.cells()[c].sides)
      penalties[c] =
        std::max(penalties[c], penalty * on_edge[side.edge] / (fits[c].size * fits[c].size));
  return penalties;
}
} // namespace

double penalty_of(const CellFit &fit) {
  return penalty * fit.airy->mean_energy();
}

dealii::Vector<double> lacking_traces(const TractionCell &cell, const CellFit &fit,
                                      const TractionMesh &mesh, const dealii::Vector<double> &x) {
  dealii::Vector<double> y = mesh.traces(cell, x);
  y -= fit.shift;
  return y;
}

double minimise(const TractionMesh &mesh, const std::vector<CellFit> &fits,
                std::vector<TractionCondition> &conditions, const dealii::Vector<double> &work,
                dealii::Vector<double> &x) {
  const std::vector<double> penalties = penalties_of(mesh, fits);
  const TractionSolver solver(mesh, fits, penalties, conditions);
  std::vector<dealii::Vector<double>> multipliers(fits.size(), dealii::Vector<double>(3));
  for (TractionCondition &condition : conditions)
    condition.multiplier = 0.;
  constexpr unsigned int max_steps = 8;
  double scale = 0., relative = 0.;
  for (unsigned int step = 0; step <= max_steps; ++step) {
    dealii::Vector<double> forces(work);
    double lacking = 0.;
    for (std::size_t c = 0; c < fits.size(); ++c) {
      const CellFit &fit = fits[c];
      const TractionCell &cell = mesh.cells()[c];
      const dealii::Vector<double> y = lacking_traces(cell, fit, mesh, x);
      scale = std::max({scale, fit.shift.linfty_norm(), y.linfty_norm()});
      dealii::Vector<double> unbalanced(3), trace_forces = fit.airy->multiply(y);
      fit.airy->balance().vmult(unbalanced, y);
      lacking = std::max(lacking, unbalanced.linfty_norm());
      unbalanced *= penalties[c];
      if (step > 0)
        multipliers[c] += unbalanced;
      unbalanced += multipliers[c];
      fit.airy->balance().Tvmult_add(trace_forces, unbalanced);
      FullMatrix<double> column(y.size(), 1);
      for (unsigned int i = 0; i < y.size(); ++i)
        column(i, 0) = -fit.size * fit.size * trace_forces[i];
      mesh.restrict_rows(cell, column);
      const std::vector<unsigned int> numbers = mesh.numbers(cell);
      for (unsigned int i = 0; i < y.size(); ++i)
        if (numbers[i] != TractionMesh::none)
          forces[numbers[i]] += column(i, 0);
    }
    for (TractionCondition &condition : conditions) {
      double rest = -condition.value;
      for (const auto &[i, factor] : condition.row)
        rest += factor * x[i];
      lacking = std::max(lacking, std::abs(rest) / condition.norm());
      const double force = condition.weight * rest;
      if (step > 0)
        condition.multiplier += force;
      for (const auto &[i, factor] : condition.row)
        forces[i] -= factor * (condition.multiplier + force);
    }
    relative = scale > 0. ? lacking / scale : 0.;
    // One more step than needed: what rounding left of the first.
    if (step == max_steps || (step > 1 && relative <= tolerance))
      break;
    solver.add_solution(forces, x);
  }
  return relative;
}
} // namespace Signorini
