// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/solvers/contact/boundary_model.h>
#include <signorini/solvers/contact/contact_iteration.h>

namespace Signorini {
/**
 * Returns Q ≤ 0 with V = W + Ĉ (Q - P) ≤ 0 and Q.V = 0, by the primal-dual active set method,
 * begun with the set that P and W predict. Each of its steps is a BoundaryModel::solve for the
 * change Q - P. Where sets come back, it ends after 30 steps with an approximation, whose residual
 * the iteration around it measures.
 *
 * @param P ≤ 0.
 */
dealii::Vector<double> solve_boundary_problem(const BoundaryModel &model,
                                              const dealii::Vector<double> &W,
                                              const dealii::Vector<double> &P);

/**
 * Solves (5) by the primal-dual active set method, continued from the U, P and t of @p result. On a
 * set S MINRES solves
 *
 *     ( A     -D_S) (U  )   (f   )
 *     (-D_Sᵀ    0 ) (P_S) = (-G_S),    P = 0 elsewhere,
 *
 * with the preconditioner diag(V, (t Ĉ_1)_SS⁻¹), to a thousandth of the residual. Then S
 * is {P < 0} within S and {W > 0} outside.
 */
void solve_by_minres(const ContactSystem &system, const ContactIterationOptions &options,
                     ContactIterationResult &result);
} // namespace Signorini
