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
#include <utility>

namespace Signorini {
namespace {
using Vector = dealii::Vector<double>;

/** The weight of the squares of what cells lack in balance, relative to their energies. */
constexpr double penalty = 1e6;
/** What is rounding of balances, relative to the largest trace, and where it may be if that does
 * not fall. */
constexpr double rounding = 1e-14, near_rounding = 1e-12;
/** The least energy of forces on balances, relative to their squares with the weights. Below it no
 * stress answers: the loads cannot be carried. */
constexpr double least_answer = 1e-9;

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
  void add_solution(const Vector &forces, Vector &x) const {
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

Vector lacking_traces(const TractionCell &cell, const CellFit &fit, const TractionMesh &mesh,
                      const Vector &x) {
  Vector y = mesh.traces(cell, x);
  y -= fit.shift;
  return y;
}

namespace {
/** What tractions lack of all balances, three numbers for each cell and one for each condition, and
 * the forces of multipliers. */
class Balances {
public:
  Balances(const TractionMesh &mesh, const std::vector<CellFit> &fits,
           const std::vector<double> &penalties, const std::vector<TractionCondition> &conditions)
    : mesh_(mesh)
    , fits_(fits)
    , conditions_(conditions)
    , weights_(3 * fits.size() + conditions.size()) {
    for (std::size_t c = 0; c < fits.size(); ++c)
      for (unsigned int i = 0; i < 3; ++i)
        weights_[3 * c + i] = penalties[c] * fits[c].size * fits[c].size;
    for (std::size_t k = 0; k < conditions.size(); ++k)
      weights_[3 * fits.size() + k] = conditions[k].weight;
  }
  /** Returns what x lacks. @param scale is raised to the largest trace. */
  Vector lacking(const Vector &x, double &scale) const {
    Vector all(weights_.size()), of_cell(3);
    for (std::size_t c = 0; c < fits_.size(); ++c) {
      const Vector y = lacking_traces(mesh_.cells()[c], fits_[c], mesh_, x);
      scale = std::max({scale, fits_[c].shift.linfty_norm(), y.linfty_norm()});
      fits_[c].airy->balance().vmult(of_cell, y);
      std::copy(of_cell.begin(), of_cell.end(), all.begin() + 3 * c);
    }
    for (std::size_t k = 0; k < conditions_.size(); ++k) {
      double &rest = all[3 * fits_.size() + k];
      rest = -conditions_[k].value;
      for (const auto &[i, factor] : conditions_[k].row)
        rest += factor * x[i];
    }
    return all;
  }
  /** Subtracts the forces of multipliers and of the energy at x. */
  void subtract_forces(const Vector &multipliers, const Vector &x, Vector &forces) const {
    Vector of_cell(3);
    for (std::size_t c = 0; c < fits_.size(); ++c) {
      const CellFit &fit = fits_[c];
      const TractionCell &cell = mesh_.cells()[c];
      Vector on_traces = fit.airy->multiply(lacking_traces(cell, fit, mesh_, x));
      on_traces *= fit.size * fit.size;
      std::copy_n(multipliers.begin() + 3 * c, 3, of_cell.begin());
      fit.airy->balance().Tvmult_add(on_traces, of_cell);
      FullMatrix<double> column(on_traces.size(), 1);
      for (unsigned int i = 0; i < on_traces.size(); ++i)
        column(i, 0) = on_traces[i];
      mesh_.restrict_rows(cell, column);
      const std::vector<unsigned int> numbers = mesh_.numbers(cell);
      for (unsigned int i = 0; i < numbers.size(); ++i)
        if (numbers[i] != TractionMesh::none)
          forces[numbers[i]] -= column(i, 0);
    }
    for (std::size_t k = 0; k < conditions_.size(); ++k)
      for (const auto &[i, factor] : conditions_[k].row)
        forces[i] -= factor * multipliers[3 * fits_.size() + k];
  }
  /** Returns the multipliers of penalties on what is lacking. */
  Vector weighted(const Vector &lacking) const {
    Vector result(lacking);
    result.scale(weights_);
    return result;
  }
  /** Returns the sum of the squares of multipliers over the weights. */
  double square(const Vector &multipliers) const {
    double sum = 0.;
    for (std::size_t i = 0; i < weights_.size(); ++i)
      sum += multipliers[i] * multipliers[i] / weights_[i];
    return sum;
  }

private:
  const TractionMesh &mesh_;
  const std::vector<CellFit> &fits_;
  const std::vector<TractionCondition> &conditions_;
  Vector weights_;
};
} // namespace

double minimise(const TractionMesh &mesh, const std::vector<CellFit> &fits,
                const std::vector<TractionCondition> &conditions, const Vector &work, Vector &x) {
  const std::vector<double> penalties = penalties_of(mesh, fits);
  const TractionSolver solver(mesh, fits, penalties, conditions);
  const Balances balances(mesh, fits, penalties, conditions);
  constexpr unsigned int max_steps = 100;
  double scale = 0., last_square = 0., relative = 0.;
  Vector lacking = balances.lacking(x, scale), multipliers(lacking.size()), direction(multipliers);
  for (unsigned int step = 0; step < max_steps; ++step) {
    // The tractions of the next multipliers, and what rounding left of the last ones.
    Vector next = balances.weighted(lacking), forces(work), change(x.size());
    next += multipliers;
    next += direction;
    balances.subtract_forces(next, x, forces);
    solver.add_solution(forces, change);
    Vector moved(x);
    moved += change;
    Vector fall(lacking);
    fall -= balances.lacking(moved, scale);
    const double answer = direction * fall;
    if (step > 0 && !(answer > least_answer * balances.square(direction)))
      break;
    // Penalties alone answer by less than their forces: shorter steps are rounding.
    const double length = step > 0 ? std::max(1., (direction * lacking) / answer) : 1.;
    x.add(length, change);
    multipliers.add(length, direction);
    lacking.add(-length, fall);
    const double last = std::exchange(relative, scale > 0. ? lacking.linfty_norm() / scale : 0.);
    if (step > 0 && relative <= (relative > 0.5 * last ? near_rounding : rounding))
      break;
    const Vector weighted = balances.weighted(lacking);
    // Squares hardly see small cells: close to rounding each direction is new.
    const bool keeps = step > 0 && relative > near_rounding;
    direction.sadd(keeps ? std::max(0., -length * (weighted * fall) / last_square) : 0., 1.,
                   weighted);
    last_square = weighted * lacking;
  }
  return relative;
}
} // namespace Signorini
