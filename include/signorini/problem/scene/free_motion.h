// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/problem/scene/rigid_motions.h>
#include <signorini/problem/scene/scene.h>

#include <optional>
#include <vector>

namespace Signorini {
/**
 * A motion that nothing prescribes: of plates that a force or a moment drives, of a body that
 * contact alone holds, or of both at once. Its displacement has the size one somewhere.
 */
template <int dim>
struct FreeMotion {
  /** The motion of every plate of the scene. */
  std::vector<PlateMotion<dim>> plates;
  /** The rigid motion of the whole body; empty if the motion strains the body. */
  std::optional<RigidMotion<dim>> rigid;

  /** Returns the work of the forces and moments that drive the plates (force per thickness). */
  double work_of_plates(const std::vector<Plate<dim>> &plates_of_scene) const;
};

/** All free motions of a scene; most scenes have none. */
template <int dim>
struct FreeMotionBasis {
  /** The motions that change the gap or strain the body: first the rigid ones, then motions of
   * plates that strain the body. */
  std::vector<FreeMotion<dim>> resisted;
  /** Rigid motions along which contact sides slide, as a disc turns or a block moves on a plane:
   * contact without friction can neither stop nor cause them. */
  std::vector<FreeMotion<dim>> neutral;
};

/**
 * Returns a basis: every motion that plates and supports allow is a combination of both kinds and
 * of a displacement that vanishes on plates and pins.
 */
template <int dim>
FreeMotionBasis<dim> free_motions(const Scene<dim> &scene);

/** Returns the sum of q_j times the motion of each plate. */
template <int dim>
std::vector<PlateMotion<dim>> combine_plates(const std::vector<FreeMotion<dim>> &motions,
                                             const std::vector<double> &q, std::size_t n_plates);
} // namespace Signorini
