// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/scene/rigid_motions.h>

#include <optional>
#include <vector>

namespace Signorini
{
/**
 * A way to move that nothing prescribes: of plates that a force or a moment drives, of a body that
 * contact alone holds, or both at once. Displacements have the size one somewhere.
 */
struct FreeMotion
{
  /** How every plate of the scene moves. */
  std::vector<PlateMotion> plates;
  /** Where the whole body moves along without strain. */
  std::optional<RigidMotion> rigid;

  /** Of the forces and moments that drive the plates (force per thickness). */
  double work_of_plates(const std::vector<Plate> &plates_of_scene) const;
};

/** All free motions of a scene; none for most. */
struct FreeMotionBasis
{
  /** First the rigid ones, then motions of plates that strain the body. */
  std::vector<FreeMotion> seen;
  /** Rigid motions along which contact sides slide, as a disc turns or a block moves on a plane:
   * contact can neither stop nor cause them. */
  std::vector<FreeMotion> unseen;
};

/**
 * A basis: every motion that plates and supports allow is a combination of both kinds and of a
 * displacement that vanishes on plates and pins.
 */
FreeMotionBasis free_motions(const Scene<2> &scene);

/** Sum of q_j times the motion of each plate. */
std::vector<PlateMotion> combine_plates(const std::vector<FreeMotion> &motions,
                                        const std::vector<double> &q,
                                        std::size_t n_plates);
} // namespace Signorini
