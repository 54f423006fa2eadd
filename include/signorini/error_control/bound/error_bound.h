// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/columns.h>
#include <signorini/error_control/contact_term/contact_lift.h>
#include <signorini/error_control/stress/energy_bracket.h>
#include <signorini/error_control/stress/equilibrated_stress.h>

#include <optional>
#include <string>
#include <vector>

namespace Signorini
{
/**
 * A guaranteed bound of the error of u_h in the energy norm |||v||| = a(v,v)^{1/2}, from a stress
 * tau in equilibrium (EquilibratedStress) and a lift w of what penetrates (ContactLift):
 *
 *     |||u - u_h|||² <= sum_K (‖sigma(u_h) - tau‖_{C^{-1},K} + osc_K)² + |||w|||²
 *                       + 2 int_{Gamma_c} p_H (u_{h,n} - g - w_n).
 *
 * Where u_h only interpolates prescribed displacements, |||z|||_K is added to osc_K and |||z||| to
 * the bound (PrescribedRest).
 *
 * The same tau and another w bound the error of pi^{2h} u_h. There tau_n, a linear function on
 * edges that press, takes the place of p_H.
 *
 * Norms are roots of energies (force x length per thickness).
 */
struct ErrorBound
{
  /** Why there is no bound, one sentence; empty if there is one. Then nothing else is known but the
   * penetration. */
  std::string missing;
  /** The bound of |||u - u_h|||. */
  std::optional<double> absolute;
  /** The same divided by |||u_h|||, or by what rounding makes of it where that is larger; infinite
   * where u_h vanishes. */
  std::optional<double> relative;
  /** The bound of |||u - pi^{2h} u_h|||, and the same divided like relative; none where cells have
   * no parents and on curved sides. */
  std::optional<double> post_absolute, post_relative;
  /** The parts of the bound for u_h: the first sum without oscillation, the oscillation of loads
   * and of prescribed displacements, and the contact part. */
  std::optional<double> mesh, oscillation, contact;
  /** Whether the bound is guaranteed; on curved sides it is an estimate (EquilibratedStress). */
  bool guaranteed = true;
  /** What curved sides add, an estimate; 0 for straight sides. */
  std::optional<double> geometry;
  /** The same as a share, like relative. */
  std::optional<double> relative_geometry;
  /** What the linear solver left unbalanced at nodes, relative to the forces there. */
  std::optional<double> algebra;
  /** Between these lies J(u); none on curved sides. */
  std::optional<double> energy_lower, energy_upper;
  /** Bound of the error of the contact force (force); none where contact meets a held side, and on
   * curved sides. */
  std::optional<double> force_error;
  /** max (u_{h,n} - g)_+ (length), and its place in words. */
  double penetration = 0.;
  std::string place_of_penetration;
  /** Which of the parts is the largest. */
  enum class Part
  {
    mesh,
    oscillation,
    contact
  };
  Part largest_part() const;
  /** In words: the cell with the largest part, and the contact face. */
  std::string largest_cell, largest_face;

  static Columns<ErrorBound> columns();
};

/**
 * Where the bound comes from (roots of energies); all empty where there is none:
 *
 *     sum_K ((mesh_K + oscillation_K)² + lift_K²) + sum_F contact_F² = (absolute - |||z|||)².
 */
struct BoundFields
{
  /** ‖sigma(u_h) - tau‖_{C^{-1},K}, osc_K and |||w|||_K by active cell; the last is zero on cells
   * of other ranks. */
  std::vector<double> mesh, oscillation, lift;
  /** (2 int_F p_H (u_{h,n} - g - w_n))^{1/2}, in the order of ContactSurface::faces(). */
  std::vector<double> contact;
};

/** A bound with its parts by cell and contact face. */
struct LocatedBound
{
  ErrorBound bound;
  BoundFields fields;
};

/** What contact_lift needs besides the data of the stress. */
struct BoundData
{
  StressData stress;
  const StiffnessInverse &inverse;
  const Coupling &condensed_D;
  const dealii::Vector<double> &G;
  /** J(u_h) = a(u_h, u_h)/2 - f(u_h) (force x length per thickness). */
  double energy;
};

/** Computes the bound for a plane body, guaranteed if its sides are straight and else an estimated
 * bound; missing says why there is none. Collective. */
LocatedBound compute_located_bound(const BoundData &data);

/** The same without its places. Collective. */
inline ErrorBound compute_error_bound(const BoundData &data)
{
  return compute_located_bound(data).bound;
}
} // namespace Signorini
