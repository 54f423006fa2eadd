// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/columns.h>
#include <signorini/discretization/space/multiplier.h>
#include <signorini/postprocessing/quantities/contact_zones.h>

#include <optional>
#include <vector>

namespace Signorini {
/** Friction on one level (force per thickness, work per thickness, lengths; in space force, work,
 * areas). */
struct TangentialSummary {
  /** The force ∫ p_t along the tangents of the sides; in space the norm of the vector ∫ p_t. */
  double tangential_force = 0.;
  /** The work Σ s |w_t| of friction on the slip w_t = D_tᵀ U - G_t. */
  double dissipation = 0.;
  /** The lengths of the parts that stick, that slip and that are open. */
  double stick_length = 0.;
  double slip_length = 0.;
  double open_length = 0.;
  /** The share |∫ p_t| / ∫ s of the force that friction can carry, and the largest |p_t| / s. Where
   * the second is below one everything sticks, and would with that multiple of s, too. */
  double carried_share = 0., largest_share = 0.;
  /** The same parts as zones, in the plane. */
  std::vector<ContactZone> stick_zones, slip_zones;
  /** Coulomb: the smallest factor of the coefficient for which the linear system of these zones is
   * singular, and whether its determinant has the sign that it has without friction. Empty where
   * that is not known. */
  std::optional<double> critical_factor;
  std::optional<bool> is_regular;
  /** Coulomb: the rate of convergence of Tresca's problems with the pressure of the one before. */
  std::optional<double> fixed_point_rate;
  /** The error ‖q - q_H‖_{0,Γ_c}; empty where q is not known. */
  std::optional<double> l2_error;

  static Columns<TangentialSummary> columns();
};

/** Summarises friction. @param W the vector Dᵀ U - G. */
template <int dim>
TangentialSummary summarise_tangential_part(const MultiplierSpace<dim> &space,
                                            const Multiplier &multiplier,
                                            const dealii::Vector<double> &W);
} // namespace Signorini
