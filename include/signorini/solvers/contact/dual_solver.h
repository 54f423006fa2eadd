// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/problem/parameters/options.h>
#include <signorini/solvers/contact/dual_problem.h>
#include <signorini/solvers/contact/mprgp.h>

#include <memory>

namespace Signorini
{
/** The options of the solution of the dual problem. */
struct DualSolverOptions
{
  ContactSolver method = ContactSolver::active_set;
  /** The factor ω of projected SOR, 0 < ω < 2. */
  double relaxation = 1.1;
  /** The tolerance of the KKT residual. */
  double tolerance = 1e-10;
  unsigned int maximum_iterations = 100000;
  /** Whether C may be singular: then QPResult::unique is determined. */
  bool may_be_singular = false;
  /** The preconditioner of MPRGP; none if it is empty. */
  SetPreconditioner preconditioner = {};
};

/**
 * Solves the dual problem with the bound zero by the chosen method. Where columns of C cost linear
 * solves, the active set method works on a growing set of patches. Where it fails because C is
 * singular (patches finer than the mesh: many pressures give the same displacement), projected SOR
 * finds one of the solutions, and QPResult::active_set_failure is set.
 *
 * @param start a pressure to start from; empty: none.
 */
QPResult solve_dual_problem(const std::shared_ptr<const ComplianceOperator> &C,
                            const dealii::Vector<double> &F,
                            const dealii::Vector<double> &start,
                            const DualSolverOptions &options);
} // namespace Signorini
