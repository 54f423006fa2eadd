// SPDX-License-Identifier: LGPL-2.1-or-later
// Sides of rectangles, polygons and discs, lines of the mesh, and the rigid motions that roles
// leave free.

#include <signorini/problem/geometry/geometry.h>
#include <signorini/problem/geometry/shapes.h>
#include <signorini/problem/input/make_scene.h>
#include <signorini/problem/parameters/parameters.h>
#include <signorini/problem/scene/rigid_motions.h>

#include <cmath>
#include <set>

#include "tests.h"

using namespace Signorini;
using dealii::numbers::PI;

namespace {
using Point = dealii::Point<2>;

std::string names_of_motions(const Scene<2> &scene) {
  std::string names;
  for (const RigidMotion<2> &motion : free_rigid_motions(scene))
    names += (names.empty() ? "" : ", ") + motion.name();
  return names;
}

/** The motions that the sides leave free; the scene is not refused here. */
void test_rigid_motions(Checks &checks) {
  const std::string x = "the translation along (1, 0)", y = "the translation along (0, 1)";
  const std::string all = x + ", " + y + ", the rotation about (1, 0.5)";
  const std::vector<std::pair<std::vector<std::string>, std::string>> rows = {
    {{"Constants/Values=a=1"}, all},
    {{"Boundary/Rollers=left"}, y},
    {{"Boundary/Rollers=left right"}, y},
    {{"Boundary/Rollers=top"}, x},
    {{"Boundary/Rollers=left top"}, ""},
    {{"Boundary/Traction=left: 1; 0 | right: -1; 0 | top: 0; 0"}, all},
    {{"Boundary/Clamped=right"}, ""},
    {{"Boundary/Displacement=top: 0; -0.1"}, ""},
    // On the slanted side of a triangle.
    {{"Boundary/Rollers=side2", "Boundary/Contact=side0", "Geometry/Shape=polygon",
      "Geometry/Vertices=0,0; 4,0; 4,3"},
     "the translation along (0.8, 0.6)"}};
  for (const auto &[settings, expected] : rows) {
    std::vector<std::string> entries = {"Boundary/Contact=bottom"};
    entries.insert(entries.end(), settings.begin(), settings.end());
    if (settings.size() == 1)
      entries.emplace_back("Geometry/Upper right=2, 1");
    checks.that("free motions, " + settings[0],
                names_of_motions(make_described_scene<2>(
                  parse_parameters("", "scenes.prm", entries))) == expected);
  }
  // A ring turns about its centre.
  Scene<2> scene;
  scene.geometry = make_ring(1., 2.);
  scene.boundary.resize(2);
  checks.near("free ring: three motions", free_rigid_motions(scene).size(), 3, 0);
  for (const auto &[role, expected] :
       {std::pair(Role::roller, "the rotation about (0, 0)"), std::pair(Role::clamped, "")}) {
    scene.boundary[0].role = role;
    checks.that("ring", names_of_motions(scene) == expected);
  }
}

/** Where named sides begin and end, and that the body is where it should be; outlines.cc has
 * points, normals and arc lengths. */
void test_sides(Checks &checks) {
  const Geometry<2> rectangle = make_rectangle(Point(-1., 2.), Point(2., 4.), {3, 2}),
                    triangle = make_polygon({{0., 0.}, {4., 0.}, {4., 3.}}),
                    ring = make_ring(1., 2.), half = make_half_disc(1.5);
  const auto check = [&](const Geometry<2> &body, const std::string &name, const Point &start,
                         const Point &end, const Point &normal) {
    const Side<2> &side = body.sides.at(body.find_side(name));
    checks.near(name + ": start", side.start(), start, 1e-15);
    checks.near(name + ": end", side.end(), end, 1e-15);
    checks.near(name + ": normal", side.normal(0.), normal, 1e-15);
  };
  check(rectangle, "left", Point(-1., 2.), Point(-1., 4.), Point(-1., 0.));
  check(rectangle, "right", Point(2., 2.), Point(2., 4.), Point(1., 0.));
  check(rectangle, "bottom", Point(-1., 2.), Point(2., 2.), Point(0., -1.));
  check(rectangle, "top", Point(-1., 4.), Point(2., 4.), Point(0., 1.));
  check(triangle, "side2", Point(4., 3.), Point(0., 0.), Point(-0.6, 0.8));
  check(half, "flat", Point(-1.5, 0.), Point(1.5, 0.), Point(0., 1.));
  check(ring, "inner", Point(-1., 0.), Point(-1., 0.), Point(1., 0.));
  checks.that("names",
              triangle.side_names() == std::vector<std::string>({"side0", "side1", "side2"}));
  checks.near("diameters", {rectangle.diameter(), triangle.diameter()}, {std::sqrt(13.), 5.},
              1e-15);
  // An arc across the negative x-axis.
  const Curve arc = Curve::arc(Point(3., -1.), 0.5, 0.9 * PI, 1.4 * PI, Body::outside);
  for (const double angle : {0.95, 1.05, 1.39}) {
    const Point direction(std::cos(angle * PI), std::sin(angle * PI));
    const Point x(Point(3., -1.) + 0.5 * direction);
    const double s = 0.5 * PI * (angle - 0.9);
    checks.near("arc: point", arc.point(s), x, 1e-14);
    checks.near("arc: normal", arc.normal(s), Point(-direction[0], -direction[1]), 1e-14);
    checks.near("arc: length", arc.arc_length(x), s, 1e-14);
  }
}

/** Returns the positions of the vertices of the first graded mesh of a rectangle. */
std::vector<double> positions(const Geometry<2> &rectangle, const MeshGuides<2> &guides,
                              const unsigned int d) {
  dealii::Triangulation<2> mesh;
  rectangle.make_guided_mesh(mesh, 1, guides);
  std::set<double> found;
  for (const Point &vertex : mesh.get_vertices())
    found.insert(vertex[d]);
  return std::vector<double>(found.begin(), found.end());
}

/** The rectangle (-1, 1) x (0, 2) with 2 x 1 coarse cells, each divided in two and refined once:
 * four intervals in both directions. Lines split them evenly. */
void test_lines(Checks &checks) {
  const Geometry<2> rectangle = make_rectangle({-1., 0.}, {1., 2.}, {2, 1});
  using Lines = std::vector<double>;
  for (const auto &[name, lines, expected] : std::vector<std::tuple<std::string, Lines, Lines>>{
         {"no lines", {}, {-1., -0.5, 0., 0.5, 1.}},
         {"even parts", {0.4}, {-1., -1. + 1.4 / 3, -1. + 2.8 / 3, 0.4, 1.}},
         {"a line of the mesh stays", {-0.5}, {-1., -0.5, 0., 0.5, 1.}},
         {"two close lines", {0.4, 0.6}, {-1., -1. + 1.4 / 3, -1. + 2.8 / 3, 0.4, 0.6, 1.}},
         {"in any order", {0.6, -0.3, 0.4}, {-1., -0.3, 0.4, 0.6, 1.}},
         {"next to a side", {-0.9, 0.99}, {-1., -0.9, -0.4275, 0.045, 0.5175, 0.99, 1.}},
         {"on the sides and outside", {-1., 1., -3., 1.5}, {-1., -0.5, 0., 0.5, 1.}},
         {"given twice", {0.5, 0.5}, {-1., -0.5, 0., 0.5, 1.}}})
    checks.near("lines, " + name, positions(rectangle, {{{lines, {}}}, {}}, 0), expected, 1e-14);
  checks.near("points of sides",
              positions(rectangle, {{}, {{1, Point(1., 0.9)}, {2, Point(0.3, 0.)}}}, 1),
              {0., 0.45, 0.9, 1.45, 2.}, 1e-14);
  // Long rectangles get square cells, several bodies side by side.
  const Geometry<2> beam = make_rectangle({0., 0.}, {2., 0.25}, {1, 1});
  checks.near("square cells", positions(beam, {}, 0).size() - 1., 16., 0.);
  checks.near("square cells across", positions(beam, {}, 1).size() - 1., 2., 0.);
  const Geometry<2> both = unite({"beam", "block"}, {beam, rectangle});
  dealii::Triangulation<2> mesh;
  checks.near("no refinement is left", both.make_guided_mesh(mesh, 1, {}), 0., 0.);
  checks.near("cells of both bodies", mesh.n_active_cells(), 16. * 2. + 4. * 4., 0.);
  checks.near("predicted number", 4. * both.n_coarse_cells * both.division, 48., 1e-12);
}
} // namespace

int main() {
  return run_tests({test_sides, test_lines, test_rigid_motions});
}
