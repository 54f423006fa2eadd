// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/point.h>

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace Signorini
{
/** The content of a mesh file of Gmsh for a 2-D body, before anything of it is checked. */
struct GmshMesh
{
  struct Node
  {
    /** The number of the node in the file. */
    std::size_t tag;
    /** The line of the file, for messages. */
    std::size_t line;
    std::array<double, 3> x;
  };

  /** A line or a quadrilateral. */
  struct Element
  {
    std::size_t tag;
    std::size_t line;
    /** The number of the element's physical group, 0 if it has none. */
    int group;
    /** The number of nodes: 2 or 3 for lines, 4, 8 or 9 for quadrilaterals. */
    unsigned int n_nodes;
    /** The indices of the nodes: first the corners in order around the element, then the middles of
     * the edges in the same order, then the one inside. */
    std::array<unsigned int, 9> nodes;
  };

  /** The name of the file in messages. */
  std::string name;
  std::vector<Node> nodes;
  std::vector<Element> lines;
  std::vector<Element> quadrilaterals;
  /** The names of the physical groups of curves, by number. */
  std::map<int, std::string> curve_names;
};

/**
 * Reads a text in Gmsh's format MSH, version 2.2 or 4.1 (Gmsh reference manual, section "MSH file
 * format"). Sections that do not concern the mesh are skipped, and so are points.
 * @param name the name of the file in messages: "part.msh".
 * @throws InputError with the line for everything else: other versions and binary files, elements
 * that are neither lines nor quadrilaterals, texts that should be numbers.
 */
GmshMesh read_gmsh(const std::string &text, const std::string &name);

/**
 * A 2-D mesh of convex quadrilaterals that are connected by their edges, and its boundary in loops.
 * The order of cells and vertices depends on their positions, not on the file.
 */
struct FileMesh
{
  struct Vertex
  {
    Point<2> position;
    /** The number of the node in the file. */
    std::size_t tag;
  };

  struct Cell
  {
    /** The indices of the vertices, counter-clockwise. */
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
    /** The index of the edge's name in names. */
    unsigned int name;
    /** The cell to which the edge belongs, as the edge from corner @p edge_of_cell. */
    unsigned int cell, edge_of_cell;
  };

  /** The name of the file in messages. */
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
extern const std::string unnamed_side_name;

/**
 * Checks the nodes and elements of a file and returns them in order. Cells that are clockwise are
 * turned round. Nodes without elements do not count, named lines between cells neither.
 * @throws InputError with the number of the first element or node that is wrong: cells that are not
 * convex or lie on one another, lines that are not edges, two nodes at one place, nodes with
 * different z, edges with more than two cells or with two names, parts that are not connected.
 */
FileMesh make_file_mesh(const GmshMesh &gmsh);
} // namespace Signorini
