// SPDX-License-Identifier: LGPL-2.1-or-later
// The numbers of nodes and elements, the first corner of an element and its orientation do not
// matter: the same mesh in another order is the same body.

#include <signorini/problem/mesh_file/file_geometry.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <sstream>

#include "tests.h"

using namespace Signorini;

namespace {
/** The same mesh with other numbers, and with some cells turned round. */
FileMesh<2> shuffle(const FileMesh<2> &mesh) {
  std::mt19937 random(3);
  FileMesh<2> shuffled = mesh;
  std::vector<unsigned int> number_of(mesh.nodes.size());
  std::iota(number_of.begin(), number_of.end(), 0);
  std::shuffle(number_of.begin(), number_of.end(), random);
  for (std::size_t i = 0; i < number_of.size(); ++i)
    shuffled.nodes[number_of[i]] = mesh.nodes[i];
  for (std::vector<FileMesh<2>::Element> *const elements : {&shuffled.faces, &shuffled.cells}) {
    for (FileMesh<2>::Element &element : *elements)
      for (unsigned int &node : element.nodes)
        node = number_of[node];
    std::shuffle(elements->begin(), elements->end(), random);
  }
  for (FileMesh<2>::Element &cell : shuffled.cells) {
    const unsigned int first = random() % 4;
    for (const unsigned int begin : {0, 4})
      std::rotate(cell.nodes.begin() + begin, cell.nodes.begin() + begin + first,
                  cell.nodes.begin() + begin + 4);
    if (random() % 2 == 0) {
      std::swap(cell.nodes[1], cell.nodes[3]);
      std::swap(cell.nodes[4], cell.nodes[7]);
      std::swap(cell.nodes[5], cell.nodes[6]);
    }
  }
  return shuffled;
}

/** The cells, their vertices, and the sides of their faces, as a text. */
std::string text_of(const FileMesh<2> &mesh) {
  const Geometry<2> geometry = make_geometry(mesh, {}, "arcs");
  dealii::Triangulation<2> triangulation;
  geometry.make_coarse_mesh(triangulation);
  std::ostringstream text;
  text.precision(17);
  for (const auto &cell : triangulation.active_cell_iterators())
    for (unsigned int i = 0; i < 4; ++i)
      text << cell->vertex_index(i) << " " << cell->vertex(i) << " "
           << (cell->at_boundary(i) ? geometry.sides[cell->face(i)->boundary_id()].name() : "")
           << "\n";
  return text.str();
}

void test_numbers(Checks &checks) {
  for (const std::string name : {"bracket", "plate_with_hole", "half_disc"})
    for (const std::string &file : {SOURCE_DIR "/prm/parts/" + name + ".msh",
                                    SOURCE_DIR "/tests/problem/mesh_file/" + name + "_1.msh"}) {
      const FileMesh<2> mesh = read_gmsh<2>(file_text(file), name);
      checks.that(file + ": other numbers", text_of(mesh) == text_of(shuffle(mesh)));
    }
}
} // namespace

int main() {
  return run_tests({test_numbers});
}
