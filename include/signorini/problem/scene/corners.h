// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/problem/scene/scene.h>
#include <signorini/problem/scene/wedges.h>

#include <deal.II/base/symmetric_tensor.h>

#include <array>
#include <functional>
#include <vector>

namespace Signorini {
/**
 * Returns the layer of a wedge that has the material of Hooke's tensor. Kolosov's constant (lambda
 * + 3 mu)/(lambda + mu) is 3 - 4 nu in plane strain and (3 - nu)/(1 + nu) in plane stress. An
 * anisotropic tensor is replaced by its mean over all plane rotations, which is the isotropic
 * tensor nearest to it in the sum of squares of E_ijkl. The exponents of such a body are
 * approximations.
 * @param angle the opening (radians).
 */
WedgeLayer make_layer(const SymmetricTensor<4, 2> &hooke, double angle);

/** A point where two sides of a 2-D body meet, also at a straight angle, or where one side has a
 * corner (Curve::corners()) or an interface of materials ends. */
struct Corner {
  Point<2> position;
  /** The angle between the tangents inside the body, 0 < angle <= 2 pi (radians). */
  double angle;
  /** The numbers of the two sides. Counter-clockwise about the corner the first one comes before
   * the body, the second one after it. They are equal inside of a side. */
  std::array<unsigned int, 2> sides;
  /** The tangent of the first side, away from the corner. */
  Tensor<1, 2> direction;
};

/** Returns all corners of a body, in the order of their first sides. Ends of sides are one point if
 * they are closer than 1e-8 diameters; closed sides have no ends. */
std::vector<Corner> corners(const Geometry<2> &geometry);

/** Returns the points inside of sides at which moduli jump. Parts of a side below 1/256 of its
 * length may hide. */
std::vector<Corner> interface_ends(const Scene<2> &scene);

/** A corner of a side that is in a pair, and the point of the other side that lies across. */
struct PairedCorner {
  Corner corner;
  /** The other side of the pair, and the arc length of the point on it (length). */
  unsigned int side;
  double s;
  /** Whether that point is a corner of the other body, too. */
  bool meets_corner;
  /** Returns the smallest exponent of both wedges while they press each other in a state; at most
   * 1. */
  std::function<double(const EdgeCondition &)> exponent_in;
  /** The smallest of these over all states that contact may have. */
  double exponent;
};

/** Returns the corners of both sides of all pairs that have a point across. */
std::vector<PairedCorner> paired_corners(const Scene<2> &scene);

/** Returns the materials about a corner; none where data has no value. Layers below 1/64 of the
 * angle may hide. */
std::vector<WedgeLayer> layers_at(const Scene<2> &scene, const Corner &corner);

/** Returns the conditions that a side may have at a point: a contact side is free or sliding, with
 * friction it may stick, too; all others have one. */
template <int dim>
std::vector<EdgeCondition> possible_conditions(const Scene<dim> &scene, unsigned int side,
                                               const Point<dim> &x);

/**
 * Returns the smallest exponent of a wedge at @p x between two sides, over the states of contact.
 * At a straight angle contact has the same state on both sides: a state that is open and closed
 * gives 1/2, which the inequalities of (1) exclude where the gap is smooth. They leave 3/2.
 */
template <int dim>
double smallest_exponent(const Scene<dim> &scene, const Point<dim> &x,
                         const std::array<unsigned int, 2> &sides,
                         const std::vector<WedgeLayer> &layers);
} // namespace Signorini
