// SPDX-License-Identifier: LGPL-2.1-or-later
// Primal-dual active set with a finite fallback.

#include <signorini/qp/active_set.h>

#include <deal.II/lac/lapack_full_matrix.h>

#include <limits>
#include <set>

namespace Signorini
{
namespace
{
using ActiveSet = std::vector<bool>;
using Vector = dealii::Vector<double>;

std::vector<unsigned int> indices_of(const ActiveSet &active)
{
  std::vector<unsigned int> indices;
  for (unsigned int i = 0; i < active.size(); ++i)
    if (active[i])
      indices.push_back(i);
  return indices;
}

/** C_AA P_A = F_A - C_AI bound_I, P_I = bound_I. @throws if C_AA is not positive definite. */
Vector solve_on_set(const BoundConstrainedQP &qp, const ActiveSet &active)
{
  const std::vector<unsigned int> A = indices_of(active);
  Vector P = qp.bound;
  if (A.empty())
    return P;
  for (const unsigned int i : A)
    P[i] = 0.;
  const Vector minus_rhs = qp.gradient(P);
  dealii::LAPACKFullMatrix<double> C_AA(A.size(), A.size());
  C_AA = submatrix(*qp.C, A);
  Vector P_A(A.size());
  for (unsigned int r = 0; r < A.size(); ++r)
    P_A[r] = -minus_rhs[A[r]];
  C_AA.set_property(dealii::LAPACKSupport::symmetric);
  C_AA.compute_cholesky_factorization();
  C_AA.solve(P_A);
  for (unsigned int r = 0; r < A.size(); ++r)
    P[A[r]] = P_A[r];
  return P;
}

/** The patches on which a start value presses. */
ActiveSet pressed(const BoundConstrainedQP &qp, const Vector &P)
{
  ActiveSet active(qp.size());
  for (unsigned int i = 0; i < qp.size(); ++i)
    active[i] = P[i] < qp.bound[i];
  return active;
}

/** The set predicted by the solution on @p active; there W_A = 0 and P_I = bound_I exactly. */
ActiveSet improve(const BoundConstrainedQP &qp, const ActiveSet &active, const Vector &P)
{
  const Vector W = qp.gradient(P);
  ActiveSet next(qp.size());
  for (unsigned int i = 0; i < qp.size(); ++i)
    next[i] = active[i] ? P[i] < qp.bound[i] : W[i] > 0.;
  return next;
}

/** Moves the lowest index on which the sets differ to the other side. */
ActiveSet exchange_lowest(const ActiveSet &active, const ActiveSet &wanted)
{
  ActiveSet next = active;
  for (unsigned int i = 0; i < active.size(); ++i)
    if (active[i] != wanted[i])
    {
      next[i] = wanted[i];
      break;
    }
  return next;
}

/** A residual that a solve with C_AA leaves. */
double rounding_level(const BoundConstrainedQP &qp)
{
  return (qp.size() + 10) * std::numeric_limits<double>::epsilon();
}

void project(const BoundConstrainedQP &qp, Vector &P)
{
  for (unsigned int i = 0; i < qp.size(); ++i)
    P[i] = std::min(P[i], qp.bound[i]);
}
} // namespace

QPResult solve_by_active_set(const BoundConstrainedQP &qp,
                             const dealii::Vector<double> &start,
                             const ActiveSetOptions &options)
{
  QPResult result;
  ActiveSet active = start.size() == 0 ? ActiveSet(qp.size(), true) : pressed(qp, start);
  std::set<ActiveSet> visited;
  bool settled = false;
  while (!settled && result.iterations < options.maximum_iterations)
  {
    ++result.iterations;
    visited.insert(active);
    result.P = solve_on_set(qp, active);
    const ActiveSet wanted = improve(qp, active, result.P);
    // Where P and W vanish together, rounding chooses the set anew each time: the answer is found
    // all the same.
    Vector projected = result.P;
    project(qp, projected);
    const double residual = qp.kkt_residual(projected);
    const bool came_back = visited.count(wanted) > 0;
    settled = wanted == active || residual <= rounding_level(qp) ||
              (came_back && residual <= 1e-3 * options.tolerance);
    result.cycled = result.cycled || (came_back && !settled);
    active = result.cycled ? exchange_lowest(active, wanted) : wanted;
  }
  project(qp, result.P);
  result.kkt_residual = qp.kkt_residual(result.P);
  result.converged = result.kkt_residual <= options.tolerance;
  return result;
}
} // namespace Signorini
