// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/point.h>

#include <array>
#include <vector>

namespace Signorini
{
/** A mesh of triangles, counter-clockwise, with the edges of its boundary, which have the body on
 * their left. */
struct Triangles
{
  std::vector<dealii::Point<2>> points;
  std::vector<std::array<unsigned int, 3>> triangles;
  std::vector<std::array<unsigned int, 2>> boundary;
  /** Whether the mesh is empty because it would have more triangles than allowed. */
  bool too_many = false;
};

/**
 * Fills the body between segments that form closed loops with triangles: the constrained Delaunay
 * triangulation, refined by Ruppert's method until no angle is below 20.7 degrees (except at
 * smaller angles of the boundary) and no edge is longer than @p mesh_size, if that is positive.
 * Points may be added on the segments. The first points of the result are the given ones.
 *
 * @param segments pairs of numbers of points.
 * @return no triangles if segments cross, or if there would be more than about @p max_triangles.
 */
Triangles triangulate(const std::vector<dealii::Point<2>> &points,
                      const std::vector<std::array<unsigned int, 2>> &segments,
                      double mesh_size,
                      std::size_t max_triangles);
} // namespace Signorini
