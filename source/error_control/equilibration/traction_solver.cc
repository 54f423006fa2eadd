// SPDX-License-Identifier: LGPL-2.1-or-later
// The global minimisation over tractions on edges.

#include <signorini/error_control/equilibration/traction_solver.h>
#include <signorini/solvers/stiffness/condensed_inverse.h>

#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace Signorini {
namespace {
using Vector = dealii::Vector<double>;

/** The weight of the squares of the residual forces of cells, relative to their energies. */
constexpr double penalty = 1e6;
/** The rounding of balances, relative to the largest trace, and the largest residual that is
 * accepted where it does not fall. */
constexpr double rounding = 1e-14, near_rounding = 1e-12;
/** The least part of a direction that falls, in the norm of the weights. Below it no stress
 * answers: the loads cannot be carried. */
constexpr double least_answer = 1e-9;

/** Returns the weights of the squares of the residuals of the balances of cells, three for each,
 * and of the conditions. In a cell the weight is relative to the energies of the softest cell that
 * shares an edge with it: a stiff cell by itself would give way. Of a shared edge that is a part of
 * a side of a cell, the cell feels that part of its energy. */
Vector weights_of(const Tractions &tractions, const std::vector<CellFit> &fits) {
  const TractionSpace &space = tractions.space;
  const std::vector<TractionCell> &cells = space.cells();
  /** Calls visit(edge, share) for the edges with the unknown tractions of a cell. */
  const auto visit_edges = [&](const TractionCell &cell, const auto &visit) {
    for (const TractionSide &side : cell.sides) {
      for (const SharedPart &part : space.shared_parts(side.edge))
        visit(part.shared, part.to - part.from);
      if (space.shared_parts(side.edge).empty())
        visit(side.edge, 1.);
    }
  };
  std::vector<double> on_edge(space.edges().size(), 0.);
  for (std::size_t c = 0; c < cells.size(); ++c) {
    const double energy = fits[c].airy->mean_energy() * fits[c].size * fits[c].size;
    visit_edges(cells[c], [&](const unsigned int edge, const double share) {
      on_edge[edge] = std::max(on_edge[edge], share * energy);
    });
  }
  Vector weights(3 * cells.size() + tractions.conditions.size());
  for (std::size_t c = 0; c < cells.size(); ++c)
    visit_edges(cells[c], [&](const unsigned int edge, const double /*share*/) {
      for (unsigned int i = 0; i < 3; ++i)
        weights[3 * c + i] = std::max(weights[3 * c + i], penalty * on_edge[edge]);
    });
  const double energy = fits[0].airy->mean_energy() * fits[0].size * fits[0].size;
  for (std::size_t k = 0; k < tractions.conditions.size(); ++k)
    weights[3 * cells.size() + k] = penalty * energy * tractions.conditions[k].row.size();
  return weights;
}

/** The energy of tractions and their conditions, with the factors of the matrix of the augmented
 * Lagrangian for the free coefficients. */
class TractionProblem {
public:
  TractionProblem(const Tractions &tractions, const std::vector<CellFit> &fits)
    : space_(tractions.space)
    , fits_(fits)
    , conditions_(tractions.conditions)
    , weights_(weights_of(tractions, fits))
    , numbers_(space_.n_coefficients(), TractionSpace::none) {
    for (const TractionEdge &edge : space_.edges())
      for (unsigned int c = 0; c < 2; ++c)
        for (unsigned int i = 0; i <= edge.degree && edge.is_free[c]; ++i)
          numbers_[edge.position(c, i)] = n_unknowns_++;
    if (n_unknowns_ > 0)
      factorise();
  }
  /** Adds the solution for the forces on all coefficients to x. */
  void add_solution(const Vector &forces, Vector &x) const {
    if (n_unknowns_ == 0)
      return;
    std::vector<double> solution(n_unknowns_);
    for (std::size_t i = 0; i < numbers_.size(); ++i)
      if (numbers_[i] != TractionSpace::none)
        solution[numbers_[i]] = forces[i];
    factors_->solve(solution);
    for (std::size_t i = 0; i < numbers_.size(); ++i)
      if (numbers_[i] != TractionSpace::none)
        x[i] += solution[numbers_[i]];
  }
  /** Returns the residuals of balances and conditions at x. @param scale is raised to the largest
   * trace.
   */
  Vector residual(const Vector &x, double &scale) const {
    Vector all(weights_.size()), of_cell(3);
    for (std::size_t c = 0; c < fits_.size(); ++c) {
      const Vector y = fits_[c].traces(space_, c, x);
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
  /** Returns the largest residual force, relative to the largest trace on the largest cell:
   * rounding of its corners leaves a tiny cell without a share of its traces, but hardly a force.
   */
  double defect(const Vector &residual, const double scale) const {
    double largest_size = 0., largest_force = 0.;
    for (const CellFit &fit : fits_)
      largest_size = std::max(largest_size, fit.size);
    for (std::size_t i = 0; i < residual.size(); ++i)
      largest_force =
        std::max(largest_force,
                 std::abs(residual[i]) * (i < 3 * fits_.size() ? fits_[i / 3].size : largest_size));
    return scale > 0. ? largest_force / (scale * largest_size) : 0.;
  }
  /** Subtracts the forces of multipliers and of the energy at x. */
  void subtract_forces(const Vector &multipliers, const Vector &x, Vector &forces) const {
    Vector of_cell(3);
    for (std::size_t c = 0; c < fits_.size(); ++c) {
      Vector on_traces = fits_[c].airy->multiply(fits_[c].traces(space_, c, x));
      on_traces *= fits_[c].size * fits_[c].size;
      std::copy_n(multipliers.begin() + 3 * c, 3, of_cell.begin());
      fits_[c].airy->balance().Tvmult_add(on_traces, of_cell);
      for (const auto &[trace, coefficient, value] : space_.entries(space_.cells()[c]))
        forces[coefficient] -= value * on_traces[trace];
    }
    for (std::size_t k = 0; k < conditions_.size(); ++k)
      for (const auto &[i, factor] : conditions_[k].row)
        forces[i] -= factor * multipliers[3 * fits_.size() + k];
  }
  /** Returns the multipliers of penalties on the residuals. */
  Vector weighted(Vector residual) const {
    residual.scale(weights_);
    return residual;
  }
  /** Returns the sum of the squares of multipliers over the weights. */
  double square(const Vector &multipliers) const {
    double sum = 0.;
    for (std::size_t i = 0; i < weights_.size(); ++i)
      sum += multipliers[i] * multipliers[i] / weights_[i];
    return sum;
  }

private:
  using Entries = std::vector<TractionSpace::Entry>;
  using Numbers = std::vector<types::global_dof_index>;

  /** A symmetric matrix M and the entries of a V: Vᵀ M V is a part of the matrix. The first parts
   * are those of cells, with their balances; then come the other conditions. */
  Entries entries(const std::size_t part) const {
    if (part < fits_.size())
      return space_.entries(space_.cells()[part]);
    Entries row;
    for (const auto &[i, factor] : conditions_[part - fits_.size()].row)
      row.push_back({0, i, factor});
    return row;
  }
  FullMatrix<double> energy(const std::size_t part) const {
    if (part >= fits_.size())
      return FullMatrix<double>(1, 1, weights_.begin() + part + 2 * fits_.size());
    const double square = fits_[part].size * fits_[part].size;
    FullMatrix<double> S = fits_[part].airy->penalised_energy(weights_[3 * part] / square);
    return S *= square;
  }
  /** Keeps the entries of unknowns, with their positions among these. @return the numbers of these.
   */
  Numbers keep_unknowns(Entries &V) const {
    Numbers unknowns;
    Entries kept;
    for (auto [row, coefficient, value] : V)
      if (const unsigned int number = numbers_[coefficient]; number != TractionSpace::none) {
        const auto found = std::find(unknowns.begin(), unknowns.end(), number);
        kept.push_back({row, static_cast<unsigned int>(found - unknowns.begin()), value});
        if (found == unknowns.end())
          unknowns.push_back(number);
      }
    V = std::move(kept);
    return unknowns;
  }
  void factorise() {
    const AffineConstraints<double> none;
    const std::size_t n_parts = fits_.size() + conditions_.size();
    DynamicSparsityPattern pattern(n_unknowns_);
    for (std::size_t part = 0; part < n_parts; ++part) {
      Entries V = entries(part);
      none.add_entries_local_to_global(keep_unknowns(V), pattern);
    }
    TrilinosWrappers::SparseMatrix matrix;
    matrix.reinit(pattern);
    for (std::size_t part = 0; part < n_parts; ++part) {
      Entries V = entries(part);
      const Numbers unknowns = keep_unknowns(V);
      const FullMatrix<double> M = energy(part);
      FullMatrix<double> block(unknowns.size(), unknowns.size());
      for (const auto &a : V)
        for (const auto &b : V)
          block(a.coefficient, b.coefficient) += a.value * b.value * M(a.trace, b.trace);
      none.distribute_local_to_global(block, unknowns, matrix);
    }
    matrix.compress(VectorOperation::add);
    factors_ = std::make_unique<SparseCholesky>(Rows(matrix));
  }

  const TractionSpace &space_;
  const std::vector<CellFit> &fits_;
  const std::vector<TractionCondition> &conditions_;
  Vector weights_;
  /** The numbers of unknowns by coefficient. */
  std::vector<unsigned int> numbers_;
  unsigned int n_unknowns_ = 0;
  std::unique_ptr<const SparseCholesky> factors_;
};
} // namespace

double minimise(const std::vector<CellFit> &fits, const Vector &work, Tractions &tractions) {
  const TractionProblem problem(tractions, fits);
  const Vector given = tractions.space.gathered(work);
  Vector &x = tractions.x;
  constexpr unsigned int max_steps = 100;
  double scale = 0., last_square = 0., relative = 0.;
  Vector residual = problem.residual(x, scale), multipliers(residual.size()),
         direction(multipliers);
  for (unsigned int step = 0; step < max_steps; ++step) {
    // The tractions of the next multipliers, and the rounding of the last ones.
    Vector next = problem.weighted(residual), forces(given), change(x.size());
    next += multipliers;
    next += direction;
    problem.subtract_forces(next, x, forces);
    problem.add_solution(forces, change);
    Vector moved(x);
    moved += change;
    Vector fall(residual);
    fall -= problem.residual(moved, scale);
    const double answer = direction * fall, of_fall = problem.weighted(fall) * fall;
    if (step > 0 && !(of_fall > least_answer * least_answer * problem.square(direction)))
      break;
    // By equilibrium alone of_fall <= answer: more is rounding, from which no direction may follow.
    const bool restarts = step == 0 || of_fall > answer;
    // Penalties alone answer by less than their forces: shorter steps are rounding.
    const double length = restarts ? 1. : std::max(1., (direction * residual) / answer);
    x.add(length, change);
    multipliers.add(length, direction);
    residual.add(-length, fall);
    const double last = std::exchange(relative, scale > 0. ? residual.linfty_norm() / scale : 0.);
    const bool falls = relative <= 0.5 * last;
    if (step > 0 && (relative <= (falls ? rounding : near_rounding) || (restarts && !falls)))
      break;
    const Vector weighted = problem.weighted(residual);
    direction.sadd(restarts ? 0. : std::max(0., -length * (weighted * fall) / last_square), 1.,
                   weighted);
    last_square = weighted * residual;
  }
  tractions.project_shared();
  return problem.defect(residual, scale);
}
} // namespace Signorini
