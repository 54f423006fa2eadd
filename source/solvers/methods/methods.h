// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/solvers/methods/contact_method.h>

namespace Signorini {
/** Makes the method that forms F and C and solves the dual problem. */
template <int dim>
std::unique_ptr<ContactMethod<dim>> make_dual_method(const Parameters &parameters,
                                                     const Scene<dim> &scene,
                                                     const SolverChoice &choice);

/** Makes the method by V-cycles, each followed by a problem on the boundary. */
template <int dim>
std::unique_ptr<ContactMethod<dim>> make_cycle_method(const Parameters &parameters,
                                                      const Scene<dim> &scene);

/**
 * Returns the estimated algebraic error, in the energy norm, of a contact solver that stops at its
 * tolerance: with ρ_k = P_k - projection of (P_k - W_k/C_kk), which the KKT residual consists of,
 *
 *     (c Σ_k C_kk ρ_k²)^{1/2}.
 *
 * Where the set of pressing patches is right, C (P - P*) = C_kk ρ_k, and the energy of P - P* is at
 * most 1/λ Σ_k C_kk² ρ_k² with the smallest eigenvalue λ of C. c = C_kk/λ is below 6 for patches on
 * a half-plane or half-space.
 * @param diagonal C_kk, or zero where it is not computed: where P_k = 0 and W_k ≤ 0.
 */
double algebraic_error(const AdmissibleSet &K, const dealii::Vector<double> &P,
                       const dealii::Vector<double> &W, const dealii::Vector<double> &diagonal);
} // namespace Signorini
