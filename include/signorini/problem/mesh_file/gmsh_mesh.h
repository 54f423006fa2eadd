// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstddef>
#include <map>
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
} // namespace Signorini
