// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace Signorini {
/** Two numbers between which a quantity lies. */
struct Bracket {
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
inline Bracket energy_bracket(const Bracket &dual_energy, const double eta, const double lift_norm,
                              const double contact_term) {
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
inline double stress_error_bound(const double eta, const double lift_norm,
                                 const double contact_term) {
  return lift_norm + std::sqrt(std::max(0., lift_norm * lift_norm + eta * eta + 2. * contact_term));
}

/**
 * Returns a bound of the error of the contact force: |∫_{Γ_c} (σ_n - τ_n)| <=
 * error_bound |||z|||, for z in V with z_n = 1 on Γ_c.
 *
 * @param error_bound a bound of ‖σ(u) - τ‖ (stress_error_bound()): the difference is ∫
 * (σ(u) - τ):ε(z). Or, with p_H instead of τ_n, for z in V^h and loads that were
 * integrated exactly without StrainOperator::mean_dilatation, a bound of |||u - u_h|||: then the
 * difference is also a(u - u_h, z).
 * @param lift_norm |||z|||, see norm_of_unit_lift().
 */
inline double contact_force_bound(const double error_bound, const double lift_norm) {
  return error_bound * lift_norm;
}

/** The bound of the error of a displacement by a stress in equilibrium. All values are energies
 * (force x length per thickness) or roots of energies. */
struct StressBound {
  /** The norm |||u_h|||. */
  double energy_norm = 0.;
  /** The misfit ‖σ(u_h) - τ‖_{E⁻¹,K} of every cell, in the order of active cells, and the
   * oscillation osc_K: a stress of at most this norm balances, together with τ, the loads
   * themselves. Where the stress has a mesh of its own, the sums are divided among the cells like
   * |||π^{2h} u_h - u_h|||_K. */
  std::vector<double> misfit, oscillation;
  /** The sum over K of (misfit_K + osc_K)². */
  double square = 0.;
  /** The sum over K of osc_K². */
  double oscillation_square = 0.;
  /** The norm |||z||| of the PrescribedLift, which makes up for prescribed displacements that are
   * no polynomials along edges and is zero elsewhere. The bound is for u_h + z; that for u_h is
   * larger by |||z|||. */
  double lift = 0.;
  /** Bounds of J*(τ) + ∫ τ_n d over Γ_c for the stress that balances the loads themselves, with
   * d = u_{h,n} - g; none where they would say little. */
  std::optional<Bracket> complementary_energy;
  /** The largest difference between a prescribed displacement and its interpolation on an edge,
   * relative to PrescribedLift's rest there. */
  double lift_misfit = 0.;
};
} // namespace Signorini
