// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>

#include <deal.II/base/point.h>

#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace Signorini {
/** Returns "name:line: ", or "name: " without a line. */
inline std::string place_in_file(const std::string &name, const std::size_t line) {
  return name + (line > 0 ? ":" + std::to_string(line) : "") + ": ";
}

/** The content of a mesh file of Gmsh for a 2-D body. */
struct FileMesh {
  struct Node {
    /** The number of the node in the file, and the line of the file, for messages; 0 in a file that
     * Gmsh made. */
    std::size_t tag, line;
    Point<2> x;
    double z;
  };

  /** A line, a triangle or a quadrilateral. */
  struct Element {
    std::size_t tag, line;
    /** The number of the curve or the surface, and of its physical group; 0 if it has none. */
    int entity, group;
    unsigned int n_corners;
    /** Whether the middles of the edges are nodes. */
    bool is_quadratic;
    /** The indices of the nodes: first the corners in order around the element, then the middles of
     * the edges in the same order, then the one inside. */
    std::array<unsigned int, 9> nodes;
  };

  /** An edge of the boundary; the body lies on its left. */
  struct Edge {
    unsigned int start, end;
    /** The node in the middle of an edge of second order, or the start. */
    unsigned int middle;
    std::string name;
  };

  /** The name of the file in messages. */
  std::string name;
  std::vector<Node> nodes;
  std::vector<Element> lines, cells;
  /** The names of physical groups by dimension and number. */
  std::map<std::pair<unsigned int, int>, std::string> group_names;
  /** Whether elements of a dimension are in physical groups. */
  std::array<bool, 4> has_groups = {};
  /** Whether cells of the file are left out; lines may belong to these. */
  bool is_part = false;
  /** The closed curves that the boundary consists of: every edge begins where the one before it
   * ends. check_and_sort() finds them. */
  std::vector<std::vector<Edge>> loops;

  std::string location(const std::size_t line) const {
    return place_in_file(name, line);
  }
  /** Returns the physical name of an element of this dimension. A group without a name is called by
   * its number, and where no element of the dimension is in a group, all are called by their curve
   * or surface; "rest" if others have names. @throws InputError if the name is no word. */
  std::string name_of(const Element &element, unsigned int dim) const;
};

/** The name of an empty section behind $MeshFormat that marks the text of a mesh as Gmsh's
 * translation of a file, whose lines are others. */
constexpr const char *conversion_section = "$Converted";

/** Returns whether a text begins like those that read_gmsh() reads. */
bool is_gmsh_text(const std::string &text);

/**
 * Reads a text in Gmsh's format MSH, version 2.0 to 2.2 or 4.1 (Gmsh reference manual, section "MSH
 * file format"). Sections that do not concern the mesh are skipped, and so are points.
 * @param name the name of the file in messages: "part.msh".
 * @throws InputError with the line for everything else: other versions and binary files, other
 * elements, texts that should be numbers.
 */
FileMesh read_gmsh(const std::string &text, const std::string &name);

/**
 * Keeps the cells of one of several bodies: those of the surface that is called like the body, and
 * those of "BODY.NAME", which become its region NAME. Nodes that two bodies share belong to both.
 * @throws InputError if a surface belongs to none of the @p bodies, or the body has no surface.
 */
void keep_part(FileMesh &mesh, const std::string &body, const std::vector<std::string> &bodies);

/**
 * Checks nodes and elements, and finds the boundary. Clockwise cells are turned round; cells and
 * nodes are sorted by their positions: the order does not depend on the file, and the vertices of
 * cells come first.
 * @return the number of vertices.
 * @throws InputError with the number of the first element or node that is wrong: cells that are not
 * convex or lie on one another, named lines that are not edges, two nodes at one point, nodes with
 * different z, edges with two names, parts that are not connected.
 */
unsigned int check_and_sort(FileMesh &mesh);
} // namespace Signorini
