// SPDX-License-Identifier: LGPL-2.1-or-later
// Sides of rectangles and polygons, and the rigid motions that roles leave free.

#include <signorini/problem/geometry/geometry.h>
#include <signorini/problem/input/make_scene.h>
#include <signorini/problem/parameters/parameters.h>
#include <signorini/problem/scene/rigid_motions.h>

#include <cmath>
#include <set>

#include "tests.h"

using namespace Signorini;

namespace
{
using Point = dealii::Point<2>;

Parameters parameters(const std::vector<std::string> &settings)
{
  return parse_parameters("", "scenes.prm", settings);
}

/** What the sides leave free; the scene is not refused here. */
void test_rigid_motions(Checks &checks)
{
  const std::vector<std::pair<std::vector<std::string>, std::vector<std::string>>> rows = {
    {{},
     {"the translation along (1, 0)",
      "the translation along (0, 1)",
      "the rotation about (1, 0.5)"}},
    {{"Boundary/Rollers=left"}, {"the translation along (0, 1)"}},
    {{"Boundary/Rollers=left right"}, {"the translation along (0, 1)"}},
    {{"Boundary/Rollers=top"}, {"the translation along (1, 0)"}},
    {{"Boundary/Rollers=left top"}, {}},
    {{"Boundary/Traction=left: 1; 0 | right: -1; 0 | top: 0; 0"},
     {"the translation along (1, 0)",
      "the translation along (0, 1)",
      "the rotation about (1, 0.5)"}},
    {{"Boundary/Clamped=right"}, {}},
    {{"Boundary/Displacement=top: 0; -0.1"}, {}}};
  for (const auto &row : rows)
  {
    std::vector<std::string> settings = {"Boundary/Contact=bottom", "Geometry/Upper right=2, 1"};
    settings.insert(settings.end(), row.first.begin(), row.first.end());
    const auto motions = free_rigid_motions(make_described_scene<2>(parameters(settings)));
    const std::string name = row.first.empty() ? "nothing held" : row.first[0];
    checks.near(name + ": free motions", motions.size(), row.second.size(), 0);
    for (const std::string &expected : row.second)
    {
      bool found = false;
      for (const RigidMotion &motion : motions)
        found = found || motion.name() == expected;
      checks.that(name + ": " + expected, found);
    }
  }
  // A roller on the slanted side of a triangle slides along it.
  const auto slide =
    free_rigid_motions(make_described_scene<2>(parameters({"Geometry/Shape=polygon",
                                                           "Geometry/Vertices=0,0; 4,0; 4,3",
                                                           "Boundary/Contact=side0",
                                                           "Boundary/Rollers=side2"})));
  checks.that("slanted roller",
              slide.size() == 1 && slide[0].name() == "the translation along (0.8, 0.6)" &&
                std::abs(slide[0].translation * Point(-0.6, 0.8)) < 1e-12 &&
                std::abs(slide[0].rotation) < 1e-12);
}

void check_side(Checks &checks,
                const Geometry<2> &geometry,
                const std::string &name,
                const Point &start,
                const Point &end,
                const Point &normal)
{
  const std::size_t i = geometry.find_side(name);
  if (i == geometry.sides.size())
    return checks.that(name + " exists", false);
  const Side<2> &side = geometry.sides[i];
  const double length = std::hypot(end[0] - start[0], end[1] - start[1]);
  checks.near(name + ": ends", side.start().distance(start) + side.end().distance(end), 0., 1e-15);
  checks.near(name + ": normal", (side.normal(0.) - normal).norm(), 0., 1e-15);
  checks.near(name + ": length", side.length(), length, 1e-15);
  const Point middle = start + 0.25 * (end - start);
  checks.near(name + ": arc length", side.arc_length(middle), 0.25 * length, 1e-15);
  checks.near(name + ": point", side.point(0.25 * length).distance(middle), 0., 1e-15);
}

void test_geometry(Checks &checks)
{
  const Geometry<2> rectangle = make_rectangle(Point(-1., 2.), Point(2., 4.), {3, 2});
  check_side(checks, rectangle, "left", Point(-1., 2.), Point(-1., 4.), Point(-1., 0.));
  check_side(checks, rectangle, "right", Point(2., 2.), Point(2., 4.), Point(1., 0.));
  check_side(checks, rectangle, "bottom", Point(-1., 2.), Point(2., 2.), Point(0., -1.));
  check_side(checks, rectangle, "top", Point(-1., 4.), Point(2., 4.), Point(0., 1.));
  checks.near("rectangle: four sides", rectangle.sides.size(), 4, 0);
  checks.near("rectangle: diameter", rectangle.diameter(), std::sqrt(13.), 1e-15);

  const Geometry<2> triangle = make_polygon({Point(0., 0.), Point(4., 0.), Point(4., 3.)});
  check_side(checks, triangle, "side0", Point(0., 0.), Point(4., 0.), Point(0., -1.));
  check_side(checks, triangle, "side1", Point(4., 0.), Point(4., 3.), Point(1., 0.));
  check_side(checks, triangle, "side2", Point(4., 3.), Point(0., 0.), Point(-0.6, 0.8));
  checks.that("triangle: names",
              triangle.side_names() == std::vector<std::string>({"side0", "side1", "side2"}));
  checks.near("triangle: diameter", triangle.diameter(), 5., 0.);
}
/** Arc length, point and normal of an arc agree with each other and with angles. */
void check_arc(Checks &checks,
               const std::string &name,
               const Side<2> &arc,
               const Point &centre,
               const double radius,
               const double first,
               const double last,
               const double sign)
{
  checks.near(name + ": length", arc.length(), radius * (last - first), 1e-14);
  double point = 0., normal = 0., length = 0.;
  for (const double share : {0., 0.1, 0.37, 0.5, 0.85, 0.999})
  {
    const double s = share * arc.length(), angle = first + share * (last - first);
    const Point direction(std::cos(angle), std::sin(angle));
    point = std::max(point, arc.point(s).distance(centre + radius * direction));
    normal = std::max(normal, (arc.normal(s) - sign * direction).norm());
    length = std::max(length, std::abs(arc.arc_length(arc.point(s)) - s));
  }
  checks.near(name + ": points", point, 0., 1e-14);
  checks.near(name + ": normals", normal, 0., 1e-14);
  checks.near(name + ": arc lengths", length, 0., 1e-14);
}

void test_curved_geometry(Checks &checks)
{
  const double pi = dealii::numbers::PI;
  const Geometry<2> ring = make_ring(1., 2.);
  check_arc(checks, "inner circle", ring.sides[0], Point(), 1., -pi, pi, -1.);
  check_arc(checks, "outer circle", ring.sides[1], Point(), 2., -pi, pi, 1.);
  checks.that("circles are closed", ring.sides[0].is_closed() && ring.sides[1].is_closed());

  const Geometry<2> half = make_half_disc(1.5);
  check_side(checks, half, "flat", Point(-1.5, 0.), Point(1.5, 0.), Point(0., 1.));
  check_arc(checks, "half circle", half.sides[1], Point(), 1.5, -pi, 0., 1.);
  checks.that("half a circle is open", !half.sides[1].is_closed());
  check_arc(checks,
            "arc across the negative x-axis",
            Side<2>("arc", Curve::arc(Point(3., -1.), 0.5, 0.9 * pi, 1.4 * pi, Body::outside)),
            Point(3., -1.),
            0.5,
            0.9 * pi,
            1.4 * pi,
            -1.);

  // A ring on rollers turns about its centre; a half disc on rollers along its arc does so, too.
  Scene<2> scene;
  scene.geometry = ring;
  scene.boundary.resize(2);
  checks.near("free ring: three motions", free_rigid_motions(scene).size(), 3, 0);
  scene.boundary[0].role = Role::roller;
  checks.that("ring on rollers: the rotation about its centre",
              free_rigid_motions(scene).size() == 1 &&
                free_rigid_motions(scene)[0].name() == "the rotation about (0, 0)");
  scene.boundary[0].role = Role::clamped;
  checks.that("clamped ring", free_rigid_motions(scene).empty());
}

/** The positions of the vertices of a mesh, in ascending order. */
std::vector<double> positions(const dealii::Triangulation<2> &mesh, const unsigned int d)
{
  std::set<double> found;
  for (const Point &x : mesh.get_vertices())
    found.insert(x[d]);
  return {found.begin(), found.end()};
}

/** The rectangle (-1, 1) x (0, 2) with 2 x 1 coarse cells, refined once: four intervals between -1
 * and 1, two between 0 and 2. */
void test_lines(Checks &checks)
{
  struct Row
  {
    std::string name;
    std::vector<double> lines, expected;
  };
  const Geometry<2> rectangle = make_rectangle({-1., 0.}, {1., 2.}, {2, 1});
  for (const Row &row :
       std::vector<Row>{{"no lines", {}, {-1., -0.5, 0., 0.5, 1.}},
                        {"the nearest line moves", {0.4}, {-1., -0.5, 0., 0.4, 1.}},
                        {"a line of the mesh stays", {-0.5}, {-1., -0.5, 0., 0.5, 1.}},
                        {"two lines near one position", {0.4, 0.6}, {-1., -0.5, 0., 0.4, 0.6, 1.}},
                        {"in any order", {0.6, -0.3, 0.4}, {-1., -0.3, 0., 0.4, 0.6, 1.}},
                        {"next to a side", {-0.9, 0.99}, {-1., -0.9, -0.5, 0., 0.5, 0.99, 1.}},
                        {"on the sides and outside", {-1., 1., -3., 1.5}, {-1., -0.5, 0., 0.5, 1.}},
                        {"given twice", {0.3, 0.3}, {-1., -0.5, 0., 0.3, 1.}}})
  {
    dealii::Triangulation<2> mesh;
    rectangle.make_mesh_with_lines(mesh, 1, {{row.lines, {}}});
    const std::vector<double> found = positions(mesh, 0);
    double error = found.size() == row.expected.size() ? 0. : 1.;
    for (std::size_t i = 0; i < found.size() && error == 0.; ++i)
      error = std::max(error, std::abs(found[i] - row.expected[i]));
    checks.near("lines, " + row.name, error, 0., 1e-14);
  }
  dealii::Triangulation<2> mesh;
  rectangle.make_mesh_with_lines(mesh, 1, {{{0.4}, {0.9, 1.7}}});
  const std::vector<double> y = positions(mesh, 1);
  checks.that("lines in both directions",
              y.size() == 4 && std::abs(y[1] - 0.9) < 1e-14 && std::abs(y[2] - 1.7) < 1e-14);
}
} // namespace

int main()
{
  dealii::deal_II_exceptions::disable_abort_on_exception();
  Checks checks;
  test_geometry(checks);
  test_lines(checks);
  test_curved_geometry(checks);
  test_rigid_motions(checks);
  return checks.exit_code();
}
