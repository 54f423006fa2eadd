// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/problem/geometry/outline.h>

#include <array>
#include <vector>

namespace Signorini {
/** A mesh of triangles, with the edges of its boundary, which have the body on their left. */
struct Triangles {
  std::vector<Point<2>> points;
  std::vector<std::vector<unsigned int>> triangles;
  std::vector<std::array<unsigned int, 2>> boundary;
  /** Whether the mesh is empty because it would have more points than allowed. */
  bool too_many = false;
};

/**
 * Fills the body between edges that form closed loops with triangles: the constrained Delaunay
 * triangulation, refined by Ruppert's method until no angle is below 20.7 degrees (except at
 * smaller angles of the boundary) and no edge is longer than @p mesh_size, if that is positive.
 * Points may be added on the edges. The first points of the result are the given ones.
 *
 * @return no triangles if edges cross, or if there would be more than @p max_points points.
 */
Triangles triangulate(const std::vector<Point<2>> &points,
                      const std::vector<CoarseMesh::Edge> &edges, double mesh_size,
                      std::size_t max_points);
} // namespace Signorini
