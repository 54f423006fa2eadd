// SPDX-License-Identifier: LGPL-2.1-or-later
// The numbers of nodes and elements, the first corner of an element and its orientation do not
// matter: the same mesh in another order is the same body.

#include <signorini/problem/mesh_file/file_mesh.h>

#include <algorithm>
#include <fstream>
#include <numeric>
#include <random>
#include <sstream>

#include "tests.h"

using namespace Signorini;

namespace
{
/** The same mesh with other numbers. */
GmshMesh shuffle(const GmshMesh &mesh, const bool turn_round)
{
  std::mt19937 random(3);
  GmshMesh shuffled = mesh;
  std::vector<unsigned int> place(mesh.nodes.size());
  std::iota(place.begin(), place.end(), 0);
  std::shuffle(place.begin(), place.end(), random);
  for (std::size_t i = 0; i < place.size(); ++i)
    shuffled.nodes[place[i]] = mesh.nodes[i];
  for (std::vector<GmshMesh::Element> *const elements : {&shuffled.lines, &shuffled.quadrilaterals})
  {
    for (GmshMesh::Element &element : *elements)
      for (unsigned int i = 0; i < element.n_nodes; ++i)
        element.nodes[i] = place[element.nodes[i]];
    std::shuffle(elements->begin(), elements->end(), random);
  }
  for (GmshMesh::Element &element : shuffled.quadrilaterals)
  {
    const unsigned int first = random() % 4;
    std::rotate(element.nodes.begin(), element.nodes.begin() + first, element.nodes.begin() + 4);
    std::rotate(
      element.nodes.begin() + 4, element.nodes.begin() + 4 + first, element.nodes.begin() + 8);
    if (turn_round && random() % 2 == 0)
    {
      std::swap(element.nodes[1], element.nodes[3]);
      std::swap(element.nodes[4], element.nodes[7]);
      std::swap(element.nodes[5], element.nodes[6]);
    }
  }
  return shuffled;
}

bool is_same(const FileMesh &a, const FileMesh &b)
{
  const auto same_vertex = [](const FileMesh::Vertex &x, const FileMesh::Vertex &y) {
    return x.position == y.position && x.tag == y.tag;
  };
  const auto same_cell = [](const FileMesh::Cell &x, const FileMesh::Cell &y) {
    return x.corners == y.corners && x.tag == y.tag;
  };
  const auto same_edge = [&](const FileMesh::Edge &x, const FileMesh::Edge &y) {
    return x.start == y.start && x.end == y.end && x.name == y.name && x.cell == y.cell &&
           x.edge_of_cell == y.edge_of_cell && x.middle.has_value() == y.middle.has_value() &&
           (!x.middle || same_vertex(*x.middle, *y.middle));
  };
  const auto same_loop = [&](const auto &x, const auto &y) {
    return std::equal(x.begin(), x.end(), y.begin(), y.end(), same_edge);
  };
  return a.names == b.names &&
         std::equal(a.vertices.begin(),
                    a.vertices.end(),
                    b.vertices.begin(),
                    b.vertices.end(),
                    same_vertex) &&
         std::equal(a.cells.begin(), a.cells.end(), b.cells.begin(), b.cells.end(), same_cell) &&
         std::equal(a.loops.begin(), a.loops.end(), b.loops.begin(), b.loops.end(), same_loop);
}
} // namespace

int main()
{
  Checks checks;
  for (const std::string name : {"bracket", "plate_with_hole", "half_disc"})
    for (const bool of_second_order : {false, true})
    {
      std::ostringstream text;
      text << std::ifstream(of_second_order ? PARTS + name + ".msh" : TEST_FILES + name + "_1.msh")
                .rdbuf();
      const GmshMesh gmsh = read_gmsh(text.str(), name);
      const FileMesh mesh = make_file_mesh(gmsh);
      const std::string order = of_second_order ? ", second order" : ", first order";
      checks.that(name + order + ": other numbers",
                  is_same(mesh, make_file_mesh(shuffle(gmsh, false))));
      checks.that(name + order + ": other numbers and clockwise cells",
                  is_same(mesh, make_file_mesh(shuffle(gmsh, true))));
    }
  return checks.exit_code();
}
