// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/problem/scene/scene.h>

#include <string>
#include <vector>

namespace Signorini {
/** A rigid velocity field t + omega (-(y - y0), x - x0) in 2-D, of size one on a body. */
struct BodyMotion {
  /** The name of the body; empty if there is only one. */
  std::string name;
  /** The translation t. */
  Tensor<1, 2> translation;
  /** The rotation as omega L. */
  double rotation = 0.;
  /** The centre (x0, y0) of the box around the body. */
  Point<2> centre;
  /** The diameter L of the whole geometry (length). */
  double size = 1.;

  /** Returns the velocity at a point. */
  Tensor<1, 2> velocity(const Point<2> &x) const;
  /** Returns the larger one of |t| and |omega L|. */
  double speed() const;
};

/** The motions of all bodies. */
struct RigidMotion {
  std::vector<BodyMotion> bodies;

  bool is_translation() const;
  /** Returns "the translation along (0, 1)" or "the rotation about (1, 2)", with the names of
   * bodies if there are several. */
  std::string name() const;
  /** Returns "along (0, -1)" or "clockwise about (1, 2)": the direction counts. */
  std::string direction() const;
};

/** Returns the sum of weights times motions of the same bodies. */
RigidMotion combine(const std::vector<RigidMotion> &motions, const std::vector<double> &weights);

/** The state of plates that a force or a moment drives: they are held, or move as the force lets
 * them. */
enum class Plates { held, released };

/**
 * Returns the rigid motions that clamped, prescribed and roller sides leave free; A is singular
 * exactly if there are any with plates held. (Contact sides do not hold: they may open.)
 */
std::vector<RigidMotion> free_rigid_motions(const Scene<2> &scene, Plates plates = Plates::held);

/** Returns the names of the rigid motions that clamped, prescribed and roller sides of a box leave
 * free: "the translation along x", "the rotation about the y-axis". */
std::vector<std::string> free_rigid_motions(const Scene<3> &scene);

} // namespace Signorini
