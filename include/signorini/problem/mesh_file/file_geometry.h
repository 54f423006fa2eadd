// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/problem/geometry/geometry.h>
#include <signorini/problem/mesh_file/file_mesh.h>

#include <string>
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
Geometry<2> make_geometry(FileMesh mesh, const std::vector<std::string> &arcs,
                          const std::string &where);

/** Returns whether Gmsh can read files with this ending: "step". */
bool is_gmsh_ending(const std::string &ending);

/**
 * Lets the program gmsh make a mesh file of a file of another kind, in a process of its own with
 * limits on time, memory and the size of files.
 * @param ending in lower case, with is_gmsh_ending().
 * @param mesh_size the longest edge of the elements of shapes that have no mesh; 0: Gmsh's choice.
 * @param where the beginning of messages.
 * @return the text of a file that read_gmsh() reads. @throws InputError
 */
std::string convert_with_gmsh(const std::string &content, const std::string &ending,
                              double mesh_size, const std::string &where);
} // namespace Signorini
