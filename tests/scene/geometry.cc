// SPDX-License-Identifier: LGPL-2.1-or-later
// Sides of rectangles and polygons, and the rigid motions that roles leave free.

#include <signorini/parameters/parameters.h>
#include <signorini/scene/described.h>
#include <signorini/scene/geometry.h>
#include <signorini/scene/rigid_motions.h>

#include <cmath>

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
    const auto motions = free_rigid_motions(make_described_scene(parameters(settings)));
    const std::string name = row.first.empty() ? "nothing held" : row.first[0];
    checks.near(name + ": free motions", motions.size(), row.second.size(), 0);
    for (const std::string &expected : row.second)
    {
      bool found = false;
      for (const RigidMotion &motion : motions)
        found = found || motion.name == expected;
      checks.that(name + ": " + expected, found);
    }
  }
  // A roller on the slanted side of a triangle slides along it.
  const auto slide =
    free_rigid_motions(make_described_scene(parameters({"Geometry/Shape=polygon",
                                                        "Geometry/Vertices=0,0; 4,0; 4,3",
                                                        "Boundary/Contact=side0",
                                                        "Boundary/Rollers=side2"})));
  checks.that("slanted roller",
              slide.size() == 1 && slide[0].name == "the translation along (0.8, 0.6)" &&
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
  checks.near(name + ": ends", side.start.distance(start) + side.end.distance(end), 0., 1e-15);
  checks.near(name + ": normal", (side.normal - normal).norm(), 0., 1e-15);
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
} // namespace

int main()
{
  dealii::deal_II_exceptions::disable_abort_on_exception();
  Checks checks;
  test_geometry(checks);
  test_rigid_motions(checks);
  return checks.exit_code();
}
