// SPDX-License-Identifier: LGPL-2.1-or-later
// The active set method with MINRES on the saddle point problem of each set.

#include <signorini/contact_iteration/saddle_point.h>

#include <deal.II/lac/block_vector.h>
#include <deal.II/lac/solver_control.h>
#include <deal.II/lac/solver_minres.h>

#include <cmath>
#include <set>

#include "residuals_of_contact.h"

namespace Signorini
{
namespace
{
using Vector = dealii::Vector<double>;
using Indices = ComplianceOperator::Indices;
using BlockVector = dealii::BlockVector<double>;

/** The matrix (A, -D_S; -D_S^T, 0) and its preconditioner. */
class SaddlePoint
{
public:
  SaddlePoint(const ContactSystem &system, Indices set, const double scale)
    : system_(system)
    , set_(std::move(set))
    , scale_(scale)
  {
  }

  BlockVector make_vector() const
  {
    return BlockVector(std::vector<dealii::types::global_dof_index>{
      system_.A.size(), static_cast<dealii::types::global_dof_index>(set_.size())});
  }

  void vmult(BlockVector &y, const BlockVector &x) const
  {
    system_.A.apply(y.block(0), x.block(0));
    for (unsigned int r = 0; r < set_.size(); ++r)
    {
      double sum = 0.;
      for (const auto &[row, value] : system_.condensed_D.column(set_[r]))
      {
        y.block(0)[row] -= value * x.block(1)[r];
        sum += value * x.block(0)[row];
      }
      y.block(1)[r] = -sum;
    }
  }

  /** diag(V, (t C^_1)_SS^{-1}). */
  struct Preconditioner
  {
    const SaddlePoint &matrix;
    unsigned int &cycles;

    void vmult(BlockVector &z, const BlockVector &r) const
    {
      matrix.system_.A.precondition(z.block(0), r.block(0));
      ++cycles;
      if (!matrix.set_.empty())
        z.block(1) = matrix.system_.model.solve(matrix.set_, r.block(1));
      z.block(1) /= matrix.scale_;
    }
  };

private:
  const ContactSystem &system_;
  Indices set_;
  double scale_;
};

/** One problem: the change of U and P on the set. */
void solve_on(const ContactSystem &system,
              const Indices &set,
              const double reduction,
              const unsigned int most_cycles,
              ContactIterationResult &result)
{
  const SaddlePoint matrix(system, set, result.scale);
  // P vanishes outside of the set.
  Vector P(result.P.size());
  for (const unsigned int i : set)
    P[i] = result.P[i];
  result.P = P;
  BlockVector rhs = matrix.make_vector(), x = matrix.make_vector();
  rhs.block(0) = system.residual(result.U, result.P);
  const Vector W = system.opening(result.U);
  for (unsigned int r = 0; r < set.size(); ++r)
    rhs.block(1)[r] = W[set[r]];
  dealii::ReductionControl control(most_cycles, 1e-300, reduction, false, false);
  dealii::SolverMinRes<BlockVector> minres(control);
  try
  {
    minres.solve(matrix, x, rhs, SaddlePoint::Preconditioner{matrix, result.cycles});
  }
  catch (const dealii::SolverControl::NoConvergence &)
  {
    // The residual tells.
  }
  result.U += x.block(0);
  for (unsigned int r = 0; r < set.size(); ++r)
    result.P[set[r]] += x.block(1)[r];
}
} // namespace

void solve_by_minres(const ContactSystem &system,
                     const ContactIterationOptions &options,
                     ContactIterationResult &result)
{
  constexpr double reduction = 1e-3;
  Vector W = system.opening(result.U);
  std::vector<bool> active(W.size());
  for (unsigned int i = 0; i < W.size(); ++i)
    active[i] = result.P[i] < 0. || W[i] > 0.;
  while (result.cycles < options.maximum_cycles)
  {
    Indices set;
    for (unsigned int i = 0; i < W.size(); ++i)
      if (active[i])
        set.push_back(i);
    solve_on(system, set, reduction, options.maximum_cycles - result.cycles, result);
    // A set without a residual takes none.
    ++result.cycles;
    W = system.opening(result.U);
    std::vector<bool> next(W.size());
    for (unsigned int i = 0; i < W.size(); ++i)
    {
      next[i] = active[i] ? result.P[i] < 0. : W[i] > 0.;
      result.P[i] = std::min(result.P[i], 0.);
    }
    active = next;
    measure(system, options, result);
    if (result.converged)
      return;
  }
}
} // namespace Signorini
