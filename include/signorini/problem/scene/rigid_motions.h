// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/problem/scene/scene.h>

#include <optional>
#include <string>
#include <vector>

namespace Signorini
{
/** A velocity field t + omega (-(y - y0), x - x0) of the plane, of size one on the body. */
struct RigidMotion
{
  /** t. */
  dealii::Tensor<1, 2> translation;
  /** omega L. */
  double rotation = 0.;
  /** (x0, y0), the centre of the box around the body. */
  dealii::Point<2> centre;
  /** L, the diameter of the body (length). */
  double size = 1.;

  /** The velocity at a point. */
  dealii::Tensor<1, 2> velocity(const dealii::Point<2> &x) const;
  bool is_translation() const;
  /** "the translation along (0, 1)" or "the rotation about (1, 2)". */
  std::string name() const;
  /** "along (0, -1)" or "clockwise about (1, 2)": the direction counts. */
  std::string direction() const;
};

/** Sum of weights times motions of the same body. */
RigidMotion combine(const std::vector<RigidMotion> &motions, const std::vector<double> &weights);

/** Whether plates that a force or a moment drives are held, or move as the force lets them. */
enum class Plates
{
  held,
  released
};

/**
 * The rigid motions that clamped, prescribed and roller sides leave free; A is singular exactly if
 * there are any with plates held. (Contact sides do not hold: they may open.)
 */
std::vector<RigidMotion> free_rigid_motions(const Scene<2> &scene, Plates plates = Plates::held);

/** The names of the rigid motions that clamped, prescribed and roller sides of a box leave free:
 * "the translation along x", "the rotation about the y-axis". */
std::vector<std::string> free_rigid_motions(const Scene<3> &scene);

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
