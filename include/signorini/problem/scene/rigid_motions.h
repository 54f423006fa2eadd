// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/problem/scene/rotation.h>
#include <signorini/problem/scene/scene.h>

#include <string>
#include <vector>

namespace Signorini {
/** A rigid velocity field t + omega × (x - x0), of size one on a body. */
template <int dim>
struct BodyMotion {
  /** The name of the body; empty if there is only one. */
  std::string name;
  /** The translation t. */
  Tensor<1, dim> translation;
  /** The rotation as omega L. */
  Rotation<dim> rotation = {};
  /** The centre x0 of the box around the body. */
  Point<dim> centre;
  /** The diameter L of the whole geometry (length). */
  double size = 1.;

  /** Returns the velocity at a point. */
  Tensor<1, dim> velocity(const Point<dim> &x) const;
  /** Returns the larger one of |t| and |omega L|. */
  double speed() const;
};

/** The motions of all bodies. */
template <int dim>
struct RigidMotion {
  std::vector<BodyMotion<dim>> bodies;

  bool is_translation() const;
  /** Returns "the translation along (0, 1)" or "the rotation about (1, 2)", in space "about the
   * line through (0, 0, 1) along (1, 0, 0)", with the names of bodies if there are several. */
  std::string name() const;
  /** Returns "along (0, -1)" or "clockwise about (1, 2)": the direction counts. In space a body
   * turns counter-clockwise for those who look against the line. */
  std::string direction() const;
};

/** Returns the sum of weights times motions of the same bodies. */
template <int dim>
RigidMotion<dim> combine(const std::vector<RigidMotion<dim>> &motions,
                         const std::vector<double> &weights);

/** The state of plates that a force or a moment drives: they are held, or move as the force lets
 * them. */
enum class Plates { held, released };

/**
 * Returns a basis of the rigid motions that clamped, prescribed and roller sides leave free, first
 * all translations among them; A is singular exactly if there are any with plates held. Those of
 * bodies that move independently move one body each. (Contact sides do not hold: they may open.)
 */
template <int dim>
std::vector<RigidMotion<dim>> free_rigid_motions(const Scene<dim> &scene,
                                                 Plates plates = Plates::held);

} // namespace Signorini
