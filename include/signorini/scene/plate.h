// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/scene/side.h>

#include <deal.II/base/function.h>

#include <memory>

namespace Signorini
{
/** How far a plate has moved. */
struct PlateMotion
{
  /** delta, along the plate's direction (length). */
  double travel = 0.;
  /** theta, counter-clockwise about the plate's centre (radians, small). */
  double rotation = 0.;
};

/**
 * A side to which a rigid plate is bonded: u = delta d + theta (-(y - c2), x - c1) on it. Each of
 * the two motions is given, or the force or the moment that drives it is.
 */
struct Plate
{
  /** Number of the side in the geometry. */
  unsigned int side = 0;
  /** d, a unit vector. */
  dealii::Tensor<1, 2> direction;
  /** c, the middle of the side. */
  dealii::Point<2> centre;
  /** Whether a force drives the travel; otherwise it is given. */
  bool is_pushed = false;
  /** Along d (force per thickness); of a plate that is pushed. */
  double force = 0.;
  /** delta of a plate that is not pushed (length). */
  double travel = 0.;
  /** Whether a moment drives the rotation; otherwise it is zero. */
  bool turns = false;
  /** About c, counter-clockwise (force x length per thickness); of a plate that turns. */
  double moment = 0.;

  /** The displacement of the point @p x of the plate. */
  dealii::Tensor<1, 2> displacement(const PlateMotion &motion, const dealii::Point<2> &x) const;
  /** What the force and the moment that drive the plate do in a motion (force x length per
   * thickness). */
  double work(const PlateMotion &motion) const
  {
    return force * motion.travel + moment * motion.rotation;
  }
};

/** The displacement of a plate as data of its side. */
std::shared_ptr<const dealii::Function<2>> plate_displacement(const Plate &plate,
                                                              const PlateMotion &motion);
} // namespace Signorini
