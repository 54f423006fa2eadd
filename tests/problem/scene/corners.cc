// SPDX-License-Identifier: LGPL-2.1-or-later
// Corners of bodies: positions, openings, sides, and the exponents of a scene's roles.

#include <signorini/problem/geometry/shapes.h>
#include <signorini/problem/input/make_scene.h>
#include <signorini/problem/parameters/parameters.h>
#include <signorini/problem/scene/contradictions.h>
#include <signorini/problem/scene/corners.h>

#include <deal.II/base/numbers.h>

#include <algorithm>

#include "contact_of.h"
#include "tests.h"

using namespace Signorini;
using dealii::numbers::PI;

namespace {
using Point = dealii::Point<2>;

/** There is exactly one corner at x, with this angle and between these sides. */
void check_corner(Checks &checks, const Geometry<2> &geometry, const Point &x, const double angle,
                  const std::string &sides) {
  std::vector<double> angles;
  for (const Corner &corner : corners(geometry))
    if (corner.position.distance(x) < 1e-12) {
      angles.push_back(corner.angle);
      checks.that("between " + sides, geometry.sides[corner.sides[0]].name() + " " +
                                          geometry.sides[corner.sides[1]].name() ==
                                        sides);
    }
  checks.near("angle between " + sides, angles, {angle}, 1e-7);
}

void test_bodies(Checks &checks) {
  const Geometry<2> rectangle = make_rectangle(Point(-1., 2.), Point(2., 4.), {3, 2});
  checks.near("rectangle: number of corners", corners(rectangle).size(), 4, 0);
  check_corner(checks, rectangle, Point(-1., 2.), 0.5 * PI, "bottom left");
  check_corner(checks, rectangle, Point(-1., 4.), 0.5 * PI, "left top");
  // The third vertex lies on a straight line with its neighbours.
  const Geometry<2> pentagon = make_polygon({{0., 0.}, {3., -1.}, {4., 0.}, {5., 1.}, {1., 4.}});
  double sum = 0.;
  for (const Corner &corner : corners(pentagon))
    sum += corner.angle;
  check_corner(checks, pentagon, Point(4., 0.), PI, "side2 side1");
  checks.near("pentagon: sum of the angles", sum, 3. * PI, 1e-12);
  const Geometry<2> half = make_half_disc(1.5);
  checks.near("half disc: number of corners", corners(half).size(), 2, 0);
  check_corner(checks, half, Point(-1.5, 0.), 0.5 * PI, "arc flat");
  check_corner(checks, half, Point(1.5, 0.), 0.5 * PI, "flat arc");
  checks.that("ring: no corner", corners(make_ring(1., 2.)).empty());
}

/** Two sides that meet: smooth, a notch, a re-entrant corner, a crack. */
void test_pairs_of_sides(Checks &checks) {
  Geometry<2> geometry = make_half_disc(1.5);
  const auto check = [&](const std::vector<Side<2>> &sides, const Point &x, const double angle) {
    geometry.sides = sides;
    check_corner(checks, geometry, x, angle, sides[0].name() + " " + sides[1].name());
  };
  const Point right(1., 0.), down(0., -1.);
  check({{"upper", Curve::arc(Point(), 1.5, 0., PI, Body::inside)},
         {"lower", Curve::arc(Point(), 1.5, -PI, 0., Body::inside)}},
        Point(1.5, 0.), PI);
  // The plane without the half disc y < 0, R = 1.
  check({{"floor", Curve(right, Point(2., 0.), down)},
         {"bow", Curve::arc(Point(), 1., 0., PI, Body::outside)}},
        right, 0.5 * PI);
  geometry.lower = Point(-1., -1.);
  geometry.upper = Point(1., 1.);
  check({{"step", Curve(Point(), right, down)}, {"wall", Curve(Point(), down, right)}}, Point(),
        1.5 * PI);
  check({{"above", Curve(Point(), right, down)}, {"below", Curve(right, Point(), -down)}}, Point(),
        2. * PI);
  // Two squares that touch in a point: the first and the third quadrant.
  geometry.sides = {{"1x", Curve(Point(), right, down)},
                    {"1y", Curve(Point(), -down, -right)},
                    {"3x", Curve(Point(), -right, -down)},
                    {"3y", Curve(Point(), down, right)}};
  const auto found = corners(geometry);
  checks.near("two squares", {found.at(0).angle, found.at(1).angle, double(found.size())},
              {0.5 * PI, 0.5 * PI, 2.}, 1e-12);
  checks.that("each in itself", found[0].sides[1] == 1 && found[1].sides[1] == 3);
}

/** The roles of a scene: nu = 0.3 in plane strain, held at the top, contact at the bottom. */
void test_scene(Checks &checks) {
  const Scene<2> scene = make_described_scene<2>(
    parse_parameters("", "scenes.prm",
                     {"Boundary/Contact=bottom", "Boundary/Clamped=top", "Boundary/Rollers=left",
                      "Material/Poisson's ratio=0.3"}));
  for (const Corner &corner : corners(scene.geometry)) {
    const bool left = corner.position[0] < 0.5, bottom = corner.position[1] < 0.5;
    // Rollers continue a free or a held edge; a contact side counts as free.
    checks.near("exponents of a scene",
                smallest_exponent(scene, corner.position, corner.sides, layers_at(scene, corner)),
                left     ? 3.
                : bottom ? 2.739593
                         : 0.71117,
                1e-5);
  }
}

/** Layers at corners and ends of interfaces: an oblique one, one that ends in a corner, one of a
 * curve, and moduli that vary without a jump. */
void test_layers(Checks &checks) {
  const auto scene_of = [](const std::string &modulus) {
    return make_described_scene<2>(
      parse_parameters("", "scenes.prm",
                       {"Boundary/Contact=bottom", "Boundary/Clamped=top",
                        "Material/Young's modulus=" + modulus, "Material/Poisson's ratio=0.3"}));
  };
  struct Row {
    std::string modulus;
    /** On left, right, bottom and top together, their sum of coordinates, and layers at 0. */
    double n_ends, sum;
    std::vector<double> angles;
  };
  for (const Row &row :
       std::vector<Row>{{"y<0.3+0.1*x ? 5 : 1", 2, 0.3 + 1.4, {0.5 * PI}},
                        {"y<x ? 5 : 1", 0, 0., {0.25 * PI, 0.25 * PI}},
                        {"x^2+y^2<0.25 ? 5 : 1", 2, 1., {0.5 * PI}},
                        {"1+50*x*y", 0, 0., {0.5 * PI}},
                        {"abs(x-0.7)<0.005 ? 5 : 1", 4, 4 * 0.7 + 2., {0.5 * PI}}}) {
    const Scene<2> scene = scene_of(row.modulus);
    double n = 0., sum = 0.;
    for (const Corner &end : interface_ends(scene)) {
      n += 1.;
      sum += end.position[0] + end.position[1];
      checks.near(row.modulus + ": both materials", layers_at(scene, end).size(), 2., 0.);
    }
    checks.near(row.modulus + ": ends", {n, sum}, {row.n_ends, row.sum}, 1e-6);
    for (const Corner &corner : corners(scene.geometry))
      if (corner.position.norm() < 1e-12) {
        std::vector<double> angles;
        for (const WedgeLayer &layer : layers_at(scene, corner))
          angles.push_back(layer.angle);
        checks.near(row.modulus + ": layers", angles, row.angles, 1e-6);
      }
  }
}

/** Sides that agree where they meet, but for rounding, are no contradiction; wrong_files.txt has
 * those that are. */
void test_agreement(Checks &checks) {
  const std::vector<std::pair<std::string, std::vector<std::string>>> rows = {
    {"along rollers", {"Boundary/Displacement=top: 0.3*x; -0.05", "Boundary/Rollers=left"}},
    {"a turning plate whose end moves along rollers",
     {"Boundary/Plates=top: 0, -1 turning", "Load/Plate force=top: 1",
      "Boundary/Rollers=left right"}},
    {"a plate that moves past a gap",
     {"Boundary/Plates=left: 1, -1", "Load/Plate force=left: 1", "Contact/Gap=0"}},
    {"a plate that rests",
     {"Boundary/Plates=top: 0.6, -1", "Load/Plate travel=top: 0", "Boundary/Clamped=left"}},
    {"rounding",
     {"Boundary/Displacement=top: 1e-3*sin(pi*x); 0 | right: sin(pi)*y; 0",
      "Boundary/Clamped=left"}},
    {"rollers and rollers", {"Boundary/Rollers=left right top"}},
    {"along an inclined side",
     {"Geometry/Shape=polygon", "Geometry/Vertices=0,0; 1,0; 1,1; 0.577350269,1",
      "Boundary/Contact=side0", "Boundary/Rollers=side3", "Boundary/Plates=side2: -0.5, -0.866025",
      "Load/Plate force=side2: 1"}},
    {"the gap begins where the held side ends",
     {"Boundary/Displacement=left: 0; -0.01", "Contact/Foundation=plane 0,-0.01 normal 0,1"}},
    {"in 3-D",
     {"Dimension=3", "Boundary/Displacement=top: 0.1*x; 0.2*y; -0.05",
      "Boundary/Rollers=left front"}}};
  for (const auto &[name, settings] : rows) {
    const Parameters parameters =
      parse_parameters("subsection Boundary\nset Contact = bottom\nend\n", "scenes.prm", settings);
    checks.that("agree: " + name, (dimension_of(parameters) == 2
                                     ? find_contradiction(make_described_scene<2>(parameters))
                                     : find_contradiction(make_described_scene<3>(parameters)))
                                    .empty());
  }
}

/** Two blocks, one on the other: only data that both sides prescribe at points across contradicts.
 */
void test_pairs_of_bodies(Checks &checks) {
  struct Row {
    std::string name;
    std::vector<std::string> settings;
    bool contradicts;
  };
  const std::string both = "Boundary/Displacement=low.left: 0; 0.1 | up.left: 0; ";
  const std::vector<Row> rows = {
    {"both move together", {both + "0.1"}, false},
    {"both move apart", {both + "0.2"}, false},
    {"both move into each other", {both + "0.05"}, true},
    {"  the gap lets them", {both + "0.05", "Contact/Gap=0.06"}, false},
    {"interference, one is held", {"Boundary/Clamped=low.left up.top", "Contact/Gap=-0.01"}, false},
    {"interference, both are held",
     {"Boundary/Clamped=low.right up.right", "Contact/Gap=-0.01"},
     true},
    {"  the other one is named first",
     {"Boundary/Clamped=low.right up.right", "Contact/Gap=-0.01",
      "Boundary/Contact=up.bottom with low.top"},
     true},
    {"  rollers let them slide apart",
     {"Boundary/Rollers=low.right up.right low.bottom up.top", "Contact/Gap=-0.01"},
     false},
    {"  held where nothing is across",
     {"Boundary/Clamped=low.right up.right", "Contact/Gap=-0.01",
      "Geometry/Upper right=low: 1, 1 | "
      "up: 1.5, 2"},
     false}};
  for (const auto &[name, settings, contradicts] : rows) {
    std::vector<std::string> all = {"Geometry/Bodies=low up",
                                    "Geometry/Lower left=low: 0, 0 | up: 0, 1"};
    const auto has = [&settings = settings](const std::string &entry) {
      return std::any_of(settings.begin(), settings.end(),
                         [&entry](const std::string &text) { return text.rfind(entry, 0) == 0; });
    };
    for (const char *usual :
         {"Geometry/Upper right=low: 1, 1 | up: 1, 2", "Boundary/Contact=low.top with up.bottom"})
      if (!has(std::string(usual).substr(0, std::string(usual).find('='))))
        all.emplace_back(usual);
    all.insert(all.end(), settings.begin(), settings.end());
    const Scene<2> scene = make_described_scene<2>(parse_parameters("", "scenes.prm", all));
    checks.that(name, find_contradiction(scene).empty() != contradicts);
  }
  // A foundation that names no side, and no gap: those of the pair follow from its sides.
  const Scene<2> scene = make_described_scene<2>(parse_parameters(
    "", "scenes.prm",
    {"Geometry/Bodies=low up", "Geometry/Lower left=low: 0, 0 | up: 0, 1.25",
     "Geometry/Upper right=low: 1, 1 | up: 1, 2", "Boundary/Displacement=up.top: 0; -0.01",
     "Boundary/Contact=up.bottom with low.top | low.bottom",
     "Contact/Foundation=plane 0,-0.5 normal 0,1"}));
  const auto gap = [&scene](const char *side, const Point &x) {
    return contact_of(scene, side).gap->value(x);
  };
  checks.near("gaps of a pair and of a foundation",
              {gap("up.bottom", Point(0.3, 1.25)), gap("low.bottom", Point(0.3, 0.))}, {0.25, 0.5},
              1e-15);
}
} // namespace

int main() {
  return run_tests({test_bodies, test_pairs_of_sides, test_scene, test_layers, test_agreement,
                    test_pairs_of_bodies});
}
