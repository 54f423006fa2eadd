// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/solvers/contact/dual_problem.h>

namespace Signorini {
/** Performs one sweep (ii) of the algorithm in place; a set that moves is K(P) of the beginning.
 * @return |P^{k+1} - P^k|₂. */
double psor_sweep(const BoundConstrainedQP &qp, double relaxation, dealii::Vector<double> &P);

/**
 * Solves the dual problem by the algorithm (i)-(iii), projected SOR:
 *
 *     λ_i = -(Σ_{j<i} C_ij P_j^{k+1} + Σ_{j>i} C_ij P_j^k - F_i)/C_ii,
 *     P_i^{k+1} = projection of (1 - ω) P_i^k + ω λ_i onto K.
 *
 * A block of two unknowns (a disc) takes one step with the largest eigenvalue of its part of C in
 * the place of C_ii.
 *
 * It stops when |P^{k+1} - P^k| ≤ tolerance |P^{k+1}| and the KKT residual is below the tolerance,
 * and goes on while the increments fall so slowly that the error, estimated from them, is above 50
 * times the tolerance. With balances this is the inner iteration of a proximal method: with a
 * small E,
 *
 *     (K + E) z_new = b + Bᵀ P + E z_old
 *
 * is inserted into W, which leaves a problem without balances and with the compliance
 * C + B (K + E)⁻¹ Bᵀ (R. T. Rockafellar, Math. Oper. Res. 1 (1976) 97-116: it converges for
 * every E).
 * @param start may be empty.
 * @throws std::invalid_argument for ω outside (0, 2).
 */
QPResult solve_by_psor(const BoundConstrainedQP &qp, const dealii::Vector<double> &start,
                       const IterationOptions &options);
} // namespace Signorini
