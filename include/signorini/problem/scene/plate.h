// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>

#include <deal.II/base/function.h>
#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <memory>

namespace Signorini {
/** The motion of a plate. */
struct PlateMotion {
  /** The travel delta along the plate's direction (length). */
  double travel = 0.;
  /** The drift eta across the plate's direction (length). */
  double drift = 0.;
  /** The rotation theta, counter-clockwise about the plate's centre (radians, small). */
  double rotation = 0.;
};

/**
 * A side to which a rigid plate is bonded: u = delta d + eta d' + theta (-(y - c2), x - c1) on it,
 * where d' is d turned counter-clockwise by a right angle. Each of the three motions is given, or
 * the force or the moment that drives it is.
 */
struct Plate {
  /** The number of the side in the geometry. */
  unsigned int side = 0;
  /** The direction d, a unit vector. */
  Tensor<1, 2> direction;
  /** The centre c: the middle of the side, of a closed one that of the box around it (of a circle
   * its centre). */
  Point<2> centre;
  /** Whether a force drives the travel; otherwise it is given. */
  bool is_pushed = false;
  /** The force along d on a plate that is pushed (force per thickness). */
  double force = 0.;
  /** The travel delta of a plate that is not pushed (length). */
  double travel = 0.;
  /** Whether a force drives the drift; otherwise it is zero. */
  bool drifts = false;
  /** The force along d' on a plate that drifts (force per thickness). */
  double cross_force = 0.;
  /** Whether a moment drives the rotation; otherwise it is zero. */
  bool turns = false;
  /** The moment about c, counter-clockwise, on a plate that turns (force x length per thickness).
   */
  double moment = 0.;

  /** Returns d'. */
  Tensor<1, 2> across() const {
    return -cross_product_2d(direction);
  }
  /** Returns the displacement of the point @p x of the plate. */
  Tensor<1, 2> displacement(const PlateMotion &motion, const Point<2> &x) const;
  /** Returns the work that the forces and the moment that drive the plate do in a motion (force x
   * length per thickness). */
  double work(const PlateMotion &motion) const {
    return force * motion.travel + cross_force * motion.drift + moment * motion.rotation;
  }
};

/** Returns the displacement of a plate as data of its side. */
std::shared_ptr<const Function<2>> plate_displacement(const Plate &plate,
                                                      const PlateMotion &motion);

} // namespace Signorini
