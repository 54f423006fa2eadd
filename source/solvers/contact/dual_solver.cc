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
using Indices = ComplianceOperator::Indices;

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

/** Solves by the chosen method; where the active set method fails, by projected SOR. */
QPResult attempt(const BoundConstrainedQP &qp, const Vector &start,
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

/** Solves, and examines whether the solution is unique where that is wanted. */
QPResult attempt_and_examine(const BoundConstrainedQP &qp, const Vector &start,
                             const DualSolverOptions &options) {
  QPResult result = attempt(qp, start, options);
  result.unique = !options.may_be_singular || qp.has_unique_solution(result.P, result.z);
  return result;
}

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

/** Solves on a set of patches that grows. */
QPResult solve_on_growing_set(const ComplianceOperator &C, const Vector &F, const Vector &start,
                              const DualSolverOptions &options, const Balances &balances) {
  const unsigned int m = F.size();
  const bool moves = balances.size() > 0;
  QPResult whole;
  whole.P = start.size() > 0 ? start : Vector(m);
  const auto presses = [&](const unsigned int i) {
    return i < m && (whole.P[i] < 0. || (moves && balances.P[i] < 0.));
  };
  // Ends of contact move by a patch or so; i - 1 wraps around at zero.
  std::vector<bool> belongs(m);
  for (unsigned int i = 0; i < m; ++i)
    belongs[i] = presses(i) || presses(i - 1) || presses(i + 1);
  if (indices_of(belongs).empty())
    for (unsigned int i = 0; i < m; ++i)
      belongs[i] = F[i] < 0.;
  // A body that moves has balances also where nothing presses.
  bool grows = moves || !indices_of(belongs).empty();
  whole.converged = !grows;
  while (grows) {
    const Indices S = indices_of(belongs);
    const Vector start_on_S = whole.P.all_zero() ? Vector() : restrict_to(S, whole.P);
    QPResult part = attempt_and_examine(
      {submatrix(C, S), restrict_to(S, F), restrict_to(S, balances)}, start_on_S, options);
    part.iterations += whole.iterations;
    part.cycled = part.cycled || whole.cycled;
    Vector P(m);
    P.add(S, part.P);
    whole = part;
    whole.P = P;
    Vector W = C.apply(P);
    if (moves)
      balances.B.vmult_add(W, whole.z);
    grows = false;
    for (unsigned int i = 0; i < m; ++i)
      if (!belongs[i] && W[i] - F[i] > 0.)
        belongs[i] = grows = true;
  }
  return whole;
}
} // namespace

QPResult solve_dual_problem(const std::shared_ptr<const ComplianceOperator> &C, const Vector &F,
                            const AdmissibleSet &K, const Vector &start,
                            const DualSolverOptions &options, const Balances &balances) {
  if (options.method != ContactSolver::psor && !C->is_explicit() && K.is_nonpositive())
    return solve_on_growing_set(*C, F, start, options, balances);
  return attempt_and_examine({C, F, K, balances}, start, options);
}
} // namespace Signorini
