// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/error_control/equilibration/best_stress.h>
#include <signorini/error_control/reference/boundary_traction.h>

#include <optional>

namespace Signorini {
/** An interval value ± margin. */
struct WithMargin {
  double value, margin;

  double lower() const {
    return value - margin;
  }
  double upper() const {
    return value + margin;
  }
};

/**
 * A stress in equilibrium, as far as others need it: it tells the error |||v - u||| of any
 * continuous displacement v of the body, on any mesh and with any values on the boundary.
 *
 * Let τ be in equilibrium with the loads, s ≥ ‖σ(u) - τ‖, and with the true loads
 *
 *     E(v) = |||v|||² - 2 f(v) - 2 ∫_{Γ_F} t·v - 2 ∫_{Γ∖Γ_F} τn·v.
 *
 * As ∫ τ:ε(v) is the sum of the works, ‖σ(v) - τ‖² = E(v) + ‖τ‖², and by the triangle inequality
 *
 *     D - s ≤ |||v - u||| ≤ D + s,   D² = ‖σ(v) - τ‖² = E(v) - E(u_g) + ‖σ(u_g) - τ‖²,
 *
 * where u_g is the displacement on the graded mesh of τ: the differences lose no digits. The stress
 * of BestStress balances projections of the loads only. τ is that stress and the one of norm ω that
 * balances the rest; both have the same traction where none is given, so that E does not change.
 */
struct ReferenceStress {
  /** Returns D ± (s and the rests of quadrature), roots of energies. */
  WithMargin distance(const FieldWorks &v) const;
  /** Returns E(v). */
  double energy(const FieldWorks &v) const;

  BoundaryTraction traction;
  /** The sides on which it acts. */
  std::vector<Side<2>> sides;
  /** E(u_g), with the rest of its quadrature. */
  WithMargin energy_of_graded;
  /** The distance ‖σ(u_g) - τ‖ or more, without and with ω. */
  double misfit, misfit_with_rest;
  /** The bound s, of τ with ω. */
  double stress_error;
  /** |||u_g|||. */
  double energy_norm;
  /** The bracket of J(u), as the graded run has it, and ∫_{Γ_c} τ_n with a bound of its error. */
  std::optional<Bracket> J;
  std::optional<WithMargin> contact_force;
  /** Whether friction is Coulomb's: u is the solution of Tresca's law with s = f |τ_n|. */
  bool is_conditional = false;
};

/** Makes the reference from the stress of a graded level, without its bracket and its force.
 * @param stress_error s. Collective. */
ReferenceStress make_reference(const BoundData &data, const BestStress &best, double stress_error);
} // namespace Signorini
