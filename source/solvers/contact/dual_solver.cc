// SPDX-License-Identifier: LGPL-2.1-or-later
// The choice of a solver for the dual problem.

#include <signorini/base/errors.h>
#include <signorini/base/text.h>
#include <signorini/solvers/contact/dual_solver.h>
#include <signorini/solvers/contact/projected_methods.h>

#include <deal.II/lac/exceptions.h>
#include <deal.II/lac/lapack_full_matrix.h>

#include <algorithm>
#include <limits>
#include <set>
#include <sstream>

namespace Signorini
{
namespace
{
using Vector = dealii::Vector<double>;

std::string message_of(const ExceptionBase &exception)
{
  if (dynamic_cast<const LACExceptions::ExcSingular *>(&exception) != nullptr)
    return "the compliance of the patches in contact is singular";
  std::ostringstream text;
  exception.print_info(text);
  return one_line(trim(text.str()));
}

QPResult by_psor(const BoundConstrainedQP &qp,
                 const Vector &start,
                 const DualSolverOptions &options)
{
  return solve_by_psor(qp,
                       start.size() > 0 ? start : Vector(qp.size()),
                       {options.relaxation, options.tolerance, options.maximum_iterations});
}

QPResult by_chosen_method(const BoundConstrainedQP &qp,
                          const Vector &start,
                          const DualSolverOptions &options)
{
  if (options.method == ContactSolver::psor)
    return by_psor(qp, start, options);
  if (options.method == ContactSolver::mprgp)
    return solve_by_mprgp(
      qp, start, {options.tolerance, options.maximum_iterations, options.preconditioner});
  try
  {
    return solve_by_active_set(qp, start, {options.tolerance, options.maximum_iterations});
  }
  catch (const ExceptionBase &exception)
  {
    QPResult result = by_psor(qp, start, options);
    result.active_set_failure = message_of(exception);
    return result;
  }
}
} // namespace

QPResult solve_dual_problem(const std::shared_ptr<const ComplianceOperator> &C,
                            const Vector &F,
                            const Vector &start,
                            const DualSolverOptions &options)
{
  const QPSolver solve = [&](const BoundConstrainedQP &qp, const Vector &qp_start) {
    QPResult result = by_chosen_method(qp, qp_start, options);
    result.unique = !options.may_be_singular || qp.has_unique_solution(result.P);
    return result;
  };
  if (options.method != ContactSolver::psor && options.method != ContactSolver::mprgp &&
      !C->is_explicit())
    return solve_on_growing_set(*C, F, start, solve);
  return solve(BoundConstrainedQP(C, F, AdmissibleSet::nonpositive(F.size())), start);
}

// The dual problem on a growing set of patches.

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

/** Returns the indices outside of K that satisfy @p is_wanted. */
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
  Indices S;
  const auto presses = [&](const unsigned int i) { return i < m && whole.P[i] < 0.; };
  // Ends of contact move by a patch or so; i - 1 wraps around at zero.
  Indices joining = find_outside(
    S, m, [&](const unsigned int i) { return presses(i) || presses(i - 1) || presses(i + 1); });
  const bool has_start = !joining.empty();
  if (!has_start)
    joining = find_outside(S, m, [&](const unsigned int i) { return F[i] < 0.; });
  whole.converged = joining.empty(); // then P = 0 it is
  for (bool first = true; !joining.empty(); first = false)
  {
    S.insert(S.end(), joining.begin(), joining.end());
    std::sort(S.begin(), S.end());
    const QPResult on_S = solve(BoundConstrainedQP(submatrix(C, S), restrict_to(S, F)),
                                first && !has_start ? Vector() : restrict_to(S, whole.P));
    whole.P = 0.;
    for (unsigned int i = 0; i < S.size(); ++i)
      whole.P[S[i]] = on_S.P[i];
    whole.iterations += on_S.iterations;
    whole.kkt_residual = on_S.kkt_residual;
    whole.converged = on_S.converged;
    whole.cycled = whole.cycled || on_S.cycled;
    whole.unique = on_S.unique;
    whole.active_set_failure = on_S.active_set_failure;
    const Vector C_P = C.apply(whole.P);
    joining = find_outside(S, m, [&](const unsigned int i) { return C_P[i] - F[i] > 0.; });
  }
  return whole;
}

// The primal-dual active set method with a finite fallback.

namespace
{
/** The state of an unknown: at the lower end of its interval, inside, or at the upper end. */
enum class State : char
{
  lower,
  inside,
  upper
};
using States = std::vector<State>;
using Vector = dealii::Vector<double>;

State state_of(const AdmissibleSet &K, const unsigned int i, const double p)
{
  return K.is_inside(i, p) ? State::inside : p >= K[i].upper ? State::upper : State::lower;
}

States states_of(const AdmissibleSet &K, const Vector &P)
{
  States states(K.size());
  for (unsigned int i = 0; i < K.size(); ++i)
    states[i] = state_of(K, i, P[i]);
  return states;
}

/** Solves C_AA P_A = F_A - C_AI e_I, P_I = e_I. @throws ExceptionBase if C_AA is not
 * positive definite. */
Vector solve_on_set(const BoundConstrainedQP &qp, const States &states)
{
  std::vector<unsigned int> A;
  Vector P(qp.size());
  for (unsigned int i = 0; i < qp.size(); ++i)
    if (states[i] == State::inside)
      A.push_back(i);
    else
      P[i] = states[i] == State::upper ? qp.K[i].upper : qp.K[i].lower;
  if (A.empty())
    return P;
  const Vector minus_rhs = qp.gradient(P);
  LAPACKFullMatrix<double> C_AA(A.size(), A.size());
  C_AA = submatrix(*qp.C, A);
  Vector P_A(A.size());
  for (unsigned int r = 0; r < A.size(); ++r)
    P_A[r] = -minus_rhs[A[r]];
  C_AA.set_property(LAPACKSupport::symmetric);
  C_AA.compute_cholesky_factorization();
  C_AA.solve(P_A);
  for (unsigned int r = 0; r < A.size(); ++r)
    P[A[r]] = P_A[r];
  return P;
}

/** Returns the states that the solution P for @p states predicts. In P, W vanishes inside of the
 * intervals. */
States improve(const BoundConstrainedQP &qp, const States &states, const Vector &P)
{
  const Vector W = qp.gradient(P);
  States next(states);
  for (unsigned int i = 0; i < qp.size(); ++i)
    if (states[i] == State::inside)
      next[i] = state_of(qp.K, i, P[i]);
    else if (qp.K.inward(i, P[i], W[i]) != 0.)
      next[i] = State::inside;
  return next;
}

/** Changes the state of the first unknown for which the states differ. */
States exchange_lowest(const States &states, const States &wanted)
{
  States next = states;
  for (unsigned int i = 0; i < states.size(); ++i)
    if (states[i] != wanted[i])
    {
      next[i] = wanted[i];
      break;
    }
  return next;
}

/** Returns the residual that rounding leaves after a solve with C_AA. */
double rounding_level(const BoundConstrainedQP &qp)
{
  return (qp.size() + 10) * std::numeric_limits<double>::epsilon();
}
} // namespace

QPResult solve_by_active_set(const BoundConstrainedQP &qp,
                             const dealii::Vector<double> &start,
                             const ActiveSetOptions &options)
{
  QPResult result;
  States states = start.size() == 0 ? States(qp.size(), State::inside) : states_of(qp.K, start);
  std::set<States> visited;
  bool settled = false;
  while (!settled && result.iterations < options.maximum_iterations)
  {
    ++result.iterations;
    visited.insert(states);
    result.P = solve_on_set(qp, states);
    const States wanted = improve(qp, states, result.P);
    // Where P and W vanish together, rounding changes the set each time, although P is the
    // solution.
    Vector projected = result.P;
    qp.K.project(projected);
    const double residual = qp.kkt_residual(projected);
    const bool came_back = visited.count(wanted) > 0;
    settled = wanted == states || residual <= rounding_level(qp) ||
              (came_back && residual <= 1e-3 * options.tolerance);
    result.cycled = result.cycled || (came_back && !settled);
    states = result.cycled ? exchange_lowest(states, wanted) : wanted;
  }
  qp.K.project(result.P);
  result.kkt_residual = qp.kkt_residual(result.P);
  result.converged = result.kkt_residual <= options.tolerance;
  return result;
}
} // namespace Signorini
