// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/discretization/space/displaced_body.h>

#include <optional>

namespace Signorini {
/** The nodal forces of the stress of a displacement. */
template <int dim>
struct InternalForces {
  /** The forces (a(φ_j, φ_i))_ij U for all i, constrained or not (force per thickness). */
  DualVector forces;
  /** The sums |A| |U|, cell by cell. Times the unit roundoff they bound the rounding errors of the
   * forces. */
  DualVector magnitudes;
  /** The norm a(U, U)^{1/2} with the strain of the element (root of force x length^{dim-1}), from
   * displacements relative to a corner of each cell: a rigid translation, however large, has no
   * energy. */
  double energy_norm = 0.;
};

/** Integrates the forces. Collective. */
template <int dim>
InternalForces<dim> internal_forces(const DisplacedBody<dim> &body);

/** Returns, where the body moves as a whole, the energy norm that such a displacement has if it
 * strains the body: max|u_h| E_0^{1/2} l^{(dim-2)/2} with the unit of stiffness_unit(); max|u_h|
 * counts as at least 1e-6 of the body's size. |||u_h|||, forces and their errors are only rounding
 * then, or the remainder of the linear solver. Returns none where the body is strained. Collective.
 */
template <int dim>
std::optional<double> norm_of_rigid_motion(const DisplacedBody<dim> &body);

/** The divisor of errors in the energy norm (root of force x length^{dim-1}). */
struct EnergyScale {
  /** The norm |||u_h|||. */
  double norm = 0.;
  /** The result of norm_of_rigid_motion(). */
  std::optional<double> rigid;

  /** Returns |||u_h|||. Where the body moves rigidly, |||u_h||| is rounding; the scale of an error
   * that is rounding, too, is norm_of_rigid_motion(), and a larger error is all of |||u|||. */
  double of(const double error) const {
    constexpr double rounding = 1e-7;
    if (!rigid)
      return norm;
    return error <= rounding * *rigid ? *rigid : error;
  }
};
} // namespace Signorini
