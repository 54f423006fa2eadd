// SPDX-License-Identifier: LGPL-2.1-or-later
// Polygons with arcs, fillets and holes, discs and rings: areas, lengths, and cells that are never
// folded.

#include <signorini/problem/geometry/shapes.h>
#include <signorini/problem/input/make_scene.h>
#include <signorini/problem/parameters/parameters.h>
#include <signorini/problem/scene/corners.h>

#include <deal.II/base/numbers.h>
#include <deal.II/grid/grid_tools.h>

#include <cmath>

#include "problem/measures.h"
#include "tests.h"

using namespace Signorini;
using dealii::numbers::PI;

namespace {
using Point = dealii::Point<2>;

/** The body of a parameter file; the contact side is any, and so is the one that holds the body. */
Geometry<2> body(const std::string &entries, const std::string &contact = "side0",
                 const std::string &clamped = "side1") {
  return make_scene<2>(
           parse_parameters("subsection Geometry\n" + entries + "\nend\n", "test",
                            {"Boundary/Contact=" + contact, "Boundary/Clamped=" + clamped}))
    .geometry;
}

Geometry<2> polygon(const std::string &vertices, const std::string &holes = "") {
  return body("set Shape = polygon\nset Vertices = " + vertices + "\nset Holes = " + holes);
}

/** Area and lengths by the mapped mesh and by the sides; int n ds = 0; positive Jacobians at all
 * levels; boundary faces on their sides. */
void check_body(Checks &checks, const std::string &name, const Geometry<2> &geometry,
                const double area, const std::map<std::string, double> &lengths) {
  checks.about(name);
  dealii::Triangulation<2> mesh;
  geometry.make_coarse_mesh(mesh);
  for (unsigned int level = 0; level < 4; ++level) {
    if (level > 0)
      mesh.refine_global(1);
    checks.that("cells are not folded", measure(geometry, mesh, 2).shape > 0.05);
  }
  const double size = geometry.diameter();
  Measures found = measure(geometry, mesh, 5);
  checks.near("area", found.area, area, 1e-8 * area);
  checks.near("faces are on their sides", found.off, 0., 1e-8 * size);
  checks.near("with their normals", found.turned, 0., 1e-5);
  checks.near("the normal has the mean zero", found.normals.norm(), 0., 1e-10 * size);
  for (const auto &[side, length] : lengths) {
    checks.near("length of " + side, geometry.sides.at(geometry.find_side(side)).length(), length,
                1e-12 * size);
    checks.near("faces of " + side, found.lengths[side], length, 1e-8 * size);
  }
  checks.that("the point inside", [&] {
    for (const auto &cell : mesh.active_cell_iterators())
      if (cell->point_inside(geometry.inner_point()))
        return true;
    return false;
  }());
}

/** The area between a chord of the length 2 and the shorter arc of a circle. */
double segment_area(const double radius) {
  const double half = std::asin(1. / radius);
  return radius * radius * (half - 0.5 * std::sin(2. * half));
}

void test_straight(Checks &checks) {
  const std::string l = "0,0; 2,0; 2,1; 1,1; 1,2; 0,2";
  const Geometry<2> geometry = polygon(l);
  check_body(checks, "L", geometry, 3., {{"side0", 2.}, {"side2", 1.}, {"side5", 2.}});
  checks.that("straight, box",
              !geometry.curved && geometry.lower == Point() && geometry.upper == Point(2., 2.));
  check_body(checks, "L, clockwise", polygon("0,2; 1,2; 1,1; 2,1; 2,0; 0,0"), 3.,
             {{"side0", 1.}, {"side4", 2.}, {"side5", 2.}});
  check_body(checks, "divided side", polygon("0,0; 1,0; 3,0; 3,1; 0,1"), 3., {{"side1", 2.}});
  const Geometry<2> fine = polygon(l, "\nset Mesh size = 0.25");
  check_body(checks, "L, fine", fine, 3., {{"side0", 2.}});
  checks.that("Mesh size", fine.n_coarse_cells > 3. * 3. * 16.);
}

void test_curved(Checks &checks) {
  check_body(checks, "L with a fillet", polygon("0,0; 3,0; 3,1; 1,1 fillet 0.5; 1,3; 0,3"),
             5. + 0.25 * (1. - 0.25 * PI),
             {{"side2", 1.5}, {"fillet3", 0.25 * PI}, {"side3", 1.5}});
  check_body(checks, "round corners",
             polygon("0,0 fillet 0.2; 1,0 fillet 0.01; 1,1 fillet 0.4; 0,1"),
             1. - (0.04 + 1e-4 + 0.16) * (1. - 0.25 * PI),
             {{"fillet0", 0.1 * PI}, {"side0", 0.79}, {"fillet1", 0.005 * PI}});
  for (const char *half_disc : {"-1,0; arc 0,0 ccw; 1,0", "1,0; arc 0,0 cw; -1,0"})
    check_body(checks, half_disc, polygon(half_disc), 0.5 * PI, {{"side0", PI}, {"side1", 2.}});
  const double a = 2. * std::atan(0.25), segment = segment_area(std::sqrt(17.));
  for (const char *flat : {"-1,0; arc 0,4 ccw; 1,0", "-1,0; arc radius 4.123105625617661 ccw; 1,0",
                           "1,0; arc through 0,-0.12310562561766053; -1,0"})
    check_body(checks, flat, polygon(flat), segment,
               {{"side0", std::sqrt(17.) * a}, {"side1", 2.}});
  check_body(checks, "lens", polygon("-1,0; arc 0,4 ccw; 1,0; arc 0,-4 ccw"), 2. * segment,
             {{"side0", std::sqrt(17.) * a}, {"side1", std::sqrt(17.) * a}});
  check_body(checks, "lens as a hole",
             polygon("-2,-1; 2,-1; 2,1; -2,1", "-1,0; arc 0,4 ccw; 1,0; arc 0,-4 ccw"),
             8. - 2. * segment, {{"hole0", 2. * std::sqrt(17.) * a}});
  check_body(checks, "moon of few degrees", polygon("-1,0; arc radius 4 ccw; 1,0; arc radius 6 cw"),
             segment_area(4.) - segment_area(6.), {{"side1", 12. * std::asin(1. / 6.)}});
  dealii::Triangulation<2> thin;
  polygon("-1,0; arc radius 57 ccw; 1,0").make_coarse_mesh(thin);
  checks.near("segment of two degrees: area",
              dealii::GridTools::volume(thin, dealii::MappingQ<2>(4)), segment_area(57.), 1e-10);
  // The longer arc, through a third point, of a vertical chord.
  check_body(checks, "arc of 270 degrees", polygon("0,-1; arc through 2.414213562373095,0; 0,1"),
             1.5 * PI + 1., {{"side0", 1.5 * PI * std::sqrt(2.)}, {"side1", 2.}});
  check_body(checks, "moon", polygon("0,-1; arc 0,0 ccw; 0,1; arc -1,0 cw"), 1.,
             {{"side0", PI}, {"side1", std::sqrt(0.5) * PI}});
}

void test_holes(Checks &checks) {
  const Geometry<2> plate = polygon("-2,-1; 2,-1; 2,1; -2,1", "circle 0,0,0.5");
  check_body(checks, "plate", plate, 8. - 0.25 * PI, {{"hole0", PI}, {"side0", 4.}});
  checks.that("the hole is one closed side", plate.sides[4].is_closed());
  check_body(checks, "thin plate", polygon("-1,-0.55; 1,-0.55; 1,0.55; -1,0.55", "circle 0,0,0.5"),
             2.2 - 0.25 * PI, {{"hole0", PI}});
  check_body(checks, "three holes",
             polygon("0,0; 6,0; 6,2; 0,2",
                     "circle 1,1,0.3 | 2.5,0.5; 3.5,0.5; 3.5,1.5; 2.5,1.5 fillet 0.25 | "
                     "4.5,1; arc 5,1 cw; 5.5,1; arc 5,1 cw"),
             11. - 0.34 * PI + 0.0625 * (1. - 0.25 * PI),
             {{"hole0", 0.6 * PI}, {"hole1", 3.5 + 0.125 * PI}, {"hole2", PI}});
  // Cells beside the gaps of 1e-6 are much longer than wide.
  dealii::Triangulation<2> gaps;
  polygon("0,0; 1,0; 1,1; 0,1", "circle 0.5,0.5,0.499999").make_coarse_mesh(gaps);
  checks.near("four narrow gaps: area", dealii::GridTools::volume(gaps, dealii::MappingQ<2>(2)),
              1. - PI * std::pow(0.499999, 2), 1e-4);
}

void test_round(Checks &checks) {
  const Geometry<2> disc = make_disc(0.5, Point(1., -2.));
  check_body(checks, "disc", disc, 0.25 * PI, {{"arc", PI}});
  checks.that("closed, without corners", disc.sides[0].is_closed() && corners(disc).empty());
  check_body(checks, "half disc",
             body("set Shape = half disc\nset Centre = 1,2\nset Radius = 2", "arc", "flat"),
             2. * PI, {{"arc", 2. * PI}, {"flat", 4.}});
  check_body(checks, "ring",
             body("set Shape = ring\nset Centre = -1,0.5\nset Radius = 2\nset Inner radius = 1",
                  "outer", "inner"),
             3. * PI, {{"outer", 4. * PI}, {"inner", 2. * PI}});
}
} // namespace

int main() {
  return run_tests({test_straight, test_curved, test_holes, test_round});
}
