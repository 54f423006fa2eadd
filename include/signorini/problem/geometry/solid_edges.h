// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/problem/geometry/geometry.h>

#include <array>
#include <vector>

namespace Signorini {
/** An edge of the coarse mesh at which two sides of a body in space meet, or two faces of a side
 * that follows no surface. */
struct SolidEdge {
  std::array<Point<3>, 2> ends;
  std::array<unsigned int, 2> sides;
  /** The angle inside of the body, 0 < angle < 2 pi (radians). */
  double angle;
  /** The unit vectors in the middle, at right angles to the edge: into the first side, and its
   * outward normal. */
  Tensor<1, 3> tangent, normal;

  /** Returns the point of both sides next to that which divides the edge in the ratio share : 1 -
   * share. */
  Point<3> point(const Geometry<3> &geometry, double share) const;
};

/** Returns all edges of a body, in the order of the sides and their faces. */
std::vector<SolidEdge> solid_edges(const Geometry<3> &geometry);
} // namespace Signorini
