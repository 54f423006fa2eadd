// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/problem/mesh_file/gmsh_mesh.h>

#include <deal.II/base/point.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace Signorini
{
/**
 * A plane mesh of convex quadrilaterals that are connected by their edges, and its boundary in
 * loops. Cells and vertices are in an order that depends on their positions, not on the file.
 */
struct FileMesh
{
  struct Vertex
  {
    dealii::Point<2> position;
    /** The number of the node in the file. */
    std::size_t tag;
  };

  struct Cell
  {
    /** Indices of vertices, counter-clockwise. */
    std::array<unsigned int, 4> corners;
    /** The number of the element in the file. */
    std::size_t tag;
  };

  /** An edge of the boundary; the body lies on its left. */
  struct Edge
  {
    unsigned int start, end;
    /** The node in the middle of an edge of second order. */
    std::optional<Vertex> middle;
    /** Index into names. */
    unsigned int name;
    /** The cell to which it belongs; it is the edge from corner @p edge_of_cell. */
    unsigned int cell, edge_of_cell;
  };

  /** How messages name the file. */
  std::string file;
  std::vector<Vertex> vertices;
  std::vector<Cell> cells;
  /** The physical names of the boundary, sorted. */
  std::vector<std::string> names;
  /** The closed curves that the boundary consists of: every edge begins where the one before it
   * ends. */
  std::vector<std::vector<Edge>> loops;
};

/** The name of edges that have none in the file. */
extern const std::string name_of_the_rest;

/**
 * Checks what a file says and puts it in order. Cells that are clockwise are turned round. Nodes
 * without elements do not count, named lines between cells neither.
 * @throws InputError with the number of the first element or node that is wrong: cells that are not
 * convex or lie on one another, lines that are no edges, two nodes at one place, points in space,
 * edges with more than two cells or with two names, parts that do not hang together.
 */
FileMesh make_file_mesh(const GmshMesh &gmsh);
} // namespace Signorini
