// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/scene/corner_exponent.h>
#include <signorini/scene/scene.h>

#include <array>
#include <vector>

namespace Signorini
{
/** A point where two sides of a plane body meet, at a straight angle, too, or where one side has a
 * corner (Curve::corners()). */
struct Corner
{
  dealii::Point<2> position;
  /** The angle between the tangents inside the body, 0 < angle <= 2 pi (radians). */
  double angle;
  /** Numbers of the sides. Counter-clockwise about the corner the first one comes before the body,
   * the second one after it. They are equal inside of a side. */
  std::array<unsigned int, 2> sides;
};

/** All corners of a body, in the order of their first sides. Ends of sides are one point if they
 * are closer than 1e-8 diameters; closed sides have no ends. */
std::vector<Corner> corners(const Geometry<2> &geometry);

/** How a side of this role may be supported at its ends: a contact side is free or sliding, all
 * others have one support. */
std::vector<EdgeSupport> possible_supports(Role role);

/**
 * The smallest exponent at a corner of the scene, over the states of contact sides, with the
 * material at the corner. At a straight angle between contact sides one state may be open and the
 * other closed, which gives 1/2. The inequalities of (1) exclude this root where the gap is smooth,
 * and leave 3/2.
 */
double corner_exponent(const Scene<2> &scene, const Corner &corner);
} // namespace Signorini
