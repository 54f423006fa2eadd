// SPDX-License-Identifier: LGPL-2.1-or-later
// The subsection Geometry.

#include "declarations.h"

namespace Signorini
{
namespace Patterns = dealii::Patterns;

void Declarations::declare_geometry(GeometryParameters &geometry)
{
  enter("Geometry");
  add("Shape",
      geometry.shape,
      "Shape of the body. A rectangle has the sides left, right, bottom, top; a polygon side0, "
      "side1, ... in the order of its vertices; a half disc (the lower half) flat and arc, a disc "
      "arc, a ring inner and outer; a file those that are named in it; a box, the shape in space, "
      "left, right (x), front, back (y), bottom, top (z).");
  add("Lower left",
      geometry.lower_left,
      "Corner of the rectangle: x, y; of the box: x, y, z (length).");
  add("Upper right",
      geometry.upper_right,
      "Opposite corner of the rectangle: x, y; of the box: x, y, z (length).");
  add("Cells",
      geometry.cells,
      "Coarse cells per direction, of the rectangle: nx, ny; of the box: nx, ny, nz.");
  add(
    "Vertices",
    geometry.vertices,
    "Polygon: x0,y0; x1,y1; ... (length). 'x,y fillet r' rounds the corner with a side of its own, "
    "fillet<number of the vertex>; between two vertices, 'arc cx,cy ccw' (or cw) makes an arc "
    "about "
    "(cx,cy) of the edge. A convex polygon without arcs has one coarse cell if it has four "
    "vertices, otherwise one per vertex; all others are filled with triangles, which are split "
    "into quadrilaterals.");
  add("Holes",
      geometry.holes,
      "Polygon: holes separated by '|', each 'circle cx,cy,r' or vertices as above (length). Their "
      "sides are hole0, hole1, ...");
  add("Mesh size",
      geometry.mesh_size,
      "Polygon: longest edge of the triangles that level 0 is made from (length); 0: as coarse as "
      "the shape allows.",
      Patterns::Double(0., 1e30),
      "a number from 0 to 1e+30");
  add("Centre", geometry.centre, "Of a half disc, a disc or a ring: x, y (length).");
  add("Radius",
      geometry.radius,
      "Of a half disc, a disc or a ring (length).",
      Patterns::Double(1e-30, 1e30),
      "a number from 1e-30 to 1e+30");
  add("Inner radius",
      geometry.inner_radius,
      "Of a ring (length).",
      Patterns::Double(1e-30, 1e30),
      "a number from 1e-30 to 1e+30");
  add("File",
      geometry.file,
      "Mesh of quadrilaterals, written by Gmsh (.msh, version 2.2 or 4.1, ASCII): the coarse mesh. "
      "Looked for in the folder of the parameter file, then in the working folder. Sides are the "
      "physical names of its curves; edges without a name are the side rest.");
  add(
    "Arcs",
    geometry.arcs,
    "Mesh file: sides that are circular arcs, so that refinement follows the circle through their "
    "nodes: names separated by blanks. Edges with a node in the middle need no entry.");
  add("Distortion",
      geometry.distortion,
      "Interior vertices of the coarsest level are moved at random by this share of h.",
      Patterns::Double(0., 0.45),
      "a number from 0 to 0.45");
  leave();
}
} // namespace Signorini
