// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/columns.h>
#include <signorini/discretization/multiplier/multiplier_space.h>
#include <signorini/postprocessing/quantities/contact_zones.h>

#include <optional>
#include <vector>

namespace Signorini {
/** What the body does at the node of a multiplier, on most meshes on a patch. The numbers are those
 * of contact-LL.csv. */
enum class FrictionState { open = 0, stick = 1, slip = 2 };

/** Returns the state at every node: it is open where nothing presses, and sticks where P_t is
 * inside of its interval or disc. @param P the vector (P_n, P_t). */
std::vector<FrictionState> friction_states(const AdmissibleSet &K, const dealii::Vector<double> &P);

/** Returns numbers that differ between nodes in different zones: whether they press, and whether
 * P_t is at the lower or the upper end of its interval, or inside. @param P_t is empty without
 * friction. */
std::vector<int> zone_states(const AdmissibleSet &K, const Pressure &P, const Pressure &P_t);

/** Returns for every patch whether it sticks at all nodes; no patch does without friction. */
std::vector<bool> sticking_patches(const MultiplierSpace<2> &multipliers, const AdmissibleSet &K,
                                   const Pressure &P, const Pressure &P_t);

/** Returns the shares of P_t in its bounds. */
Pressure friction_shares(const AdmissibleSet &K, const Pressure &P, const Pressure &P_t);

/** Returns the same shares of the bounds that belong to another P, so that an active set method
 * begins with the states that the shares come from. */
Pressure friction_of_shares(const AdmissibleSet &K, const Pressure &P, const Pressure &shares);

/** Friction on one level (force per thickness, work per thickness, lengths; in space force, work,
 * areas). */
struct FrictionSummary {
  /** The force ∫ p_t along the tangents of the sides; in space the norm of the vector ∫ p_t. */
  double tangential_force = 0.;
  /** The work Σ s |w_t| of friction on the slip w_t = D_tᵀ U - G_t. */
  double dissipation = 0.;
  /** The lengths of the parts that stick, that slip and that are open. */
  double stick_length = 0.;
  double slip_length = 0.;
  double open_length = 0.;
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

  static Columns<FrictionSummary> columns();
};

/** Summarises friction. @param P the vector (P_n, P_t). @param W the vector Dᵀ U - G. */
template <int dim>
FrictionSummary summarise_friction(const MultiplierSpace<dim> &multipliers, const AdmissibleSet &K,
                                   const dealii::Vector<double> &P,
                                   const dealii::Vector<double> &W);
} // namespace Signorini
