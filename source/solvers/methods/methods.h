// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/solvers/methods/contact_method.h>

namespace Signorini
{
/** By F, C and the dual problem. */
template <int dim>
std::unique_ptr<ContactMethod<dim>> make_dual_method(const Parameters &parameters,
                                                     const Scene<dim> &scene,
                                                     const SolverChoice &choice);

/** By V-cycles, each followed by a problem on the boundary. */
template <int dim>
std::unique_ptr<ContactMethod<dim>> make_cycle_method(const Parameters &parameters,
                                                      const Scene<dim> &scene);

/**
 * The energy norm of what a contact solver that stops at its tolerance leaves of the discrete
 * solution: for rho_k = P_k - projection of (P_k - W_k/C_kk), which the KKT residual consists of,
 *
 *     (c sum_k C_kk rho_k²)^{1/2}.
 *
 * Where the set of pressing patches is right, C (P - P*) = C_kk rho_k, and the energy of P - P* is
 * at most 1/lambda sum_k C_kk² rho_k² with the smallest eigenvalue lambda of C. c = C_kk/lambda is
 * below 6 for patches on a half-plane or half-space.
 * @param diagonal C_kk, zero where it is not known: where P_k = 0 and W_k <= 0.
 */
double algebraic_error(const AdmissibleSet &K,
                       const dealii::Vector<double> &P,
                       const dealii::Vector<double> &W,
                       const dealii::Vector<double> &diagonal);

/** Says that the contact solver cannot treat bodies and plates that move freely. */
[[noreturn]] void refuse_solver_for_free_motions(const SolverParameters &solver);
} // namespace Signorini
