// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/problem/geometry/geometry.h>
#include <signorini/problem/mesh_file/file_mesh.h>

#include <string>
#include <vector>

namespace Signorini
{
/**
 * Returns the body of a mesh: its coarse mesh is that of the file. Every chain of edges with one
 * name is a side, counter-clockwise around the body; a name that has several chains gives the sides
 * name.1, name.2, ... from left to right by their first points. Edges in a row on a line are one
 * segment. Edges of second order and the sides named in @p arcs are circular arcs through their
 * nodes: refined meshes follow the circles, and cells at them are transfinite interpolations of
 * their edges. Middles of edges between cells are not used: these edges are straight.
 * @param where how messages about @p arcs begin.
 * @throws InputError if an arc is none, an unknown side is named, or an arc turns a cell inside
 * out.
 */
Geometry<2> make_geometry(const FileMesh &mesh,
                          const std::vector<std::string> &arcs,
                          const std::string &where);
} // namespace Signorini
