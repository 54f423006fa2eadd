// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/problem/geometry/geometry.h>
#include <signorini/problem/geometry/surface.h>

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace Signorini {
/** A body in space by its coarse mesh and the surfaces on which its sides lie. */
struct Solid {
  /** A face of the boundary, and the number of its side. */
  struct Face {
    /** The vertices in the order of deal.II, (0,0), (1,0), (0,1), (1,1), round the outward normal:
     * (x_1 - x_0) × (x_2 - x_0) points out of the body. */
    std::array<unsigned int, 4> vertices;
    unsigned int side;
  };

  std::vector<Point<3>> vertices;
  /** The hexahedra, with vertices in the order of deal.II and positive determinants. */
  std::vector<std::array<unsigned int, 8>> cells;
  /** All faces of the boundary. */
  std::vector<Face> faces;
  /** The names and the surfaces of the sides. */
  std::vector<std::pair<std::string, Surface>> sides;
  /** The names of the parts with moduli of their own, and the number of that of every cell; both
   * empty if the body has none. */
  std::vector<std::string> regions;
  std::vector<unsigned int> region_of_cell;
};

/** Returns a point on surfaces: onto each of several in turn until nothing moves.
 * @param size the length that rounding is relative to, beside that of the point. */
Point<3> project_on_all(const std::vector<Surface> &surfaces, Point<3> x, double size);

/**
 * Returns the body. Refined meshes follow the surfaces: the middle of an edge is the mean of its
 * ends and the middle of a face -1/4 of its corners and 1/2 of the middles of its edges, both
 * projected to the surfaces of the sides on which they lie, on two in turn until nothing moves.
 */
Geometry<3> make_geometry(Solid solid);
} // namespace Signorini
