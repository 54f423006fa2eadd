// SPDX-License-Identifier: LGPL-2.1-or-later
// Mesh files that are wrong, each with the complete sentence that refuses it.

#include <signorini/base/errors.h>
#include <signorini/problem/mesh_file/file_geometry.h>

#include <deal.II/grid/grid_tools.h>

#include <string>
#include <utility>
#include <vector>

#include "changed_text.h"
#include "tests.h"

using namespace Signorini;

namespace {
/** Two squares side by side. */
const std::string version_2 = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n"
                              "1 1 \"bottom\"\n1 2 \"top\"\n$EndPhysicalNames\n$Nodes\n6\n"
                              "1 0 0 0\n2 1 0 0\n3 2 0 0\n4 0 1 0\n5 1 1 0\n6 2 1 0\n$EndNodes\n"
                              "$Elements\n4\n1 1 2 1 1 1 2\n2 1 2 2 2 4 5\n3 3 2 0 1 1 2 5 4\n"
                              "4 3 2 0 1 2 3 6 5\n$EndElements\n";

/** The first square. */
const std::string version_4 = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n"
                              "1 7 \"bottom\"\n$EndPhysicalNames\n$Entities\n0 1 1 0\n"
                              "3 0 0 0 1 0 0 1 7 0\n1 0 0 0 1 1 0 0 1 3\n$EndEntities\n$Nodes\n"
                              "1 4 1 4\n2 1 0 4\n1\n2\n3\n4\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n"
                              "$EndNodes\n$Elements\n2 2 1 2\n1 3 1 1\n1 1 2\n2 1 3 1\n"
                              "2 1 2 3 4\n$EndElements\n";

Geometry<2> read(const std::string &text, const std::vector<std::string> &arcs = {}) {
  return make_geometry(read_gmsh<2>(text, "a.msh"), arcs, "a.prm:3: Geometry/Arcs");
}

void check_table(Checks &checks, const std::string &text, const std::vector<WrongMesh> &table) {
  for (const WrongMesh &wrong : table)
    checks.refuses(wrong.message, [&] { read(change(text, wrong.changes)); });
}

const std::vector<WrongMesh> wrong_texts = {
  {{{"$MeshFormat", "solid"}}, "a.msh:1: found 'solid', allowed: $MeshFormat."},
  {{{"2.2 0", "4.0 0"}},
   "a.msh:2: found '4.0', allowed: the version 2.0 to 2.2 or 4.1 of the format (gmsh -format "
   "msh41)."},
  {{{"1 2 \"top\"", "4 2 \"top\""}},
   "a.msh:7: found '4', allowed: the dimension of a physical group (0, 1, 2, 3)."},
  {{{"2.2 0", "2.2 1"}},
   "a.msh:2: found a binary mesh file, allowed: a file of text (gmsh without -bin)."},
  {{{"$EndElements", ""}}, "a.msh: the file ends where $EndElements should be."},
  {{{version_2.substr(version_2.find("$Elements")), ""}},
   "a.msh: found no cells, allowed: a mesh of quadrilaterals or triangles."},
  {{{version_2.substr(version_2.find("$Nodes"), version_2.find("$El") - version_2.find("$Nodes")),
     ""}},
   "a.msh:11: element 1 has the node 1, which the section $Nodes before it lacks."},
  {{{version_2.substr(version_2.find("$Phys")), ""}},
   "a.msh: found no cells, allowed: a mesh of quadrilaterals or triangles."},
  {{{"$EndMeshFormat", "$EndMeshFormat\n$Periodic\n0"}},
   "a.msh: the file ends where $EndPeriodic should be."},
  {{{"$Nodes", "nodes"}},
   "a.msh:9: found 'nodes', allowed: the name of a section, which begins with $."},
  {{{"2 1 0 0", "2 1 zero 0"}},
   "a.msh:12: found 'zero', allowed: a coordinate of a node (a number)."},
  {{{"2 1 0 0", "2 1 nan 0"}},
   "a.msh:12: found the coordinate nan of node 2, allowed: coordinates up to 1e+30; take other "
   "units."},
  {{{"2 1 0 0", "2 1e31 0 0"}},
   "a.msh:12: found the coordinate 1e+31 of node 2, allowed: coordinates up to 1e+30; take other "
   "units."},
  {{{"2 1 0 0", "2 1e400 0 0"}},
   "a.msh:12: found '1e400', allowed: a coordinate of a node (a number)."},
  {{{"6\n1 0", "5\n1 0"}}, "a.msh:16: found '6', allowed: $EndNodes."},
  {{{"6\n1 0", "4000000000\n1 0"}},
   "a.msh:10: found the number 4000000000 as the number of nodes, but the rest of the file has 148 "
   "characters."},
  {{{"2 1 0 0", "1 1 0 0"}},
   "a.msh:12: found node 1 a second time, allowed: one node for each number."},
  {{{"1 2 5 4", "1 2 5 9"}},
   "a.msh:22: element 3 has the node 9, which the section $Nodes before it lacks."},
  {{{"\"bottom\"", "bottom"}}, "a.msh:6: found 'bottom', allowed: a name between quotation marks."},
  {{{"\"bottom\"", "\"the bottom\""}},
   "a.msh: found the physical name 'the bottom', allowed: names of letters, digits, '_', '-' and "
   "'.', because the parameter file separates names by blanks."},
  {{{"4 3 2 0 1 2 3 6 5", "4 4 2 0 1 2 3 6 5"}},
   "a.msh:23: element 4 is a tetrahedron, allowed: quadrilaterals, triangles and lines of first or "
   "second order; a body in space needs Dimension = 3."},
  {{{"4 3 2 0 1 2 3 6 5", "4 99 2 0 1 2 3 6 5"}},
   "a.msh:23: element 4 is of the type 99, allowed: quadrilaterals, triangles and lines of first "
   "or "
   "second order."},
  {{{"$EndMeshFormat", "$EndMeshFormat\n$Converted\n$EndConverted"}, {"2 1 0 0", "2 1 zero 0"}},
   "a.msh: found 'zero', allowed: a coordinate of a node (a number)."},
  {{{"$EndMeshFormat", "$EndMeshFormat\n$Converted\n$EndConverted"}, {"5 1 1 0", "5 0.2 0.2 0"}},
   "a.msh: the element 3 is not convex at node 5, allowed: convex elements, all "
   "angles below 180 degrees."},
  {{{"5 1 1 0", "5 1 1 0.5"}},
   "a.msh:15: node 5 has z = 0.5, node 1 z = 0, allowed: a plane body in x and y, with the same z "
   "everywhere."},
  {{{"4 0 1 0", "4 0 0 1"}, {"5 1 1 0", "5 1 0 1"}, {"6 2 1 0", "6 2 0 1"}},
   "a.msh:16: node 6 has z = 1, node 1 z = 0, allowed: a plane body in x and y, with the same z "
   "everywhere."},
  {{{"6 2 1 0", "6 1 1 0"}},
   "a.msh:16: nodes 5 and 6 lie both at (1, 1), which is a crack, allowed: one node for every "
   "place (Gmsh: Coherence Mesh)."},
  {{{"5 1 1 0", "5 0.2 0.2 0"}},
   "a.msh:22: the element 3 is not convex at node 5, allowed: convex elements, all "
   "angles below 180 degrees."},
  {{{"1 2 5 4", "1 2 2 4"}},
   "a.msh:22: the element 3 is not convex at node 2, allowed: convex elements, all "
   "angles below 180 degrees."},
  {{{"1 1 2 1 1 1 2", "1 1 2 1 1 1 5"}},
   "a.msh:20: the line 1 between nodes 1 and 5 is not an edge of an element, allowed: lines "
   "along edges."},
  {{{"1 1 \"bottom\"", "1 1 \"rest\""}},
   "a.msh: found the physical name 'rest', allowed: another one, because this is the name of all "
   "that have none."},
  {{{"2 1 2 2 2 4 5", "2 1 2 2 2 2 1"}},
   "a.msh:21: the line 2 between nodes 2 and 1 has the physical names 'bottom' and 'top', allowed: "
   "one."},
  {{{"2 3 6 5", "2 1 4 5"}},
   "a.msh:23: the edge between nodes 1 and 2 has the elements 3 and 4 on the same side, allowed: "
   "elements that do not lie on one another."},
  {{{"6\n1 0", "8\n7 1.3 0 0\n8 1.3 1 0\n1 0"}, {"2 3 6 5", "7 3 6 8"}},
   "a.msh: nodes 1 and 7 belong to parts that no edges connect, allowed: one body."},
  {{{"1 1 \"bottom\"", "1 1 \"top.1\""},
    {"2 1 2 2 2 4 5", "2 1 2 2 2 4 5\n5 1 2 2 2 3 6"},
    {"4\n1 1", "5\n1 1"}},
   "a.msh: two sides have the name 'top.1', which also numbers the parts of a side, allowed: "
   "another name."}};

const std::vector<WrongMesh> wrong_texts_of_version_4 = {
  {{{"1 4 1 4\n2 1 0 4", "1 4 1 4\n2 1 0 0"}}, "a.msh:16: found '1', allowed: $EndNodes."},
  {{{"0 0 1 7 0", "0 0 2 7 8 0"}},
   "a.msh:10: found curve 3 in 2 physical groups, allowed: one, because a side has one name."},
  {{{"0 1 1 0", "0 1 2 0"}},
   "a.msh:12: found '$EndEntities', allowed: the number of an entity (an integer)."}};

/** Three by three unit squares without the middle one and without the one at (2.5, 2.5). */
std::string squares_that_touch() {
  std::string nodes, elements;
  for (unsigned int j = 0; j < 4; ++j)
    for (unsigned int i = 0; i < 4; ++i)
      nodes +=
        std::to_string(1 + i + 4 * j) + " " + std::to_string(i) + " " + std::to_string(j) + " 0\n";
  for (unsigned int j = 0; j < 3; ++j)
    for (unsigned int i = 0; i < 3; ++i)
      if (i != j || i == 0)
        elements += std::to_string(1 + i + 3 * j) + " 3 0 " + std::to_string(1 + i + 4 * j) + " " +
                    std::to_string(2 + i + 4 * j) + " " + std::to_string(6 + i + 4 * j) + " " +
                    std::to_string(5 + i + 4 * j) + "\n";
  return "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n16\n" + nodes +
         "$EndNodes\n$Elements\n7\n" + elements + "$EndElements\n";
}

void test_arcs(Checks &checks) {
  struct WrongArc {
    Changes changes;
    std::string arc, message;
  };
  for (
    const WrongArc &wrong : std::vector<WrongArc>{
      {{},
       "botom",
       "a.prm:3: Geometry/Arcs: found the side 'botom', allowed: bottom, rest.1, rest.2, top."},
      {{},
       "bottom",
       "a.prm:3: Geometry/Arcs: the side 'bottom' is not one arc, allowed: nodes on one circle, to "
       "0.0001 of its radius."},
      {{{"6\n1 0", "8\n7 3 0.51 0\n8 3 2 0\n1 0"},
        {"2 1 0 0", "2 1 -0.2 0"},
        {"4\n1 1", "7\n5 1 2 1 1 2 3\n6 1 2 1 1 3 7\n7 3 2 1 1 3 7 8 6\n1 1"}},
       "bottom",
       "a.prm:3: Geometry/Arcs: the side 'bottom' is not one arc, allowed: nodes on one circle, to "
       "0.0001 of its radius."}})
    checks.refuses(wrong.message, [&] { read(change(version_2, wrong.changes), {wrong.arc}); });
}

void test_wrong_meshes(Checks &checks) {
  check_table(checks, version_2, wrong_texts);
  check_table(checks, version_4, wrong_texts_of_version_4);
  check_table(checks, squares_that_touch(),
              {{{},
                "a.msh: the body touches itself at node 11, allowed: a body whose parts share "
                "edges."}});
}

void test_good_meshes(Checks &checks) {
  checks.near("sides", {read(version_2).sides.size() * 1., read(version_4).sides.size() * 1.},
              {4., 2.}, 0.);
  const Geometry<2> mixed = read(change(
    version_2, {{"4\n1 1", "5\n1 1"}, {"4 3 2 0 1 2 3 6 5", "4 2 2 0 1 2 3 6\n5 2 2 0 1 6 5 2"}}));
  dealii::Triangulation<2> mesh;
  mixed.make_coarse_mesh(mesh);
  checks.that("triangles and a quadrilateral are split into ten cells",
              mesh.n_active_cells() == 10 && !mixed.note.empty());
  checks.near("  of the same area", dealii::GridTools::volume(mesh), 2., 1e-14);
  checks.that("regions have names or the numbers of surfaces",
              mixed.regions == std::vector<std::string>({"1"}) &&
                read(change(version_2, {{"4 3 2 0 1 2", "4 3 2 9 1 2"}})).regions ==
                  std::vector<std::string>({"9", "rest"}));
}

/** Names without dimensions, as in version 2.0 and, with -1, in the text that Gmsh makes of it. */
void test_old_names(Checks &checks) {
  for (const std::string dimension : {"", "-1 "}) {
    const Geometry<2> square = read(
      change(version_2,
             {{"2.2 0", "2 0"},
              {"2\n1 1 \"bottom\"\n1 2 \"top\"", "3\n" + dimension + "1 \"bottom\"\n" + dimension +
                                                   "2 \"top\"\n" + dimension + "9 \"soft part\""},
              {"4 3 2 0 1 2", "4 3 2 9 1 2"}}));
    checks.that("version 2.0: names of sides and regions, with '" + dimension + "'",
                square.side_names() ==
                    std::vector<std::string>({"bottom", "rest.1", "rest.2", "top"}) &&
                  square.regions == std::vector<std::string>({"rest", "soft part"}));
  }
}

/** Nodes of a quarter of the unit circle with five decimals: a side by Arcs, whose nodes move. */
void test_digits(Checks &checks) {
  const std::string fan =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n1 1 \"arc\"\n"
    "$EndPhysicalNames\n$Nodes\n6\n1 0 0 0\n2 1 0 0\n3 0.92388 0.38268 0\n"
    "4 0.70711 0.70711 0\n5 0.38268 0.92388 0\n6 0 1 0\n$EndNodes\n$Elements\n8\n"
    "1 1 2 1 1 2 3\n2 1 2 1 1 3 4\n3 1 2 1 1 4 5\n4 1 2 1 1 5 6\n"
    "5 2 2 0 1 1 2 3\n6 2 2 0 1 1 3 4\n7 2 2 0 1 1 4 5\n8 2 2 0 1 1 5 6\n"
    "$EndElements\n";
  const Geometry<2> quarter = read(fan, {"arc"});
  checks.near("five decimals: the radius", quarter.sides[quarter.find_side("arc")].radius(), 1.,
              2e-5);
  checks.that("  and how far nodes moved",
              quarter.note.find("nodes on arcs are moved onto them, by at most ") !=
                std::string::npos);
  checks.refuses("a.prm:3: Geometry/Arcs: the side 'arc' is not one arc, allowed: nodes on one "
                 "circle, to 0.0001 of its radius.",
                 [&] {
                   read(change(fan, {{"0.92388 0.38268", "0.924 0.3828"}}), {"arc"});
                 });
}

/** Surfaces of the file that are bodies, or regions of bodies. */
void test_parts(Checks &checks) {
  const auto part = [](const std::string &names, const std::string &body,
                       const std::vector<std::string> &bodies) {
    FileMesh<2> mesh = read_gmsh<2>(
      change(version_2,
             {{"Names\n2", names}, {"0 1 1 2 5 4", "3 1 1 2 5 4"}, {"0 1 2 3", "4 1 2 3"}}),
      "a.msh");
    keep_part(mesh, body, bodies);
    return make_geometry(mesh, {}, "");
  };
  const std::string two = "Names\n4\n2 3 \"a\"\n2 4 \"b\"",
                    steel = "Names\n4\n2 3 \"a.soft\"\n2 4 \"a.hard\"";
  const Geometry<2> right = part(two, "b", {"a", "b"});
  checks.near("the second square", right.lower[0], 1., 1e-15);
  checks.that("the line of the first one is left out",
              right.side_names() == std::vector<std::string>({"rest"}));
  checks.that("regions of a body",
              part(steel, "a", {"a", "b"}).regions == std::vector<std::string>({"hard", "soft"}));
  checks.refuses("a.msh: found the surface 'b', allowed: those of the bodies a, c.", [&] {
    part(two, "a", {"a", "c"});
  });
  checks.refuses("a.msh: found no surface 'c' for this body, allowed: a, b.", [&] {
    part(two, "c", {"a", "b", "c"});
  });
}
} // namespace

int main() {
  return run_tests(
    {test_good_meshes, test_wrong_meshes, test_arcs, test_old_names, test_digits, test_parts});
}
