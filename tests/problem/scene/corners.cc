// SPDX-License-Identifier: LGPL-2.1-or-later
// Corners of bodies: places, openings, sides, and the exponents of a scene's roles.

#include <signorini/problem/input/make_scene.h>
#include <signorini/problem/parameters/parameters.h>
#include <signorini/problem/scene/corners.h>

#include <deal.II/base/numbers.h>

#include <utility>

#include "tests.h"

using namespace Signorini;
using dealii::numbers::PI;

namespace
{
using Point = dealii::Point<2>;

/** There is exactly one corner at x, and it is what is expected. */
void check_corner(Checks &checks,
                  const std::string &name,
                  const Geometry<2> &geometry,
                  const Point &x,
                  const double angle,
                  const std::string &first,
                  const std::string &second)
{
  unsigned int n = 0;
  for (const Corner &corner : corners(geometry))
    if (corner.position.distance(x) < 1e-12)
    {
      ++n;
      checks.near(name + ": angle", corner.angle, angle, 1e-7);
      checks.that(name + ": sides",
                  geometry.sides[corner.sides[0]].name() == first &&
                    geometry.sides[corner.sides[1]].name() == second);
    }
  checks.near(name + ": is one corner", n, 1, 0);
}

double sum_of_angles(const Geometry<2> &geometry)
{
  double sum = 0.;
  for (const Corner &corner : corners(geometry))
    sum += corner.angle;
  return sum;
}

void test_convex_bodies(Checks &checks)
{
  const Geometry<2> rectangle = make_rectangle(Point(-1., 2.), Point(2., 4.), {3, 2});
  checks.near("rectangle: number of corners", corners(rectangle).size(), 4, 0);
  check_corner(checks, "lower left", rectangle, Point(-1., 2.), 0.5 * PI, "bottom", "left");
  check_corner(checks, "upper left", rectangle, Point(-1., 4.), 0.5 * PI, "left", "top");

  // The third vertex lies on a straight line with its neighbours.
  const Geometry<2> pentagon =
    make_polygon({Point(0., 0.), Point(3., -1.), Point(4., 0.), Point(5., 1.), Point(1., 4.)});
  checks.near("pentagon: number of corners", corners(pentagon).size(), 5, 0);
  check_corner(checks, "straight", pentagon, Point(4., 0.), PI, "side2", "side1");
  checks.near("pentagon: sum of the angles", sum_of_angles(pentagon), 3. * PI, 1e-12);
}

void test_curved_bodies(Checks &checks)
{
  const Geometry<2> half = make_half_disc(1.5);
  checks.near("half disc: number of corners", corners(half).size(), 2, 0);
  check_corner(checks, "half disc, left", half, Point(-1.5, 0.), 0.5 * PI, "arc", "flat");
  check_corner(checks, "half disc, right", half, Point(1.5, 0.), 0.5 * PI, "flat", "arc");
  checks.that("ring: no corner", corners(make_ring(1., 2.)).empty());
  // A disc with two sides is smooth where they meet.
  Geometry<2> disc = half;
  disc.sides = {{"lower", Curve::arc(Point(), 1.5, -PI, 0., Body::inside)},
                {"upper", Curve::arc(Point(), 1.5, 0., PI, Body::inside)}};
  check_corner(checks, "disc, right", disc, Point(1.5, 0.), PI, "upper", "lower");
  // The plane without the half disc y < 0, R = 1: a notch of 270 degrees on either side.
  Geometry<2> notch = half;
  notch.sides = {{"floor", Curve(Point(1., 0.), Point(2., 0.), Point(0., -1.))},
                 {"bow", Curve::arc(Point(), 1., 0., PI, Body::outside)}};
  check_corner(checks, "bow", notch, Point(1., 0.), 0.5 * PI, "floor", "bow");
}

void test_reentrant_bodies(Checks &checks)
{
  // Around the origin the body fills three quadrants; one side runs against the walk.
  Geometry<2> l_shape;
  l_shape.lower = Point(-1., -1.);
  l_shape.upper = Point(1., 1.);
  l_shape.sides = {{"step", Curve(Point(0., 0.), Point(1., 0.), Point(0., -1.))},
                   {"wall", Curve(Point(0., 0.), Point(0., -1.), Point(1., 0.))}};
  check_corner(checks, "re-entrant", l_shape, Point(), 1.5 * PI, "step", "wall");
  l_shape.sides = {{"above", Curve(Point(0., 0.), Point(1., 0.), Point(0., -1.))},
                   {"below", Curve(Point(1., 0.), Point(0., 0.), Point(0., 1.))}};
  check_corner(checks, "crack", l_shape, Point(), 2. * PI, "above", "below");
  // Two squares that touch in a point: the first and the third quadrant.
  l_shape.sides = {{"1x", Curve(Point(), Point(1., 0.), Point(0., -1.))},
                   {"1y", Curve(Point(), Point(0., 1.), Point(-1., 0.))},
                   {"3x", Curve(Point(), Point(-1., 0.), Point(0., 1.))},
                   {"3y", Curve(Point(), Point(0., -1.), Point(1., 0.))}};
  const auto found = corners(l_shape);
  checks.that("two squares",
              found.size() == 2 && std::abs(found[0].angle - 0.5 * PI) < 1e-12 &&
                std::abs(found[1].angle - 0.5 * PI) < 1e-12 && found[0].sides[1] == 1 &&
                found[1].sides[1] == 3);
}

/** The roles of a scene: nu = 0.3 in plane strain, held at the top, contact at the bottom. */
void test_scene(Checks &checks)
{
  const Scene<2> scene =
    make_described_scene<2>(parse_parameters("",
                                             "scenes.prm",
                                             {"Boundary/Contact=bottom",
                                              "Boundary/Clamped=top",
                                              "Boundary/Rollers=left",
                                              "Material/Poisson's ratio=0.3"}));
  for (const Corner &corner : corners(scene.geometry))
  {
    const double exponent = corner_exponent(scene, corner);
    const bool left = corner.position[0] < 0.5, bottom = corner.position[1] < 0.5;
    if (left && bottom)
      checks.near("contact and rollers: smooth", exponent, 3., 0.);
    else if (bottom)
      checks.near("contact and a free side: the state without contact", exponent, 2.739593, 1e-6);
    else if (!left)
      checks.near("held and free", exponent, 0.71117, 1e-5);
    else
      checks.near("held and rollers: half of a straight held edge", exponent, 3., 0.);
  }
}

/** Sides that agree where they meet, but for rounding, are no contradiction; wrong_files.txt has
 * those that are. */
void test_agreement(Checks &checks)
{
  const auto agree = [&](const std::string &name, const std::vector<std::string> &settings) {
    std::vector<std::string> all = {"Boundary/Contact=bottom"};
    all.insert(all.end(), settings.begin(), settings.end());
    const Parameters parameters = parse_parameters("", "scenes.prm", all);
    checks.that("agree: " + name,
                (dimension_of(parameters) == 2
                   ? find_contradiction(make_described_scene<2>(parameters))
                   : find_contradiction(make_described_scene<3>(parameters)))
                  .empty());
  };
  agree("along rollers", {"Boundary/Displacement=top: 0.3*x; -0.05", "Boundary/Rollers=left"});
  agree("a turning plate whose end moves along rollers",
        {"Boundary/Plates=top: 0, -1 turning",
         "Load/Plate force=top: 1",
         "Boundary/Rollers=left right"});
  agree("a plate that moves past a gap",
        {"Boundary/Plates=left: 1, -1", "Load/Plate force=left: 1", "Contact/Gap=0"});
  agree("a plate that rests",
        {"Boundary/Plates=top: 0.6, -1", "Load/Plate travel=top: 0", "Boundary/Clamped=left"});
  agree("rounding",
        {"Boundary/Displacement=top: 1e-3*sin(pi*x); 0 | right: sin(pi)*y; 0",
         "Boundary/Clamped=left"});
  agree("rollers and rollers", {"Boundary/Rollers=left right top"});
  agree("along an inclined side",
        {"Geometry/Shape=polygon",
         "Geometry/Vertices=0,0; 1,0; 1,1; 0.577350269,1",
         "Boundary/Contact=side0",
         "Boundary/Rollers=side3",
         "Boundary/Plates=side2: -0.5, -0.866025",
         "Load/Plate force=side2: 1"});
  agree("the gap begins where the held side ends",
        {"Boundary/Displacement=left: 0; -0.01", "Contact/Foundation=plane 0,-0.01 normal 0,1"});
  agree("in space",
        {"Dimension=3",
         "Boundary/Displacement=top: 0.1*x; 0.2*y; -0.05",
         "Boundary/Rollers=left front"});
}
} // namespace

int main()
{
  Checks checks;
  test_convex_bodies(checks);
  test_curved_bodies(checks);
  test_reentrant_bodies(checks);
  test_scene(checks);
  test_agreement(checks);
  return checks.exit_code();
}
