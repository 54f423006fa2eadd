// SPDX-License-Identifier: LGPL-2.1-or-later
// The choice of a solver for the dual problem.

#include <signorini/base/errors.h>
#include <signorini/base/text.h>
#include <signorini/solvers/contact/active_set.h>
#include <signorini/solvers/contact/dual_solver.h>
#include <signorini/solvers/contact/psor.h>

#include <deal.II/lac/exceptions.h>

#include <sstream>

namespace Signorini
{
namespace
{
using Vector = dealii::Vector<double>;

std::string message_of(const dealii::ExceptionBase &exception)
{
  if (dynamic_cast<const dealii::LACExceptions::ExcSingular *>(&exception) != nullptr)
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
  catch (const dealii::ExceptionBase &exception)
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
} // namespace Signorini
