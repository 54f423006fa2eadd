// SPDX-License-Identifier: LGPL-2.1-or-later
// Mesh files of bodies in space that are wrong, each with the complete sentence that refuses it.

#include <signorini/problem/mesh_file/file_geometry.h>

#include <string>
#include <utility>
#include <vector>

#include "changed_text.h"
#include "tests.h"

using namespace Signorini;

namespace {
/** Two cubes side by side. */
const std::string version_2 =
  "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n2 1 \"bottom\"\n2 2 \"top\"\n"
  "$EndPhysicalNames\n$Nodes\n12\n1 0 0 0\n2 1 0 0\n3 2 0 0\n4 0 1 0\n5 1 1 0\n6 2 1 0\n7 0 0 1\n"
  "8 1 0 1\n9 2 0 1\n10 0 1 1\n11 1 1 1\n12 2 1 1\n$EndNodes\n$Elements\n4\n"
  "1 3 2 1 1 1 2 5 4\n2 3 2 2 2 7 8 11 10\n3 5 2 0 1 1 2 5 4 7 8 11 10\n"
  "4 5 2 0 1 2 3 6 5 8 9 12 11\n$EndElements\n";

/** The first cube. */
const std::string version_4 =
  "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n2 7 \"bottom\"\n3 9 \"steel\"\n"
  "$EndPhysicalNames\n$Entities\n0 0 1 1\n3 0 0 0 1 1 0 1 7 0\n1 0 0 0 1 1 1 1 9 1 3\n"
  "$EndEntities\n$Nodes\n1 8 1 8\n3 1 0 8\n1\n2\n3\n4\n5\n6\n7\n8\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n"
  "0 0 1\n1 0 1\n1 1 1\n0 1 1\n$EndNodes\n$Elements\n2 2 1 2\n2 3 3 1\n1 1 2 3 4\n3 1 5 1\n"
  "2 1 2 3 4 5 6 7 8\n$EndElements\n";

SolidBody read(const std::string &text) {
  return make_solid(read_gmsh<3>(text, "a.msh"), {}, "a.prm:3: Geometry/Surfaces");
}

/** Another cube, a little aside, on the face between the two. */
const Changes third_cube = {
  {"12\n1 0", "16\n13 2 0.1 0.1\n14 2 1.1 0.1\n15 2 0.1 1.1\n16 2 1.1 1.1\n1 0"},
  {"Elements\n4", "Elements\n5"},
  {"9 12 11\n", "9 12 11\n5 5 2 0 1 2 13 14 5 8 15 16 11\n"}};

const std::vector<WrongMesh> wrong_texts = {
  {{{version_2.substr(version_2.find("3 5 2 0")), "$EndElements\n"},
    {"Elements\n4", "Elements\n2"}},
   "a.msh: found no cells, allowed: a mesh of hexahedra, tetrahedra or prisms."},
  {{{"4 5 2 0 1 2", "4 7 2 0 1 2"}},
   "a.msh:29: element 4 is a pyramid, allowed: hexahedra, prisms and tetrahedra of first or second "
   "order."},
  {{{"4 5 2 0 1 2", "4 29 2 0 1 2"}},
   "a.msh:29: element 4 is a tetrahedron of order 3, allowed: hexahedra, prisms and tetrahedra of "
   "first or second order."},
  {{{"4 5 2 0 1 2", "4 99 2 0 1 2"}},
   "a.msh:29: element 4 is of the type 99, allowed: hexahedra, prisms and tetrahedra of first or "
   "second order."},
  {{{"12 2 1 1", "12 2 0 1"}},
   "a.msh:22: nodes 9 and 12 lie both at (2, 0, 1), which is a crack, allowed: one node for every "
   "place (Gmsh: Coherence Mesh)."},
  {{{"9 2 0 1", "9 1.2 0.9 1"}},
   "a.msh:29: the element 4 is flat or turned inside out at node 9, allowed: elements whose "
   "determinants at all corners are above 0.001 of their mean."},
  {{{"8 9 12 11", "8 8 12 11"}},
   "a.msh:29: the element 4 is flat or turned inside out at node 8, allowed: elements whose "
   "determinants at all corners are above 0.001 of their mean."},
  {{{"4 5 2 0 1 2 3 6 5 8 9 12 11", "4 4 2 0 1 2 3 6 5"}},
   "a.msh:29: the element 4 is flat or turned inside out at node 2, allowed: elements whose "
   "determinants at all corners are above 0.001 of their mean."},
  {third_cube,
   "a.msh:34: the face between nodes 2, 8, 11 and 5 belongs to the elements 3, 4 and 5, allowed: "
   "one or two elements at a face."},
  {{{"2 3 6 5 8 9 12 11", "1 3 6 4 7 9 12 10"}},
   "a.msh:29: the face between nodes 1, 7, 10 and 4 has the elements 3 and 4 on the same side, "
   "allowed: elements that do not lie on one another."},
  {{{"1 3 2 1 1 1 2 5 4", "1 3 2 1 1 1 2 6 4"}},
   "a.msh:26: the face 1 between nodes 1, 2, 6 and 4 is not a face of an element, allowed: faces "
   "of "
   "elements."},
  {{{"1 3 2 1 1 1 2 5 4", "1 3 2 1 1 2 5 11 8"}},
   "a.msh:26: the face 1 between nodes 2, 5, 11 and 8 lies inside of the body, allowed: names of "
   "faces on its boundary."},
  {{{"2 3 2 2 2 7 8 11 10", "2 3 2 2 2 4 5 2 1"}},
   "a.msh:27: the face 2 between nodes 4, 5, 2 and 1 has the physical names 'bottom' and 'top', "
   "allowed: one."},
  {{{"12\n1 0", "16\n13 1.5 0 0\n14 1.5 1 0\n15 1.5 0 1\n16 1.5 1 1\n1 0"},
    {"2 3 6 5 8 9 12 11", "13 3 6 14 15 9 12 16"}},
   "a.msh: the elements 3 and 4 belong to parts that no faces connect, allowed: one body."},
  {{{"Elements\n4", "Elements\n5"},
    {"4 5 2 0 1 2 3 6 5 8 9 12 11", "4 6 2 0 1 2 5 11 3 6 12\n5 6 2 0 1 2 11 8 3 12 9"}},
   "a.msh:29: the triangle between nodes 2, 11 and 5 of the element 4 lies on a quadrilateral of "
   "the "
   "element 3, allowed: elements that share whole faces."},
  {{{"2 1 \"bottom\"", "2 1 \"rest\""}},
   "a.msh: found the physical name 'rest', allowed: another one, because this is the name of all "
   "that have none."},
  {{{"2 1 \"bottom\"", "2 1 \"rest.1\""}},
   "a.msh: two sides have the name 'rest.1', which also numbers the parts of a side, allowed: "
   "another name."}};

/** Three by three unit cubes without the middle one and without the one at (2.5, 2.5). */
std::string cubes_that_touch() {
  std::string nodes, elements;
  const auto node = [](const unsigned int i, const unsigned int j, const unsigned int k) {
    return std::to_string(1 + i + 4 * j + 16 * k);
  };
  for (unsigned int k = 0; k < 2; ++k)
    for (unsigned int j = 0; j < 4; ++j)
      for (unsigned int i = 0; i < 4; ++i)
        nodes += node(i, j, k) + " " + std::to_string(i) + " " + std::to_string(j) + " " +
                 std::to_string(k) + "\n";
  for (unsigned int j = 0; j < 3; ++j)
    for (unsigned int i = 0; i < 3; ++i)
      if (i != j || i == 0) {
        elements += std::to_string(1 + i + 3 * j) + " 5 0";
        for (unsigned int k = 0; k < 2; ++k)
          elements += " " + node(i, j, k) + " " + node(i + 1, j, k) + " " + node(i + 1, j + 1, k) +
                      " " + node(i, j + 1, k);
        elements += "\n";
      }
  return "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n32\n" + nodes +
         "$EndNodes\n$Elements\n7\n" + elements + "$EndElements\n";
}

void test_wrong_solids(Checks &checks) {
  for (const WrongMesh &wrong : wrong_texts)
    checks.refuses(wrong.message, [&] { read(change(version_2, wrong.changes)); });
  checks.refuses("a.msh: the body touches itself at the edge between nodes 11 and 27, allowed: a "
                 "body whose parts share faces.",
                 [&] { read(cubes_that_touch()); });
  checks.refuses(
    "a.msh:11: found surface 3 in 2 physical groups, allowed: one, because a side has one name.",
    [&] {
      read(change(version_4, {{"1 1 0 1 7 0", "1 1 0 2 7 8 0"}}));
    });
}

std::vector<std::string> names_of(const Solid &solid) {
  std::vector<std::string> names;
  for (const auto &side : solid.sides)
    names.push_back(side.first);
  return names;
}

void test_good_solids(Checks &checks) {
  const Solid old = read(version_2).solid, cube = read(version_4).solid;
  // The left cube alone has named faces: planes go on beyond them without a name.
  checks.that("version 2.2",
              names_of(old) == std::vector<std::string>({"bottom", "rest.1", "rest.2", "rest.3",
                                                         "rest.4", "rest.5", "rest.6", "top"}));
  checks.that("version 4.1: parts of a name from left to right",
              names_of(cube) == std::vector<std::string>(
                                  {"bottom", "rest.1", "rest.2", "rest.3", "rest.4", "rest.5"}));
  std::vector<double> products;
  const std::vector<dealii::Tensor<1, 3>> normals = {
    dealii::Tensor<1, 3>({0., 0., -1.}), dealii::Tensor<1, 3>({-1., 0., 0.}),
    dealii::Tensor<1, 3>({0., -1., 0.}), dealii::Tensor<1, 3>({0., 0., 1.}),
    dealii::Tensor<1, 3>({0., 1., 0.}),  dealii::Tensor<1, 3>({1., 0., 0.})};
  for (unsigned int i = 0; i < 6; ++i)
    products.push_back(cube.sides[i].second.axis() * normals[i]);
  checks.near("  with their normals", products, std::vector<double>(6, 1.), 1e-14);
  checks.that("without names sides have the numbers of surfaces, and the others are the rest",
              names_of(read(change(version_4, {{"1 7 0", "0 0"}})).solid) ==
                std::vector<std::string>({"3", "rest.1", "rest.2", "rest.3", "rest.4", "rest.5"}));
  checks.that("regions have names or the numbers of volumes",
              cube.regions.empty() &&
                read(change(version_2, {{"4 5 2 0 1", "4 5 2 0 8"}})).solid.regions ==
                  std::vector<std::string>({"1", "8"}));
}
} // namespace

int main() {
  return run_tests({test_wrong_solids, test_good_solids});
}
