// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/columns.h>
#include <signorini/error_control/bound/contact_lift.h>
#include <signorini/error_control/equilibration/stress_bound.h>
#include <signorini/error_control/reference/reference_stress.h>

#include <optional>
#include <string>
#include <vector>

namespace Signorini {
/**
 * A guaranteed bound of the error of u_h in the energy norm |||v||| = a(v,v)^{1/2}, from a stress
 * τ in equilibrium (BestStress) and a lift w of the penetration (ContactLift):
 *
 *     |||u - u_h|||² ≤ Σ_K (‖σ(u_h) - τ‖_{E⁻¹,K} + osc_K)² + |||w|||²
 *                     + 2 ∫_{Γ_c} τ_n (u_{h,n} - g - w_n) + s |v| + τ_t v,
 *
 * with v = u_{h,t} - g_t - w_t.
 *
 * The last two terms belong to friction with the bound s (Tresca). For Coulomb's law s is f |τ_n|,
 * and the bound is conditional: it is that for the solution of Tresca's law with this s.
 *
 * Where u_h only interpolates prescribed displacements, |||z|||_K is added to osc_K and |||z||| to
 * the bound (PrescribedLift).
 *
 * E is Hooke's tensor. Norms are roots of energies (force x length per thickness).
 */
struct ErrorBound {
  /** The reason why there is no bound, one sentence; empty if there is a bound. Without a bound,
   * only the penetration is set, where there is a stress. */
  std::string missing;
  /** The bound of |||u - u_h|||. */
  std::optional<double> absolute;
  /** The bound divided by |||u_h|||, or by its rounding where that is larger; infinite
   * where u_h vanishes. */
  std::optional<double> relative;
  /** Where one graded run tells the errors of all levels (ReferenceStress): |||u - u_h||| =
   * distance ± margin. The bound is the upper end. */
  std::optional<double> distance, margin;
  /** The same for π^{2h} u_h, its bound, and that divided like relative. There are none where cells
   * have no parents and on curved bodies. */
  std::optional<double> post_distance, post_margin, post_absolute, post_relative;
  /** The parts of the bound for u_h: the first sum without oscillation, the oscillation of loads
   * and of prescribed displacements, and the contact part. */
  std::optional<double> mesh, oscillation, contact;
  /** Why the bound is only an estimate, one sentence; mostly empty. */
  std::string only_estimated;
  bool is_guaranteed() const {
    return only_estimated.empty() && !is_conditional;
  }
  /** Whether friction is Coulomb's: u is the solution of Tresca's law with s = f |τ_n|. */
  bool is_conditional = false;
  /** The residual force of the tractions on a cell, relative to the largest one. */
  std::optional<double> algebra;
  /** The bounds between which J(u) lies. */
  std::optional<double> energy_lower, energy_upper;
  /** The bound of the error of the contact force (force); none where contact meets a held side.
   */
  std::optional<double> force_error;
  /** The penetration max (u_{h,n} - g)_+ (length), and its position in words. */
  std::optional<double> penetration;
  std::string place_of_penetration;
  /** The parts of the bound; dominant_part() returns the largest one. */
  enum class Part { mesh, oscillation, contact };
  Part dominant_part() const;
  /** The cell with the largest part and the contact face with the largest part, in words. */
  std::string largest_cell, worst_face;

  static Columns<ErrorBound> columns();
};

/**
 * The parts of the bound by cell and contact face (roots of energies); all are empty where there is
 * no bound:
 *
 *     Σ_K ((mesh_K + oscillation_K)² + lift_K²) + Σ_F contact_F² = (absolute - |||z|||)².
 */
struct BoundFields {
  /** The norms ‖σ(u_h) - τ‖_{E⁻¹,K}, osc_K and |||w|||_K by active cell; the last is zero
   * on cells of other ranks. */
  std::vector<double> mesh, oscillation, lift;
  /** The roots (2 ∫_F p_H (u_{h,n} - g - w_n))^{1/2}, in the order of ContactSurface::faces(). */
  std::vector<double> contact;
};

/** A bound, its parts by cell and contact face, and its stress. */
struct LocatedBound {
  ErrorBound bound;
  BoundFields fields;
  /** The stress of the bound, if it is wanted, on graded meshes, where the bound is proved. */
  std::optional<ReferenceStress> reference;
};

/** Returns the part of a curved body that the proof of the bound covers on no mesh, one sentence;
 * empty if there is none. */
std::string gap_on_all_meshes(const DisplacedBody<2> &body);

/** Computes the bound of a 2-D body. ErrorBound::missing has the reason if there is none.
 * Collective. @param keeps_stress whether to make LocatedBound::reference. */
LocatedBound compute_located_bound(const BoundData &data, bool keeps_stress);
} // namespace Signorini
