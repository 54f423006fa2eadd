// SPDX-License-Identifier: LGPL-2.1-or-later
// The dual problem: the choice of a solver, and the growing set of patches.

#include <signorini/base/errors.h>
#include <signorini/base/text.h>
#include <signorini/solvers/contact/dual_solver.h>
#include <signorini/solvers/contact/projected_methods.h>

#include <deal.II/lac/exceptions.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Signorini {
namespace {
using Vector = dealii::Vector<double>;

std::string message_of(const ExceptionBase &exception) {
  if (dynamic_cast<const LACExceptions::ExcSingular *>(&exception) != nullptr)
    return "the compliance of the patches in contact is singular";
  std::ostringstream text;
  exception.print_info(text);
  return one_line(trim(text.str()));
}

/** Returns how many sweeps projected SOR may take instead of the active set method: some
 * seconds. */
unsigned int affordable_sweeps(const BoundConstrainedQP &qp) {
  constexpr double most_products = 5e9;
  return static_cast<unsigned int>(most_products / std::pow(qp.size() + 1., 2)) + 1;
}

QPResult by_chosen_method(const BoundConstrainedQP &qp, const Vector &start,
                          const DualSolverOptions &options) {
  if (options.method == ContactSolver::psor && qp.size() > 0)
    return solve_by_psor(qp, start, options);
  QPResult result;
  std::string failure;
  try {
    result = solve_by_active_set(qp, start, options);
    if (result.converged || qp.size() == 0)
      return result;
    std::ostringstream text;
    text << "KKT residual " << result.kkt_residual << " after " << result.iterations << " systems";
    failure = text.str();
  } catch (const ExceptionBase &exception) {
    failure = message_of(exception);
  }
  IterationOptions sweeps = options;
  sweeps.maximum_iterations = std::min(options.maximum_iterations, affordable_sweeps(qp));
  sweeps.may_give_up = true;
  QPResult swept = solve_by_psor(qp, start, sweeps);
  if (result.P.size() > 0 && !swept.converged)
    return result;
  swept.active_set_failure = failure;
  return swept;
}
} // namespace

QPResult solve_dual_problem(const std::shared_ptr<const ComplianceOperator> &C, const Vector &F,
                            const AdmissibleSet &K, const Vector &start,
                            const DualSolverOptions &options, const Balances &balances) {
  const QPSolver solve = [&](const BoundConstrainedQP &qp, const Vector &qp_start) {
    QPResult result = by_chosen_method(qp, qp_start, options);
    result.unique = !options.may_be_singular || qp.has_unique_solution(result.P, result.z);
    return result;
  };
  if (options.method != ContactSolver::psor && !C->is_explicit() && K.is_nonpositive())
    return solve_on_growing_set(*C, F, start, solve, balances);
  return solve(BoundConstrainedQP(C, F, K, balances), start);
}

namespace {
using Indices = ComplianceOperator::Indices;

Vector restrict_to(const Indices &S, const Vector &v) {
  Vector part(v.size() > 0 ? S.size() : 0);
  for (unsigned int i = 0; i < part.size(); ++i)
    part[i] = v[S[i]];
  return part;
}

Balances restrict_to(const Indices &S, const Balances &balances) {
  Balances part = balances;
  part.P = restrict_to(S, balances.P);
  part.B.reinit(S.size(), balances.size());
  for (unsigned int i = 0; i < S.size(); ++i)
    for (unsigned int j = 0; j < balances.size(); ++j)
      part.B(i, j) = balances.B(S[i], j);
  return part;
}

/** Returns the indices outside of S, below m, that satisfy @p is_wanted. */
template <typename Predicate>
Indices find_outside(const Indices &S, const unsigned int m, const Predicate &is_wanted) {
  Indices found;
  for (unsigned int i = 0; i < m; ++i)
    if (!std::binary_search(S.begin(), S.end(), i) && is_wanted(i))
      found.push_back(i);
  return found;
}
} // namespace

QPResult solve_on_growing_set(const ComplianceOperator &C, const Vector &F, const Vector &start,
                              const QPSolver &solve, const Balances &balances) {
  const unsigned int m = F.size();
  const bool moves = balances.size() > 0;
  QPResult whole;
  whole.P = start.size() > 0 ? start : Vector(m);
  const auto presses = [&](const unsigned int i) {
    return i < m && (whole.P[i] < 0. || (moves && balances.P[i] < 0.));
  };
  // Ends of contact move by a patch or so; i - 1 wraps around at zero.
  Indices S, joining = find_outside(S, m, [&](const unsigned int i) {
               return presses(i) || presses(i - 1) || presses(i + 1);
             });
  const bool has_start = !whole.P.all_zero();
  if (joining.empty())
    joining = find_outside(S, m, [&](const unsigned int i) { return F[i] < 0.; });
  whole.converged = joining.empty() && !moves; // then P = 0 is the solution
  for (bool first = true; !joining.empty() || (first && moves); first = false) {
    S.insert(S.end(), joining.begin(), joining.end());
    std::sort(S.begin(), S.end());
    const Vector start_on_S = first && !has_start ? Vector() : restrict_to(S, whole.P);
    const unsigned int before = whole.iterations;
    const bool cycled = whole.cycled;
    whole = solve(BoundConstrainedQP(submatrix(C, S), restrict_to(S, F), restrict_to(S, balances)),
                  start_on_S);
    whole.iterations += before;
    whole.cycled = whole.cycled || cycled;
    Vector P(m);
    for (unsigned int i = 0; i < S.size(); ++i)
      P[S[i]] = whole.P[i];
    whole.P = P;
    Vector W = C.apply(P);
    if (moves)
      balances.B.vmult_add(W, whole.z);
    joining = find_outside(S, m, [&](const unsigned int i) { return W[i] - F[i] > 0.; });
  }
  return whole;
}
} // namespace Signorini
