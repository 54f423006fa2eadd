// SPDX-License-Identifier: LGPL-2.1-or-later
// Quadrature on the pieces into which lines cut cells and faces, against closed forms.

#include <signorini/discretization/mesh/cut_quadrature.h>
#include <signorini/problem/geometry/kinks.h>
#include <signorini/problem/geometry/shapes.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "random_numbers.h"
#include "tests.h"

using namespace Signorini;

namespace {
using Point = dealii::Point<2>;
using Cell = dealii::Triangulation<2>::active_cell_iterator;
using Integrand = std::function<double(const Point &)>;

std::vector<KinkLine<2>> lines(const std::vector<double> &at_x, const std::vector<double> &at_y) {
  return lines_at<2>({{at_x, at_y}});
}

using RuleOf = std::function<dealii::Quadrature<2>(const Cell &)>;

dealii::Triangulation<2> mesh_of(const Geometry<2> &geometry) {
  dealii::Triangulation<2> mesh;
  geometry.make_coarse_mesh(mesh);
  return mesh;
}

RuleOf cut(const Kinks<2> &kinks, const unsigned int n_points) {
  return [&kinks, n_points](const Cell &cell) { return cut_quadrature(kinks, cell, n_points); };
}

/** The integral over a mesh; rules are without negative weights. */
double integrate(const dealii::Triangulation<2> &mesh, const RuleOf &rule_of, const Integrand &f) {
  const dealii::FE_Q<2> fe(1);
  double sum = 0.;
  for (const Cell &cell : mesh.active_cell_iterators()) {
    const dealii::Quadrature<2> rule = rule_of(cell);
    dealii::FEValues<2> values(fe, rule,
                               dealii::update_quadrature_points | dealii::update_JxW_values);
    values.reinit(typename dealii::Triangulation<2>::cell_iterator(cell));
    for (const unsigned int q : values.quadrature_point_indices())
      sum += rule.weight(q) < 0. ? std::nan("") : f(values.quadrature_point(q)) * values.JxW(q);
  }
  return sum;
}

double positive_power(const double t, const unsigned int k) {
  return t > 0. ? std::pow(t, k) : 0.;
}

/** The corners (0,0), (3,0), (2,2), (0,1). */
void test_quadrilateral(Checks &checks) {
  const auto mesh =
    mesh_of(make_polygon({Point(0., 0.), Point(3., 0.), Point(2., 2.), Point(0., 1.)}));
  // In any order, twice and outside of the cell.
  const Kinks<2> kinks(lines({7., 1., -1., 1.}, {1., 0.}));
  for (unsigned int k = 1; k <= 4; ++k) {
    const double p = std::pow(2., k + 1);
    const auto of = [&](const unsigned int d) {
      return integrate(mesh, cut(kinks, 4),
                       [&](const Point &x) { return positive_power(x[d] - 1., k); });
    };
    checks.near("quadrilateral: max(x-1,0)^k", of(0),
                1.5 / (k + 1) + 0.5 / (k + 2) + 4. * (p - 1.) / (k + 1) -
                  2. * (2. * p - 1.) / (k + 2),
                1e-12);
    checks.near("quadrilateral: max(y-1,0)^k", of(1), 2.5 / (k + 1) - 2.5 / (k + 2), 1e-13);
  }
}

/** A distorted mesh of the unit square: crossed cells by pieces, the others by the plain rule. */
void test_mesh(Checks &checks) {
  auto mesh = mesh_of(make_rectangle(Point(0., 0.), Point(1., 1.), {7, 5}));
  dealii::GridTools::distort_random(0.25, mesh, true);
  const double xi = std::sqrt(0.5), eta = 0.4;
  const Kinks<2> kinks(lines({xi}, {eta}));
  const dealii::Quadrature<2> gauss = dealii::QGauss<2>(3);
  unsigned int crossed = 0;
  const auto of = [&](const RuleOf &rule_of) {
    const double exact = (1. - xi) * (1. - xi) / 2. * eta * eta * eta / 3.;
    return integrate(mesh, rule_of,
                     [&](const Point &x) {
                       return positive_power(x[0] - xi, 1) * positive_power(eta - x[1], 2);
                     }) /
           exact;
  };
  const double by_pieces = of([&](const Cell &cell) {
    const bool cross = needs_cuts<2>(kinks, cell);
    crossed += cross ? 1 : 0;
    return cross ? cut_quadrature(kinks, cell, 3) : gauss;
  });
  checks.near("mesh: integral on the pieces", by_pieces, 1., 1e-12);
  checks.that("mesh: the plain rule is not exact",
              std::abs(of([&](const Cell &) { return gauss; }) - 1.) > 1e-6);
  checks.between("mesh: crossed cells", crossed, 7 + 5 - 1, 2 * (7 + 5));
}

/** r, integrated over [0,a] x [0,c] and counted from the origin. */
double integral_of_distance(const double a, const double c) {
  return a * c * std::hypot(a, c) / 3. +
         (a * a * a * std::asinh(c / a) + c * c * c * std::asinh(a / c)) / 6.;
}

/** A line meets the contact side at (xi, 0): the rule gathers there. */
void test_ends(Checks &checks) {
  const double xi = 0.3;
  const Geometry<2> geometry = make_rectangle(Point(0., 0.), Point(1., 1.), {4, 4});
  const auto mesh = mesh_of(geometry);
  const Kinks<2> without_contact(lines({xi}, {}));
  Kinks<2> kinks(without_contact);
  kinks.add_ends_on(geometry.sides[2]);
  checks.that("ends: where the line meets the contact side",
              without_contact.ends().empty() && kinks.ends().size() == 1 &&
                kinks.ends()[0].distance(Point(xi, 0.)) < 1e-15);
  const auto r = [&](const Point &x) { return std::hypot(x[0] - xi, x[1]); };
  checks.near("ends: r",
              integrate(mesh, cut(kinks, 4), r) /
                (integral_of_distance(xi, 1.) + integral_of_distance(1. - xi, 1.)),
              1., 1e-8);
  const Cell near = mesh.begin_active(), far = mesh.last();
  checks.that("ends: cells beside a line are affected near contact only",
              needs_cuts<2>(kinks, near) && !needs_cuts<2>(kinks, far) &&
                !needs_cuts<2>(without_contact, near));
}

/** A comb: contact ends at few of its lines, and rules are graded to none. */
void test_comb(Checks &checks) {
  const Geometry<2> geometry = make_rectangle(Point(0., 0.), Point(1., 1.), {4, 4});
  std::vector<double> positions;
  for (unsigned int i = 0; i < 40; ++i)
    positions.push_back((i + 0.5) / 40.);
  Kinks<2> kinks(lines(positions, {}));
  kinks.add_ends_on(geometry.sides[2]);
  const auto mesh = mesh_of(geometry);
  checks.between("comb: points in a cell",
                 cut_quadrature(kinks, mesh.begin_active(), 4).size() / 11., 16., 36.);
}

/** The rules of all cells of a pentagon on the side from (0, 0) to (2, 0), where each line ends:
 * they hold the area 2.25 and the integrals of polynomials, for lines anywhere, through vertices,
 * almost so, and along edges. */
void test_many_ends(Checks &checks) {
  const Geometry<2> geometry =
    make_polygon({Point(0., 0.), Point(2., 0.), Point(2., 1.), Point(0.5, 1.25), Point(0., 1.)});
  auto mesh = mesh_of(geometry);
  mesh.refine_global(1);
  std::vector<double> positions;
  for (const Point &vertex : mesh.get_vertices())
    for (const double off : {0., 1e-15, 1e-12, 1e-7, 1e-4})
      positions.push_back(vertex[0] + off);
  RandomNumbers random(1);
  while (positions.size() < 200)
    positions.push_back(1. + random());
  const Integrand polynomial = [](const Point &x) {
    return std::pow(1. + x[0] - 2. * x[1], 4) + x[0] * x[1] * x[1];
  };
  const double exact = integrate(
    mesh, [](const Cell &) { return dealii::QGauss<2>(6); }, polynomial);
  std::size_t max_points = 0;
  for (const double position : positions) {
    Kinks<2> kinks(lines({position}, {0.3}));
    kinks.add_ends_on(geometry.sides[0]);
    const RuleOf rule_of = [&](const Cell &cell) {
      const dealii::Quadrature<2> rule = cut_quadrature(kinks, cell, 4);
      max_points = std::max<std::size_t>(max_points, rule.size());
      return rule;
    };
    checks.near("many ends: area", integrate(mesh, rule_of, [](const Point &) { return 1.; }), 2.25,
                3e-12);
    checks.near("many ends: polynomials", integrate(mesh, rule_of, polynomial) / exact, 1., 1e-12);
  }
  checks.between("many ends: points in a cell", static_cast<double>(max_points), 16., 1e5);
}

void test_segments(Checks &checks) {
  const Kinks<2> kinks(lines({0.5, 0.25}, {0.8}));
  struct Row {
    Point a, b;
    std::vector<double> expected;
  };
  for (const Row &row : std::vector<Row>{{{0., 0.}, {1., 0.}, {0., 0.25, 0.5, 1.}},
                                         {{1., 0.}, {0., 0.}, {0., 0.5, 0.75, 1.}},
                                         {{0.5, 0.}, {0.5, 2.}, {0., 0.4, 1.}},
                                         {{0., 0.}, {1., 1.}, {0., 0.25, 0.5, 0.8, 1.}},
                                         {{0.6, 0.}, {0.7, 0.}, {0., 1.}},
                                         {{0.25, 0.}, {0.5, 0.}, {0., 1.}}})
    checks.near("cut", kinks.cut(row.a, row.b), row.expected, 1e-15);
  const dealii::Quadrature<1> split = split_quadrature(dealii::QGauss<1>(2), {0., 0.3, 0.8, 1.});
  double sum = 0., weights = 0.;
  for (unsigned int q = 0; q < split.size(); ++q) {
    sum += split.weight(q) * positive_power(split.point(q)[0] - 0.3, 3);
    weights += split.weight(q);
  }
  checks.near("split rule: number of points", split.size(), 6, 0);
  checks.near("split rule: length", weights, 1., 1e-15);
  checks.near("split rule: max(t-c,0)^3", sum, std::pow(0.7, 4) / 4., 1e-15);
}
/** The same on sides, by arc length. */
void test_sides(Checks &checks) {
  const Kinks<2> kinks(lines({0.5, 0.25}, {0.8}));
  const Side<2> bottom("bottom", Curve(Point(-1., 0.), Point(1., 0.), Point(0., -1.)));
  checks.near("cut of a side", kinks.cut(bottom, 0., 2.), {0., 1.25, 1.5, 2.}, 1e-15);
  checks.near("cut of a part", kinks.cut(bottom, 1.3, 1.6), {1.3, 1.5, 1.6}, 1e-15);
  checks.near("ends are no cuts", kinks.cut(bottom, 1.25, 1.5), {1.25, 1.5}, 1e-15);
  const Side<2> column("column", Curve(Point(0.6, 0.), Point(0.6, 2.), Point(1., 0.)));
  checks.that("touch", kinks.touch(bottom, 1.25, 1.3) && kinks.touch(column, 0., 0.8) &&
                         !kinks.touch(bottom, 0., 2.));

  // On the circle of radius 2 about (1, 0) from the angle -pi the line y = 0.8 is met where
  // sin(angle) = 0.4, x = 0.5 and x = 0.25 where cos(angle) = -0.25 and -0.375.
  const double pi = dealii::numbers::PI;
  const Side<2> circle("circle", Curve::arc(Point(1., 0.), 2., -pi, pi, Body::inside));
  std::vector<double> expected = {0., 4. * pi};
  for (const double angle : {std::asin(0.4), pi - std::asin(0.4), std::acos(-0.25),
                             -std::acos(-0.25), std::acos(-0.375), -std::acos(-0.375)})
    expected.push_back(2. * (angle + pi));
  std::sort(expected.begin(), expected.end());
  checks.near("cut of a circle", kinks.cut(circle, 0., 4. * pi), expected, 1e-14);
  const double first = expected[1];
  checks.that("touch a circle", kinks.touch(circle, first, first + 0.1) &&
                                  kinks.touch(circle, 0., first) &&
                                  !kinks.touch(circle, 0., 4. * pi));
  checks.near("cut beyond the seam", kinks.cut(circle, 4. * pi, 4. * pi + first + 0.1),
              {4. * pi, 4. * pi + first, 4. * pi + first + 0.1}, 1e-14);

  // |y - 2 x| on the unit square.
  const auto mesh = mesh_of(make_rectangle(Point(0., 0.), Point(1., 1.), {1, 1}));
  const double length = std::sqrt(5.);
  const Kinks<2> slope({{dealii::Tensor<1, 2>({-2. / length, 1. / length}), 0.}});
  // Over x < 1/2 it is 1/6, over x > 1/2 it is 1/2.
  checks.near(
    "an oblique line",
    integrate(mesh, cut(slope, 3), [](const Point &x) { return std::abs(x[1] - 2. * x[0]); }),
    2. / 3., 1e-14);
}
} // namespace

int main() {
  return run_tests({test_quadrilateral, test_mesh, test_ends, test_comb, test_many_ends,
                    test_segments, test_sides});
}
