// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <algorithm>
#include <cmath>

namespace Signorini
{
/** Two numbers between which a quantity lies. */
struct Bracket
{
  double lower;
  double upper;
};

/**
 * Returns bounds of the energy of the exact solution,
 *
 *     -J*(τ) ≤ J(u) ≤ -J*(τ) + 1/2 (η + |||w|||)² + ∫_{Γ_c} τ_n (ũ_n - g - w_n).
 *
 * J(u_h) alone is no bound: u_h may penetrate.
 *
 * @param dual_energy bounds of J*(τ) of a stress in equilibrium
 * @param eta the sum of cells of ‖σ(ũ) - τ‖ and oscillation, in the norm of stresses
 * @param lift_norm |||w|||
 * @param contact_term ∫_{Γ_c} τ_n (ũ_n - g - w_n)
 */
inline Bracket energy_bracket(const Bracket &dual_energy,
                              const double eta,
                              const double lift_norm,
                              const double contact_term)
{
  const double gap = 0.5 * (eta + lift_norm) * (eta + lift_norm) + contact_term;
  return {-dual_energy.upper, -dual_energy.lower + gap};
}

/**
 * Returns a bound of ‖σ(u) - τ‖ in the norm of stresses, by the identity behind the bound of
 * the energy error: with s = ‖σ(u) - τ‖,
 *
 *     |||u - ũ|||² + s² ≤ η² + 2 s |||w||| + 2 T,   T = ∫_{Γ_c} τ_n (ũ_n - g - w_n),
 *
 * so s ≤ |||w||| + (|||w|||² + η² + 2 T)^{1/2}.
 */
inline double stress_error_bound(const double eta,
                                 const double lift_norm,
                                 const double contact_term)
{
  return lift_norm + std::sqrt(std::max(0., lift_norm * lift_norm + eta * eta + 2. * contact_term));
}

/**
 * Returns a bound of the error of the contact force: |∫_{Γ_c} (σ_n - τ_n)| <=
 * error_bound |||z|||, for z in V with z_n = 1 on Γ_c.
 *
 * @param error_bound a bound of ‖σ(u) - τ‖ (stress_error_bound()): the difference is ∫
 * (σ(u) - τ):ε(z). Or, with p_H in place of τ_n, for z in V^h and loads that were
 * integrated exactly without StrainOperator::mean_dilatation, a bound of |||u - u_h|||: then the
 * difference is also a(u - u_h, z).
 * @param lift_norm |||z|||, see norm_of_unit_lift().
 */
inline double contact_force_bound(const double error_bound, const double lift_norm)
{
  return error_bound * lift_norm;
}
} // namespace Signorini
