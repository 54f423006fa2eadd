// SPDX-License-Identifier: LGPL-2.1-or-later
// The choice of a solver for the dual problem.

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

/** Returns how many sweeps projected SOR may take in the place of the active set method: some
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
  const BoundConstrainedQP qp(C, F, K, balances);
  QPResult result = by_chosen_method(qp, start, options);
  result.unique = !options.may_be_singular || qp.has_unique_solution(result.P, result.z);
  return result;
}
} // namespace Signorini
