// SPDX-License-Identifier: LGPL-2.1-or-later
// Chains of segments and arcs: arc lengths, normals, corners, crossings, and faces on them.

#include <signorini/problem/scene/corners.h>
#include <signorini/problem/scene/rigid_motions.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>

#include "tests.h"

using namespace Signorini;
using dealii::numbers::PI;

namespace
{
using Point = dealii::Point<2>;
using Vector = dealii::Tensor<1, 2>;

Curve segment(const Point &start, const Point &end)
{
  return {start, end};
}

Curve polyline(const std::vector<Point> &points)
{
  std::vector<Curve> pieces;
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
    pieces.push_back(segment(points[i], points[i + 1]));
  return Curve::chain(pieces);
}

/** An L, three by three with legs of the width one, whose re-entrant corner is rounded. */
constexpr double fillet = 0.5;
Curve rounded_l()
{
  return Curve::chain({segment(Point(0., 0.), Point(3., 0.)),
                       segment(Point(3., 0.), Point(3., 1.)),
                       segment(Point(3., 1.), Point(1.5, 1.)),
                       Curve::arc(Point(1.5, 1.5), fillet, -0.5 * PI, -PI, Body::outside),
                       segment(Point(1., 1.5), Point(1., 3.)),
                       segment(Point(1., 3.), Point(0., 3.)),
                       segment(Point(0., 3.), Point(0., 0.))});
}

Geometry<2> body(const std::vector<Side<2>> &sides)
{
  Geometry<2> geometry;
  geometry.sides = sides;
  geometry.upper = Point(3., 3.);
  return geometry;
}

/** int n ds and 1/2 int x.n ds, the area, with points inside of the pieces. */
void check_theorems(Checks &checks, const std::string &name, const Curve &loop, const double area)
{
  const dealii::QGauss<1> gauss(20);
  Vector closed;
  double found = 0., distance = 0., s_error = 0., right_angle = 0.;
  for (unsigned int k = 0; k < loop.n_pieces(); ++k)
  {
    const double length = loop.start_of(k + 1) - loop.start_of(k);
    for (unsigned int q = 0; q < gauss.size(); ++q)
    {
      const double s = loop.start_of(k) + gauss.point(q)[0] * length;
      const Vector n = loop.normal(s);
      const Point x = loop.point(s);
      closed += gauss.weight(q) * length * n;
      found += 0.5 * gauss.weight(q) * length * (x * n);
      s_error = std::max(s_error, std::abs(loop.arc_length(x) - s));
      distance = std::max(distance, loop.point(s + loop.length()).distance(x));
      right_angle = std::max(right_angle, std::abs(n * loop.tangent(s, s)));
    }
  }
  checks.near(name + ": the normal has the mean zero", closed.norm(), 0., 1e-12 * loop.length());
  checks.near(name + ": area", found, area, 1e-12 * area);
  checks.near(name + ": arc length of a point", s_error, 0., 1e-12 * loop.length());
  checks.near(name + ": one turn later", distance, 0., 1e-12 * loop.length());
  checks.near(name + ": tangent and normal", right_angle, 0., 1e-14);
}

void test_rounded_l(Checks &checks)
{
  const Curve loop = rounded_l();
  checks.that("L: closed, not flat", loop.is_closed() && !loop.is_flat());
  checks.near("L: pieces", loop.n_pieces(), 7, 0);
  checks.near("L: length", loop.length(), 11. + 0.5 * PI * fillet, 1e-14);
  check_theorems(checks, "L", loop, 5. + fillet * fillet * (1. - 0.25 * PI));
  checks.near("L: corners of the chain", loop.corners().size(), 5, 0);
  checks.that("L: where they are",
              loop.has_corner(0.) && loop.has_corner(loop.length()) && loop.has_corner(3.) &&
                loop.has_corner(4.) && !loop.has_corner(5.5) &&
                !loop.has_corner(5.5 + 0.5 * PI * fillet) && !loop.has_corner(1.));
  checks.near("L: normal before a corner", (loop.normal(3., 0.) - Vector({0., -1.})).norm(), 0., 0);
  checks.near("L: normal behind a corner", (loop.normal(3., 4.) - Vector({1., 0.})).norm(), 0., 0);
  checks.near(
    "L: normal before the start", (loop.normal(0., -1.) - Vector({-1., 0.})).norm(), 0., 1e-15);
  checks.near("L: normal of a piece at its end",
              (loop.normal_at(Point(3., 0.), Point(3., 0.4)) - Vector({1., 0.})).norm(),
              0.,
              0);
  const Vector diagonal({std::sqrt(0.5), std::sqrt(0.5)});
  checks.near("L: the fillet is concave",
              (loop.normal(5.5 + 0.25 * PI * fillet) - diagonal).norm(),
              0.,
              1e-14);
  const auto found = corners(body({{"all", loop}}));
  checks.near("L: corners of the body", found.size(), 5, 0);
  double off = 0.;
  for (const Corner &corner : found)
    off = std::max(off, std::abs(corner.angle - 0.5 * PI));
  checks.near("L: right angles", off, 0., 1e-14);
}

void test_corners(Checks &checks)
{
  const Curve sharp = polyline(
    {Point(3., 0.), Point(3., 1.), Point(1., 1.), Point(1., 3.), Point(0., 3.), Point(0., 0.)});
  const auto found =
    corners(body({{"bottom", segment(Point(0., 0.), Point(3., 0.))}, {"free", sharp}}));
  checks.near("two sides: corners", found.size(), 6, 0);
  double sum = 0.;
  for (const Corner &corner : found)
  {
    sum += corner.angle;
    if (corner.position.distance(Point(1., 1.)) < 1e-14)
      checks.that("two sides: the re-entrant one is inside of a side",
                  corner.sides[0] == 1 && corner.sides[1] == 1 &&
                    std::abs(corner.angle - 1.5 * PI) < 1e-14);
  }
  checks.near("two sides: sum of angles", sum, 4. * PI, 1e-13);
  // The same side walked the other way.
  const Curve backwards = Curve::chain({Curve(Point(0., 0.), Point(0., 3.), Point(-1., 0.)),
                                        Curve(Point(0., 3.), Point(1., 3.), Point(0., 1.)),
                                        Curve(Point(1., 3.), Point(1., 1.), Point(1., 0.)),
                                        Curve(Point(1., 1.), Point(3., 1.), Point(0., 1.)),
                                        Curve(Point(3., 1.), Point(3., 0.), Point(1., 0.))});
  sum = 0.;
  for (const Corner &corner :
       corners(body({{"bottom", segment(Point(0., 0.), Point(3., 0.))}, {"free", backwards}})))
    sum += corner.angle;
  checks.near("walked the other way: sum of angles", sum, 4. * PI, 1e-13);
  checks.near("walked the other way: arc length", backwards.arc_length(Point(1., 2.)), 5., 1e-14);
  checks.that("segments on one line are one segment",
              polyline({Point(0., 0.), Point(1., 2.), Point(2., 4.), Point(5., 10.)}).is_flat());
}

void test_open_chain(Checks &checks)
{
  const Curve cup = polyline({Point(0., 1.), Point(0., 0.), Point(2., 0.), Point(2., 1.)});
  checks.that("cup: open", !cup.is_closed() && cup.corners() == std::vector<double>({1., 3.}));
  checks.near("cup: before its start", cup.arc_length(Point(0., 1.5)), -0.5, 1e-15);
  checks.near("cup: beyond its end", cup.arc_length(Point(2., 1.25)), 4.25, 1e-15);
  checks.near("cup: a point beyond", cup.point(4.25).distance(Point(2., 1.25)), 0., 1e-15);
  checks.near("cup: a point before", cup.point(-0.5).distance(Point(0., 1.5)), 0., 1e-15);
  const auto at_height = cup.crossings(Vector({0., 1.}), 0.25, 0., 4.);
  checks.that("cup: a line meets it twice",
              at_height.size() == 2 && std::abs(at_height[0] - 0.75) < 1e-15 &&
                std::abs(at_height[1] - 3.25) < 1e-15);
  const double r = std::sqrt(0.5);
  checks.near("cup: a line through a corner meets it once",
              cup.crossings(Vector({r, r}), 0., 0.5, 1.5).size(),
              1,
              0);
  const Curve loop = rounded_l();
  const auto around =
    loop.crossings(Vector({1., 0.}), 2., 0.5 * loop.length(), 1.5 * loop.length());
  checks.that("L: a line around the start",
              around.size() == 2 && std::abs(around[0] - loop.length() - 2.) < 1e-13);
}

/** A polygon of many sides stands for a circle. */
void test_many_pieces(Checks &checks)
{
  constexpr unsigned int n = 4000;
  constexpr double radius = 2.;
  std::vector<Point> points;
  for (unsigned int i = 0; i <= n; ++i)
    points.push_back(
      i == n ? points[0]
             : Point(radius * std::cos(2. * PI * i / n), radius * std::sin(2. * PI * i / n)));
  const Curve circle = polyline(points);
  checks.that("polygon: closed, without corners", circle.is_closed() && circle.corners().empty());
  checks.near("polygon: length", circle.length(), 2. * n * radius * std::sin(PI / n), 1e-11);
  check_theorems(checks, "polygon", circle, 0.5 * n * radius * radius * std::sin(2. * PI / n));
  checks.near(
    "polygon: two pieces meet in a point", circle.pieces_near(points[17], 1e-9).size(), 2, 0);
  checks.near("polygon: the whole circle is near its centre",
              circle.pieces_near(Point(0., 0.), radius).size(),
              n,
              0);
}

void test_rigid_motions(Checks &checks)
{
  Scene<2> scene;
  scene.boundary.resize(1);
  scene.boundary[0].role = Role::roller;
  const double half = std::sqrt(0.5);
  scene.geometry = body({{"all", rounded_l()}});
  checks.near("rollers around an L", free_rigid_motions(scene).size(), 0, 0);
  scene.geometry = body({{"arc",
                          Curve::chain({Curve::arc(Point(1., 1.), 0.5, 0., 1., Body::inside),
                                        Curve::arc(Point(1., 1.), 0.5, 1., 2.5, Body::inside)})}});
  const auto turns = free_rigid_motions(scene);
  checks.that("rollers on arcs about one point",
              turns.size() == 1 && turns[0].name() == "the rotation about (1, 1)");
  scene.geometry =
    body({{"wedge", polyline({Point(0., 1.), Point(half, 1. - half), Point(1., 1.)})}});
  checks.near("rollers in a wedge", free_rigid_motions(scene).size(), 0, 0);
}
} // namespace

int main()
{
  Checks checks;
  test_rounded_l(checks);
  test_corners(checks);
  test_open_chain(checks);
  test_many_pieces(checks);
  test_rigid_motions(checks);
  return checks.exit_code();
}
