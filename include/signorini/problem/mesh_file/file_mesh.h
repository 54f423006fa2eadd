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

/** The content of a mesh file of Gmsh for a body in the plane or in space. */
template <int dim>
struct FileMesh {
  struct Node {
    /** The number of the node in the file, and the line of the file, for messages; 0 in a file that
     * Gmsh made. */
    std::size_t tag, line;
    Point<dim> x;
    /** The third coordinate, also in the plane. */
    double z;
  };

  /** A line, a triangle or a quadrilateral, in space also a tetrahedron, a prism or a hexahedron.
   */
  struct Element {
    std::size_t tag, line;
    /** The number of the curve, the surface or the volume, and of its physical group; 0 if it has
     * none. */
    int entity, group;
    unsigned int n_corners;
    /** Whether the middles of the edges are nodes. */
    bool is_quadratic;
    /** The indices of the nodes in Gmsh's order: first the corners, of faces in order around them,
     * then the middles of the edges, of faces in the same order, then those inside. */
    std::array<unsigned int, dim == 2 ? 9 : 27> nodes;
  };

  /** An edge of the boundary of a plane body, which lies on its left. */
  struct Edge {
    unsigned int start, end;
    /** The node in the middle of an edge of second order, or the start. */
    unsigned int middle;
    std::string name;
  };

  /** The name of the file in messages. */
  std::string name;
  std::vector<Node> nodes;
  /** The elements of dimension dim - 1 and dim. */
  std::vector<Element> faces, cells;
  /** The names of physical groups by dimension and number. */
  std::map<std::pair<unsigned int, int>, std::string> group_names;
  /** Whether elements of a dimension are in physical groups. */
  std::array<bool, 4> has_groups = {};
  /** Whether cells of the file are left out; faces may belong to these. */
  bool is_part = false;
  /** The closed curves of which the boundary of a plane body consists: every edge begins where the
   * one before it ends. check_and_sort() finds them. */
  std::vector<std::vector<Edge>> loops;

  std::string location(const std::size_t line) const {
    return place_in_file(name, line);
  }
  /** Returns the physical name of an element of this dimension. A group without a name is called by
   * its number, and where no element of the dimension is in a group, all are called by their curve
   * or surface; "rest" if others have names. @throws InputError if the name is no word. */
  std::string name_of(const Element &element, unsigned int dimension) const;
};

/** The name of faces that have none in the file. */
inline const std::string unnamed = "rest";

/** Returns the names of sides that are parts of the boundary with these names, in this order: those
 * of one name stand together and become name.1, name.2, ... @param file its name, for messages.
 * @throws InputError if two are the same. */
std::vector<std::string> number_names(const std::vector<std::string> &names,
                                      const std::string &file);

/** Checks that no two of some nodes are at one point, which would be a crack. @throws InputError */
template <int dim>
void check_cracks(const FileMesh<dim> &mesh,
                  std::vector<const typename FileMesh<dim>::Node *> nodes);

/** Returns the numbers of points in the order of Hilbert's curve: neighbours in the body are
 * neighbours in memory. */
template <int dim>
std::vector<unsigned int> order_on_curve(const std::vector<Point<dim>> &points);

/** The name of an empty section behind $MeshFormat that marks the text of a mesh as Gmsh's
 * translation of a file, whose lines are others. */
constexpr const char *conversion_section = "$Converted";

/** Returns whether a text begins like those that read_gmsh() reads. */
bool is_gmsh_text(const std::string &text);

/**
 * Reads a text in Gmsh's format MSH, version 2.0 to 2.2 or 4.1 (Gmsh reference manual, section "MSH
 * file format"). Sections that do not concern the mesh are skipped, and so are elements of less
 * than dim - 1 dimensions.
 * @param name the name of the file in messages: "part.msh".
 * @throws InputError with the line for everything else: other versions and binary files, other
 * elements, texts that should be numbers.
 */
template <int dim>
FileMesh<dim> read_gmsh(const std::string &text, const std::string &name);

/**
 * Keeps the cells of one of several bodies: those of the surface that is called like the body, and
 * those of "BODY.NAME", which become its region NAME. Nodes that two bodies share belong to both.
 * @throws InputError if a surface belongs to none of the @p bodies, or the body has no surface.
 */
void keep_part(FileMesh<2> &mesh, const std::string &body, const std::vector<std::string> &bodies);

/**
 * Checks nodes and elements of a plane body, and finds the boundary. Clockwise cells are turned
 * round; cells and nodes are sorted by their positions: the order does not depend on the file, and
 * the vertices of cells come first.
 * @return the number of vertices.
 * @throws InputError with the number of the first element or node that is wrong: cells that are not
 * convex or lie on one another, named lines that are not edges, two nodes at one point, nodes with
 * different z, edges with two names, parts that are not connected.
 */
unsigned int check_and_sort(FileMesh<2> &mesh);
} // namespace Signorini
