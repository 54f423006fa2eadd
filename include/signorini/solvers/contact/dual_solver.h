// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/problem/parameters/options.h>
#include <signorini/solvers/contact/dual_problem.h>
#include <signorini/solvers/contact/projected_methods.h>

#include <functional>
#include <memory>
#include <vector>

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

/** A solver of the dual problem that gets a start, which may be empty. */
using QPSolver =
  std::function<QPResult(const BoundConstrainedQP &qp, const dealii::Vector<double> &start)>;

/**
 * Solves the dual problem over P ≤ 0 where columns of C are expensive. It is solved on a set S of
 * patches, with P = 0 elsewhere; then the patches with W = C P - F > 0 join S, until there are
 * none. The result solves the whole problem, and only the columns of S are computed.
 *
 * @param start a pressure; S begins with the patches that press in it, and their neighbours; if
 * nothing presses, with the patches where F < 0.
 */
QPResult solve_on_growing_set(const ComplianceOperator &C,
                              const dealii::Vector<double> &F,
                              const dealii::Vector<double> &start,
                              const QPSolver &solve);

/** The options of the active set method. */
struct ActiveSetOptions
{
  /** The tolerance of the KKT residual. */
  double tolerance = 1e-10;
  /** The largest number of linear solves. */
  unsigned int maximum_iterations = 100000;
};

/**
 * Solves the dual problem by the primal-dual active set method, i.e. the semi-smooth Newton method
 * for P = projection of P - W/diag C onto K. Each unknown is inside of its interval (active, in
 * contact) or at one of its ends. With the active set A and the ends e_I of the others,
 * C_AA P_A = F_A - C_AI e_I,  P_I = e_I.
 *
 * It ends when a set predicts itself, or when the residual is at the level of rounding (where P and
 * W vanish together on many patches, the sets could differ for ever). When a set comes back, single
 * exchanges (the lowest wrong index changes sides, Murty's rule) end the search: for positive
 * definite C no set can come back under that rule.
 *
 * @param start a pressure that gives the first states; empty: every unknown is active.
 */
QPResult solve_by_active_set(const BoundConstrainedQP &qp,
                             const dealii::Vector<double> &start,
                             const ActiveSetOptions &options);
} // namespace Signorini
