// SPDX-License-Identifier: LGPL-2.1-or-later
// The dual problem on the patches that can touch.

#include <signorini/solvers/contact/active_set.h>

#include <deal.II/lac/lapack_full_matrix.h>

#include <algorithm>
#include <limits>
#include <set>

namespace Signorini
{
namespace
{
using Vector = dealii::Vector<double>;
using Indices = std::vector<unsigned int>;

Vector restrict_to(const Indices &K, const Vector &v)
{
  Vector part(K.size());
  for (unsigned int i = 0; i < K.size(); ++i)
    part[i] = v[K[i]];
  return part;
}

/** The indices outside of K that @p is_wanted chooses. */
template <typename Predicate>
Indices find_outside(const Indices &K, const unsigned int m, const Predicate &is_wanted)
{
  Indices found;
  for (unsigned int i = 0; i < m; ++i)
    if (!std::binary_search(K.begin(), K.end(), i) && is_wanted(i))
      found.push_back(i);
  return found;
}
} // namespace

QPResult solve_on_growing_set(const ComplianceOperator &C,
                              const Vector &F,
                              const Vector &start,
                              const QPSolver &solve)
{
  const unsigned int m = F.size();
  QPResult whole;
  whole.P = start.size() > 0 ? start : Vector(m);
  Indices K;
  const auto presses = [&](const unsigned int i) { return i < m && whole.P[i] < 0.; };
  // Ends of contact move by a patch or so; i - 1 wraps around at zero.
  Indices joining = find_outside(
    K, m, [&](const unsigned int i) { return presses(i) || presses(i - 1) || presses(i + 1); });
  const bool has_start = !joining.empty();
  if (!has_start)
    joining = find_outside(K, m, [&](const unsigned int i) { return F[i] < 0.; });
  whole.converged = joining.empty(); // then P = 0 it is
  for (bool first = true; !joining.empty(); first = false)
  {
    K.insert(K.end(), joining.begin(), joining.end());
    std::sort(K.begin(), K.end());
    const QPResult on_K = solve(BoundConstrainedQP(submatrix(C, K), restrict_to(K, F)),
                                first && !has_start ? Vector() : restrict_to(K, whole.P));
    whole.P = 0.;
    for (unsigned int i = 0; i < K.size(); ++i)
      whole.P[K[i]] = on_K.P[i];
    whole.iterations += on_K.iterations;
    whole.kkt_residual = on_K.kkt_residual;
    whole.converged = on_K.converged;
    whole.cycled = whole.cycled || on_K.cycled;
    whole.unique = on_K.unique;
    whole.active_set_failure = on_K.active_set_failure;
    const Vector C_P = C.apply(whole.P);
    joining = find_outside(K, m, [&](const unsigned int i) { return C_P[i] - F[i] > 0.; });
  }
  return whole;
}

// Primal-dual active set with a finite fallback.

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
