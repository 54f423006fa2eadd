// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/problem/scene/rotation.h>

#include <deal.II/base/function.h>
#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <array>
#include <memory>

namespace Signorini {
/** The motion of a plate. */
template <int dim>
struct PlateMotion {
  /** The travel delta along the plate's direction (length). */
  double travel = 0.;
  /** The drift eta across the plate's direction: a number in the plane, a vector in space (length).
   */
  Rotation<dim> drift = {};
  /** The rotation theta about the plate's centre (radians, small). */
  Rotation<dim> rotation = {};

  /** Adds a multiple of another motion. */
  void add(const double factor, const PlateMotion &other) {
    travel += factor * other.travel;
    drift += factor * other.drift;
    rotation += factor * other.rotation;
  }
};

/** The force and the moment that act on the body through a plate (per thickness), as parts of the
 * work in its motions. */
template <int dim>
struct PlateForce {
  /** The force along the plate's direction. */
  double force = 0.;
  /** The force across it. */
  Rotation<dim> cross_force = {};
  /** The moment about the plate's centre. */
  Rotation<dim> moment = {};
};

/**
 * A side to which a rigid plate is bonded: u = delta d + eta d' + theta × (x - c) on it, where d'
 * is d turned counter-clockwise by a right angle; in space eta is a vector across d in the place of
 * eta d'. Each of the three motions is given, or the force or the moment that drives it is.
 */
template <int dim>
struct Plate {
  /** The number of the side in the geometry. */
  unsigned int side = 0;
  /** The direction d, a unit vector. */
  Tensor<1, dim> direction;
  /** The centre c: the middle of the side, of a closed one that of the box around it (of a circle
   * its centre). */
  Point<dim> centre;
  /** Whether a force drives the travel; otherwise it is given. */
  bool is_pushed = false;
  /** The force along d on a plate that is pushed (force per thickness). */
  double force = 0.;
  /** The travel delta of a plate that is not pushed (length). */
  double travel = 0.;
  /** Whether a force drives the drift; otherwise it is zero. */
  bool drifts = false;
  /** The force along d', in space that across d, on a plate that drifts (force per thickness). */
  Rotation<dim> cross_force = {};
  /** Whether a moment drives the rotation; otherwise it is zero. */
  bool turns = false;
  /** The moment about c on a plate that turns (force x length per thickness). */
  Rotation<dim> moment = {};

  /** Returns d', in space two directions across d. */
  std::array<Tensor<1, dim>, dim - 1> across() const;
  /** Returns the unit motions: the travel, the drifts along across(), and the rotations. */
  std::array<PlateMotion<dim>, n_rigid_motions<dim>> unit_motions() const;
  /** Returns whether a force or a moment drives a unit motion. */
  bool drives(const unsigned int k) const {
    return k == 0 ? is_pushed : k < dim ? drifts : turns;
  }
  /** Returns the displacement of the point @p x of the plate. */
  Tensor<1, dim> displacement(const PlateMotion<dim> &motion, const Point<dim> &x) const;
  /** Returns the work that the forces and the moment that drive the plate do in a motion (force x
   * length per thickness). */
  double work(const PlateMotion<dim> &motion) const {
    return force * motion.travel + cross_force * motion.drift + moment * motion.rotation;
  }
};

/** Returns the displacement of a plate as data of its side. */
template <int dim>
std::shared_ptr<const Function<dim>> plate_displacement(const Plate<dim> &plate,
                                                        const PlateMotion<dim> &motion);

} // namespace Signorini
