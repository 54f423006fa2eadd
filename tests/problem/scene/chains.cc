// SPDX-License-Identifier: LGPL-2.1-or-later
// Chains of segments and arcs: arc lengths, normals, corners, crossings. outlines.cc has areas.

#include <signorini/problem/scene/corners.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

#include "tests.h"

using namespace Signorini;
using dealii::numbers::PI;

namespace {
using Point = dealii::Point<2>;
using Vector = dealii::Tensor<1, 2>;

std::vector<Curve> segments(const std::vector<Point> &points) {
  std::vector<Curve> pieces;
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
    pieces.emplace_back(points[i], points[i + 1]);
  return pieces;
}

Curve polyline(const std::vector<Point> &points) {
  return Curve::chain(segments(points));
}

/** An L, three by three with legs of the width one, whose re-entrant corner is rounded. */
constexpr double fillet = 0.5;
Curve rounded_l() {
  std::vector<Curve> pieces = segments({{0., 0.}, {3., 0.}, {3., 1.}, {1.5, 1.}});
  pieces.push_back(Curve::arc(Point(1.5, 1.5), fillet, -0.5 * PI, -PI, Body::outside));
  for (const Curve &piece : segments({{1., 1.5}, {1., 3.}, {0., 3.}, {0., 0.}}))
    pieces.push_back(piece);
  return Curve::chain(pieces);
}

Geometry<2> body(const std::vector<Side<2>> &sides) {
  Geometry<2> geometry;
  geometry.sides = sides;
  geometry.upper = Point(3., 3.);
  return geometry;
}

void test_rounded_l(Checks &checks) {
  checks.about("L");
  const Curve loop = rounded_l();
  checks.near("length", loop.length(), 11. + 0.5 * PI * fillet, 1e-14);
  for (double s = 0.1; s < loop.length(); s += 0.37) {
    checks.near("arc length of a point", loop.arc_length(loop.point(s)), s, 1e-13);
    checks.near("one turn later", loop.point(s + loop.length()), loop.point(s), 1e-13);
    checks.near("tangent and normal", loop.normal(s) * loop.tangent(s, s), 0., 1e-14);
  }
  checks.near("corners of the chain", loop.corners().size(), 5, 0);
  for (const double s : {0., 3., 4., loop.length()})
    checks.that("a corner", loop.has_corner(s));
  for (const double s : {1., 5.5, 5.5 + 0.5 * PI * fillet})
    checks.that("smooth", !loop.has_corner(s));
  checks.near("normal before a corner", loop.normal(3., 0.), Point(0., -1.), 0.);
  checks.near("normal behind a corner", loop.normal(3., 4.), Point(1., 0.), 0.);
  checks.near("normal before the start", loop.normal(0., -1.), Point(-1., 0.), 1e-15);
  checks.near("normal of a piece at its end", loop.normal_at(Point(3., 0.), Point(3., 0.4)),
              Point(1., 0.), 0.);
  const double half = std::sqrt(0.5);
  checks.near("the fillet is concave", loop.normal(5.5 + 0.25 * PI * fillet), Point(half, half),
              1e-14);
  const auto around =
    loop.crossings(Vector({1., 0.}), 2., 0.5 * loop.length(), 1.5 * loop.length());
  checks.near("a line around the start", around, {loop.length() + 2., loop.length() + 5.}, 1e-13);
  std::vector<double> angles;
  for (const Corner &corner : corners(body({{"all", loop}})))
    angles.push_back(corner.angle);
  checks.near("right angles", angles, std::vector<double>(5, 0.5 * PI), 1e-14);
}

/** The sides of an L, whose second one is walked from either end. */
void test_corners(Checks &checks) {
  std::vector<Point> points = {{3., 0.}, {3., 1.}, {1., 1.}, {1., 3.}, {0., 3.}, {0., 0.}};
  std::vector<Curve> backwards;
  for (std::size_t i = points.size() - 1; i > 0; --i) {
    const Curve forward(points[i - 1], points[i]);
    backwards.emplace_back(points[i], points[i - 1], forward.normal(0.));
  }
  checks.near("walked the other way: arc length", Curve::chain(backwards).arc_length(Point(1., 2.)),
              5., 1e-14);
  for (const Curve &around : {polyline(points), Curve::chain(backwards)}) {
    double sum = 0.;
    for (const Corner &corner :
         corners(body({{"bottom", Curve(Point(0., 0.), Point(3., 0.))}, {"free", around}}))) {
      sum += corner.angle;
      if (corner.position.distance(Point(1., 1.)) < 1e-14)
        checks.that("the re-entrant one is inside of a side",
                    corner.sides[0] == 1 && corner.sides[1] == 1 &&
                      std::abs(corner.angle - 1.5 * PI) < 1e-14);
    }
    checks.near("two sides: sum of angles", sum, 4. * PI, 1e-13);
  }
  checks.that("segments on one line are one segment",
              polyline({{0., 0.}, {1., 2.}, {2., 4.}, {5., 10.}}).is_flat());
}

void test_open_chain(Checks &checks) {
  checks.about("cup");
  const Curve cup = polyline({{0., 1.}, {0., 0.}, {2., 0.}, {2., 1.}});
  checks.that("open", !cup.is_closed() && cup.corners() == std::vector<double>({1., 3.}));
  for (const auto &[s, x] : {std::pair(-0.5, Point(0., 1.5)), std::pair(4.25, Point(2., 1.25))}) {
    checks.near("arc length beyond the ends", cup.arc_length(x), s, 1e-15);
    checks.near("points beyond the ends", cup.point(s), x, 1e-15);
  }
  checks.near("a line meets it twice", cup.crossings(Vector({0., 1.}), 0.25, 0., 4.), {0.75, 3.25},
              1e-15);
  const double half = std::sqrt(0.5);
  checks.near("a line through a corner meets it once",
              cup.crossings(Vector({half, half}), 0., 0.5, 1.5).size(), 1, 0);
}

} // namespace

int main() {
  return run_tests({test_rounded_l, test_corners, test_open_chain});
}
