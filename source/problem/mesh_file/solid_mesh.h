// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/problem/geometry/surface.h>
#include <signorini/problem/mesh_file/file_geometry.h>
#include <signorini/problem/mesh_file/file_mesh.h>

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace Signorini {
/** A tetrahedron, a prism or a hexahedron by the numbers of its corners, as Gmsh counts them. */
struct SolidShape {
  /** The edges in the order of the nodes in their middles. */
  std::vector<std::array<unsigned int, 2>> edges;
  /** The faces, counter-clockwise seen from outside. */
  std::vector<std::vector<unsigned int>> faces;
};

/** Returns the shape with 4, 6 or 8 corners. */
const SolidShape &solid_shape(unsigned int n_corners);

/** A face of the boundary: a triangle or a quadrilateral. */
struct BoundaryFace {
  /** The nodes, counter-clockwise seen from outside; the first one has the least position. */
  std::vector<unsigned int> corners;
  /** The points in the middles of the edges from each corner to the next one, and whether they are
   * nodes. */
  std::vector<Point<3>> middles;
  bool has_middle_nodes = false;
  /** The name in the file, and the number of the side. */
  std::string name;
  unsigned int side = 0;
};

/** The sides of a body, and a remark for the user, mostly empty. */
struct SolidSides {
  std::vector<std::pair<std::string, Surface>> sides;
  std::string note;
};

/** Returns the mean of points; its digits do not depend on their order. */
Point<3> mean_of(std::vector<Point<3>> points);

/** Returns " between nodes 1, 2 and 3". */
std::string nodes_text(const FileMesh<3> &mesh, const std::vector<unsigned int> &nodes);

/** Turns cells with a negative volume round. */
void turn_cells_outwards(FileMesh<3> &mesh);

/** Returns the faces of the boundary of cells that are turned outwards, in an order that does not
 * depend on the file. @throws InputError, as make_solid() says. */
std::vector<BoundaryFace> find_boundary(const FileMesh<3> &mesh);

/** Divides the boundary into sides, finds their surfaces and gives the faces the numbers of their
 * sides. @throws InputError, as make_solid() says. */
SolidSides find_sides(const FileMesh<3> &mesh, std::vector<BoundaryFace> &faces,
                      const SurfaceKinds &kinds, const std::string &where);
} // namespace Signorini
