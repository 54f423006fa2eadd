// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/problem/geometry/geometry.h>
#include <signorini/problem/geometry/solid.h>
#include <signorini/problem/geometry/surface.h>
#include <signorini/problem/mesh_file/file_mesh.h>

#include <string>
#include <utility>
#include <vector>

namespace Signorini {
/**
 * Returns the body of a mesh, whose coarse mesh is that of the file; triangles are split into three
 * quadrilaterals each, and quadrilaterals beside triangles into four.
 *
 * Every chain of edges with one name is a side, counter-clockwise around the body; a name that has
 * several chains gives the sides name.1, name.2, ... from left to right by their first points.
 * Edges in a row on a line are one segment. Edges of second order and the sides named in @p arcs
 * are circular arcs through their nodes: refined meshes follow the circles, and cells at them are
 * transfinite interpolations of their edges. Middles of edges between cells are not used: these
 * edges are straight. The names of surfaces are the regions of the body.
 * @param where how messages about @p arcs begin.
 * @throws InputError if check_and_sort() does, if an arc is none, an unknown side is named, or an
 * arc turns a cell inside out.
 */
Geometry<2> make_geometry(FileMesh<2> mesh, const std::vector<std::string> &arcs,
                          const std::string &where);

/** The kinds of surface of sides, by their names. */
using SurfaceKinds = std::vector<std::pair<std::string, Surface::Kind>>;

/** A body in space, and a remark on its mesh for the user, mostly empty. */
struct SolidBody {
  Solid solid;
  std::string note;
};

/**
 * Returns the body in space of a mesh, whose coarse mesh is that of the file. If it has other cells
 * than hexahedra, each tetrahedron is split into four of them, each prism into six and each
 * hexahedron into eight.
 *
 * Faces with one name are a side as far as edges connect them at which they turn by at most 30
 * degrees; a name that has several parts gives the sides name.1, name.2, ... by the first
 * coordinates of their middles, equal ones by the second and third. A side is the plane, the sphere
 * or the cylinder on which its nodes lie (fit_surface()), or faces that follow none. Where @p kinds
 * say that it is one of these, edges do not divide it, unless it is a plane, and nodes may lie off
 * by 0.001 of the radius or of the extent. Nodes are moved onto the surfaces; those of second order
 * serve to find surfaces only. The names of volumes are the regions of the body, if there are
 * several.
 * @param where how messages about @p kinds begin.
 * @throws InputError with the number of the first element or node that is wrong: cells with a
 * determinant at a corner below 0.001 of their mean one, named faces inside of the body or of no
 * cell, faces with two names or three cells, two nodes at one point, parts that are not connected,
 * unknown sides, and sides that are not of the kind.
 */
SolidBody make_solid(FileMesh<3> mesh, const SurfaceKinds &kinds, const std::string &where);

/** Returns whether Gmsh can read files with this ending: "step". */
bool is_gmsh_ending(const std::string &ending);

/**
 * Lets the program gmsh make a mesh file of a file of another kind, in a process of its own with
 * limits on time, memory and the size of files.
 * @param ending in lower case, with is_gmsh_ending().
 * @param dim whether it is a mesh of surfaces (2) or of volumes (3).
 * @param mesh_size the longest edge of the elements of shapes that have no mesh; 0: Gmsh's choice.
 * @param where the beginning of messages.
 * @return the text of a file that read_gmsh() reads. @throws InputError
 */
std::string convert_with_gmsh(const std::string &content, const std::string &ending,
                              unsigned int dim, double mesh_size, const std::string &where);
} // namespace Signorini
