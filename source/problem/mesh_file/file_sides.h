// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/problem/geometry/geometry.h>
#include <signorini/problem/mesh_file/file_mesh.h>

namespace Signorini
{
/** The sides of the body that the edges of the boundary form. */
struct FileSides
{
  /** An edge with the numbers of its side and of its circle. */
  struct Edge
  {
    FileMesh::Edge edge;
    unsigned int side;
    /** The index of the circle in centres; negative for a straight edge. */
    int circle;
  };

  /** The sides: one for every chain of edges with one name, counter-clockwise around the body. */
  std::vector<Side<2>> sides;
  std::vector<Edge> edges;
  std::vector<dealii::Point<2>> centres;
};

/**
 * Finds the sides. A name that has several chains of edges gives name.1, name.2, ... from left to
 * right by their first points. Straight edges in a row on a line become one segment, edges of
 * second order arcs: as long as possible, at least one for each edge. The edges of a side in
 * @p arcs are one arc per chain. Vertices move onto their segments and arcs, by less than 1e-6 of
 * the length or radius.
 * @param where how messages about @p arcs begin.
 * @throws InputError if an arc is none, or a name is unknown or found twice.
 */
FileSides find_sides(FileMesh &mesh,
                     const std::vector<std::string> &arcs,
                     const std::string &where);

/** Adds the names and the loops of the boundary to a mesh that has its vertices and cells.
 * @param cells those of the mesh, with the nodes of the file, in the same order.
 * @throws InputError if edges, lines and names do not fit together. */
void add_boundary(const GmshMesh &gmsh,
                  const std::vector<GmshMesh::Element> &cells,
                  FileMesh &mesh);
} // namespace Signorini
