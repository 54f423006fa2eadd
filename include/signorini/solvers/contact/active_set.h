// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/solvers/contact/dual_problem.h>

#include <functional>
#include <vector>

namespace Signorini
{
/** A solver of the dual problem with a start, which may be empty. */
using QPSolver =
  std::function<QPResult(const BoundConstrainedQP &qp, const dealii::Vector<double> &start)>;

/**
 * The dual problem with the bound zero where columns of C are expensive: solved on a set K of
 * patches, with P = 0 elsewhere; then the patches with W = C P - F > 0 join K, until there are
 * none. The answer solves the whole problem, and only the columns of K were needed.
 *
 * @param start K begins with the patches that press in it, and their neighbours; where nothing
 * presses, with F < 0.
 */
QPResult solve_on_growing_set(const ComplianceOperator &C,
                              const dealii::Vector<double> &F,
                              const dealii::Vector<double> &start,
                              const QPSolver &solve);

/** What the active set method is told. */
struct ActiveSetOptions
{
  /** For the KKT residual. */
  double tolerance = 1e-10;
  /** Linear solves before giving up. */
  unsigned int maximum_iterations = 100000;
};

/**
 * Primal-dual active set method, i.e. the semi-smooth Newton method for
 * P = min(bound, P - W/diag C): patch i is active (in contact) iff P_i - W_i/C_ii < bound_i. With
 * the active set A,  C_AA P_A = F_A - C_AI bound_I,  P_I = bound_I.
 *
 * It ends when a set predicts itself, or when the residual is at the level of rounding (where P and
 * W vanish together on many patches, the sets could differ for ever). When a set comes back, single
 * exchanges (the lowest wrong index changes sides, Murty's rule) end the search: for positive
 * definite C no set can come back under that rule.
 *
 * @param start the first active set is taken from it; empty: every patch is active.
 */
QPResult solve_by_active_set(const BoundConstrainedQP &qp,
                             const dealii::Vector<double> &start,
                             const ActiveSetOptions &options);
} // namespace Signorini
