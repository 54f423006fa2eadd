// SPDX-License-Identifier: LGPL-2.1-or-later
// Files that Gmsh has written: sides, lengths, areas and refined meshes of a bracket, a plate with
// a hole and a half disc.

#include <signorini/discretization/mesh/mesh.h>
#include <signorini/problem/mesh_file/file_geometry.h>
#include <signorini/problem/scene/corners.h>

#include <deal.II/base/numbers.h>

#include "problem/measures.h"
#include "tests.h"

using namespace Signorini;
using dealii::numbers::PI;

namespace {
const std::string files = SOURCE_DIR "/tests/problem/mesh_file/", parts = SOURCE_DIR "/prm/parts/";

Geometry<2> read(const std::string &file, const std::vector<std::string> &arcs = {}) {
  return make_geometry(read_gmsh<2>(file_text(file), file), arcs, "arcs");
}

const Side<2> &side_of(const Geometry<2> &geometry, const std::string &name) {
  return geometry.sides.at(geometry.find_side(name));
}

/** Area, length of the boundary and names of the sides; int n ds = 0. */
void check_body(Checks &checks, const std::string &name, const Geometry<2> &geometry,
                const std::vector<std::string> &names, const double area, const double length) {
  checks.about(name);
  checks.that("names", geometry.side_names() == names);
  double sides = 0.;
  for (const Side<2> &side : geometry.sides)
    sides += side.length();
  const double size = geometry.diameter();
  checks.near("the sides have the length of the boundary", sides, length, 1e-9 * size);
  std::vector<Measures> found;
  for (const unsigned int level : {1, 2, 3}) {
    const Mesh<2> mesh(geometry, 0, level, MPI_COMM_SELF);
    found.push_back(measure(geometry, mesh.triangulation(), geometry.curved ? 2 : 1));
    checks.that("no cell is turned inside out", found.back().shape > 0.);
    checks.near("int n ds vanishes", found.back().normals.norm(), 0., 1e-12 * size);
    for (const auto &face : mesh.triangulation().active_face_iterators())
      if (face->at_boundary()) {
        const Side<2> &side = geometry.sides[face->boundary_id()];
        const dealii::Point<2> x = face->vertex(0);
        checks.near("vertices stay on the sides", side.point(side.arc_length(x)), x, 1e-13 * size);
      }
  }
  checks.near("area", found[1].area, area, geometry.curved ? 2e-5 * area : 1e-9 * size * size);
  if (!geometry.curved)
    return;
  // Parabolas on arcs: order four.
  checks.near("order of the area", std::log2((found[0].area - area) / (found[1].area - area)), 4.,
              0.2);
  checks.near("order of the length",
              std::log2((found[0].length - length) / (found[1].length - length)), 4., 0.2);
}

void check_bracket(Checks &checks) {
  const double area = 2800. + 400. * (1. - PI / 4.), length = 280. + 10. * PI;
  // Parts of a name are counted from left to right: the upper one begins at (20, 40).
  const std::vector<std::string> names = {"back",   "fillet", "foot", "rest.1",
                                          "rest.2", "tip",    "top"};
  const Geometry<2> bracket = read(parts + "bracket.msh");
  check_body(checks, "bracket", bracket, names, area, length);
  const Side<2> foot = side_of(bracket, "foot"), fillet = side_of(bracket, "fillet");
  checks.near("an arc, a segment, and the parts of a name",
              {fillet.length(), foot.length(), foot.normal(1.)[1],
               side_of(bracket, "rest.1").start()[1], side_of(bracket, "rest.2").start()[0]},
              {10. * PI, 80., -1., 40., 80.}, 1e-9);
  checks.that("flat", foot.is_flat() && !fillet.is_flat());
  check_body(checks, "8 nodes, version 2.2", read(files + "bracket_2_v2.msh"), names, area, length);
  for (const std::string file : {"bracket_1.msh", "bracket_1_v4.msh"}) {
    check_body(checks, file, read(files + file, {"fillet"}), names, area, length);
    const Geometry<2> straight = read(files + file);
    checks.that("without arcs it has no curved cells, and several pieces for the fillet",
                !straight.curved && side_of(straight, "fillet").n_pieces() > 2);
  }
}

void check_plate(Checks &checks) {
  const std::vector<std::string> names = {"bottom", "hole", "left", "right", "top"};
  const double radius = 0.2, area = 2. - PI * radius * radius, length = 6. + 2. * PI * radius;
  const Geometry<2> plate = read(parts + "plate_with_hole.msh");
  check_body(checks, "plate", plate, names, area, length);
  const Side<2> hole = side_of(plate, "hole");
  checks.near("the hole is a circle", hole.length(), 2. * PI * radius, 1e-12);
  const dealii::Tensor<1, 2> outwards = dealii::Point<2>(1., 0.5) - hole.point(0.3);
  checks.near("normals of the hole", hole.normal(0.3) * outwards, radius, 1e-12);
  checks.that("closed, four corners", hole.is_closed() && corners(plate).size() == 4);
  const std::string file = files + "plate_with_hole_1.msh";
  check_body(checks, "plate with a declared circle", read(file, {"hole"}), names, area, length);
  const Geometry<2> facets = read(file);
  const unsigned int n = side_of(facets, "hole").n_pieces();
  check_body(checks, "plate with facets", facets, names,
             2. - 0.5 * n * radius * radius * std::sin(2. * PI / n),
             6. + 2. * n * radius * std::sin(PI / n));
  checks.that("a closed polygon", side_of(facets, "hole").is_closed() && n >= 8);
}

void check_half_disc(Checks &checks) {
  const Geometry<2> disc = read(parts + "half_disc.msh");
  check_body(checks, "half disc", disc, {"arc", "flat"}, PI / 2., PI + 2.);
  checks.that("the arc is one piece", side_of(disc, "arc").n_pieces() == 1);
  checks.near("the box around it", disc.lower[1], -1., 1e-14);
  check_body(checks, "half disc with a declared arc", read(files + "half_disc_1.msh", {"arc"}),
             {"arc", "flat"}, PI / 2., PI + 2.);
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv, {check_bracket, check_plate, check_half_disc});
}
