// SPDX-License-Identifier: LGPL-2.1-or-later
// Bounds of formulas in boxes: no value lies outside, none hides between samples, and conditions
// with affine arguments give their lines.

#include <signorini/problem/formulas/expression.h>

#include <cmath>

#include "../../random_numbers.h"
#include "../../tests.h"

using namespace Signorini;

namespace {
using Point = dealii::Point<2>;

FormulaTree<2> tree(const std::string &text) {
  return FormulaTree<2>(text, {{"a", 0.3}});
}

const std::vector<std::string> formulas = {"0.1 + 0.3*x - 0.2*y",
                                           "x^2 - 3*x*y + y^3",
                                           "sin(pi*y)*cos(3*x)",
                                           "exp(3*x)*(1 + 0.1*y)",
                                           "sqrt(abs(x - a)) + x^2.5",
                                           "1/(1.1 - x)",
                                           "x < a ? y^2 : -1",
                                           "max(x, y, 0.7) - min(x, 2*y)",
                                           "abs(abs(x - 0.5) - 0.2)",
                                           "floor(5*x) + ceil(3*y) + rint(x)",
                                           "sign(x - y)*x",
                                           "log(1 + x)^3",
                                           "atan2(y - 0.5, x - 0.5)",
                                           "atan2(abs(y - 0.5), x - 0.5)",
                                           "atan2(0.5 - x, 0)",
                                           "atan2(0, x - y)",
                                           "atan2(x - 0.5, (y - 0.5)*(x - a))",
                                           "tan(x) + asin(x) - acos(y)",
                                           "erf(5*x) - erfc(y) + tanh(3*y)",
                                           "cos(40*x) < 0 ? 1 : y",
                                           "(x < a || y > 0.5) && x + y < 1.2 ? 3 : x",
                                           "(x - a)^4/(0.1 + y)",
                                           "sinh(x) + cosh(x - y)",
                                           "(x == 0.5) + (floor(3*x) == 1)",
                                           "2^x^2 - pow(x + 0.1, -1.5)",
                                           "max(x - 0.5, 0) > 0 ? 7 : 1",
                                           "floor(2*x) > 0 ? 7 : y",
                                           "max(x - 0.5, 0) <= 0 ? 7 : 1",
                                           "x^2 == x*x ? 7 : 1",
                                           "floor(max(2*x, 1))",
                                           "max(x - 0.5, 0)^1.5 + sqrt(max(0, y - x))"};

/** Values at random points of random boxes lie within the bounds. */
void test_bounds(Checks &checks) {
  RandomNumbers numbers(7);
  const auto random_number = [&numbers] { return 0.5 + 0.5 * numbers(); };
  for (const std::string &text : formulas) {
    const FormulaTree<2> formula = tree(text);
    bool inside = true;
    for (unsigned int i = 0; i < 200; ++i) {
      const Point corner(random_number(), random_number());
      const double size = std::pow(0.1, 1 + i % 4);
      const FormulaBox<2> box = {corner, corner + dealii::Tensor<1, 2>({size, 0.5 * size})};
      const Enclosure<2> bounds = formula.enclose(box);
      for (unsigned int k = 0; k < 20; ++k) {
        const double value = formula.value(
          corner + dealii::Tensor<1, 2>({size * random_number(), 0.5 * size * random_number()}));
        const double rounding = 1e-12 * (1. + std::abs(value));
        inside = inside && (!std::isfinite(value) ||
                            (value > bounds.lower - rounding && value < bounds.upper + rounding));
      }
    }
    checks.that("bounds of " + text, inside);
  }
}

/** Values on lines have no area: they are no bounds, not even at the centre of a box, nor the value
 * that bounds by derivatives begin with. */
void test_values_on_lines(Checks &checks) {
  const FormulaBox<2> box = {Point(0., 0.), Point(1., 1.)};
  for (const char *text : {"x == 0.5 ? 7 : 1", "1 + 6*(x == 0.5 && y > 2)", "x != y || x < 0",
                           "2 - abs(sign(x + 1))"}) {
    const Enclosure<2> bounds = tree(text).enclose(box);
    checks.near("lower bound of " + std::string(text), bounds.lower, 1., 0.);
    checks.near("upper bound of " + std::string(text), bounds.upper, 1., 0.);
  }
  const Enclosure<2> bounds = tree("x == 0.5 ? 0.9 : x").enclose(box);
  checks.near("lower bound beside a line", bounds.lower, 0., 1e-8);
  checks.near("upper bound beside a line", bounds.upper, 1., 1e-8);
}

/** Bounds by derivatives are of second order: a box of the size h adds h² only. */
void test_order(Checks &checks) {
  const FormulaTree<2> formula = tree("x*(1 - x)*y*(1 - y)");
  const auto excess = [&](const double h) {
    return formula.enclose({Point(0.2, 0.3), Point(0.2 + h, 0.3 + h)}).width() -
           (formula.value(Point(0.2 + h, 0.3 + h)) - formula.value(Point(0.2, 0.3)));
  };
  checks.between("order of the excess", std::log2(excess(0.02) / excess(0.01)), 1.8, 2.2);
}

void test_derivatives(Checks &checks) {
  const Point x(0.37, 0.61);
  const auto near = [&](const std::string &text, const double in_x, const double in_y) {
    const auto gradient = tree(text).gradient(x);
    checks.near("in x: " + text, gradient[0], in_x, 1e-13);
    checks.near("in y: " + text, gradient[1], in_y, 1e-13);
  };
  near("x^3*y + sin(2*y)", 3. * 0.37 * 0.37 * 0.61, std::pow(0.37, 3) + 2. * std::cos(1.22));
  near("exp(x)/y", std::exp(0.37) / 0.61, -std::exp(0.37) / (0.61 * 0.61));
  near("x < a ? 1 : log(x)", 1. / 0.37, 0.);
  near("abs(x - y) + max(x, y)", -1., 2.);
  near("atan(x) + asin(y)", 1. / (1. + 0.37 * 0.37), 1. / std::sqrt(1. - 0.61 * 0.61));
  near("sqrt(max(x - 0.5, 0)) + (x < y)", 0., 0.);
  near("x^y", 0.61 * std::pow(0.37, -0.39), std::pow(0.37, 0.61) * std::log(0.37));
  near("erf(x) - erfc(y)", 2. / std::sqrt(std::acos(-1.)) * std::exp(-0.37 * 0.37),
       2. / std::sqrt(std::acos(-1.)) * std::exp(-0.61 * 0.61));
}

/** Bands and peaks between samples are not shown; smooth formulas and known lines are. */
void test_samples(Checks &checks) {
  const FormulaBox<2> square = {Point(0., 0.), Point(1., 1.)},
                      part = {Point(0.25, 0.25), Point(0.5, 0.5)};
  for (const char *text :
       {"abs(y - 0.3) < 0.006 ? -4 : 0", "exp(-((x - 0.317)/3e-5)^2)", "x < a && y < a ? 1 : 0",
        "cos(400*pi*x) < 0 ? 1 : 0", "(x - 0.3)^2 + y^2 < 1e-3 ? 1 : 0"})
    checks.that("hides: " + std::string(text), !tree(text).is_shown(square, {}, 1e-3));
  for (const char *text :
       {"0.1 + x - y", "x^2", "sin(pi*y)*cos(3*x)", "(1 + x^2)*(2 + y)", "atan2(y, x - a)"})
    checks.that("shown: " + std::string(text), tree(text).is_shown(part, {}, 1e-3));

  bool all = false;
  const FormulaTree<2> jump = tree("x + 2*y < 1.5*a ? 1 : 0");
  const std::vector<KinkLine<2>> lines = jump.lines_in(square, all);
  checks.that("one affine line", all && lines.size() == 1);
  const double root = std::sqrt(5.);
  checks.near("its distance from a point", std::abs(lines.at(0).signed_distance(Point(1., 1.))),
              (3. - 0.45) / root, 1e-13);
  checks.that("unknown line", !jump.is_shown(square, {}, 1e-3));
  checks.that("known line", jump.is_shown(square, lines, 1e-3));
  const FormulaTree<2> band = tree("abs(abs(y - 0.5) - 0.25) <= 0.1*a ? 1 : 0");
  const FormulaBox<2> half = {Point(0., 0.), Point(1., 0.24)};
  checks.near("line of a nested condition", band.lines_in(half, all).size(), 1., 0.);
  checks.that("shown with it", all && band.is_shown(half, band.lines_in(half, all), 1e-3));
  const FormulaTree<2> peak = tree("floor(x + 0.5) + exp(-((y - 0.317)/3e-5)^2)");
  checks.that("steps hide no peak", !peak.is_shown(square, peak.lines_in(square, all), 1e-3));
  checks.near("two steps on one line",
              tree("sign(x - a) + floor(x - a)").lines_in(part, all).size(), 1., 0.);
  checks.near("the line on which an angle jumps",
              tree("atan2(y - 0.4, x - 0.9)").lines_in(part, all).size(), 1., 0.);
  checks.that("explains it", all);
  checks.that("an angle that does not jump has no line",
              tree("atan2(y, x - 0.4)").lines_in(square, all).empty());
  checks.that("and needs none", all);
  checks.near("an angle on the axis", tree("atan2(0, x - 0.4)").lines_in(square, all).size(), 1.,
              0.);
  checks.near("the lines of a band", tree("abs(x - a) < 0.01 ? 1 : 0").lines_in(square, all).size(),
              3., 0.);
  checks.that("a circle is no line", tree("x^2 + y^2 < 1 ? 1 : 0").lines_in(square, all).empty());
  checks.that("and is reported", !all);
  checks.near("a decided condition has no line",
              tree("x < 2 ? y : abs(y - 0.5)").lines_in(square, all).size(), 0., 0.);
  const Enclosure<2> comb = tree("cos(400*pi*x) < 0 ? 1 : 0").enclose(square);
  checks.that("depends on x alone", comb.varies[0] && !comb.varies[1]);
}
} // namespace

int main() {
  return run_tests({test_bounds, test_values_on_lines, test_order, test_derivatives, test_samples});
}
