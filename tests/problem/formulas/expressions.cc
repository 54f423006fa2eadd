// SPDX-License-Identifier: LGPL-2.1-or-later
// Formulas of the parameter file: values, refusals, constants, copies, gradients.

#include <signorini/base/errors.h>
#include <signorini/problem/formulas/expression.h>
#include <signorini/problem/scene/functions.h>

#include <deal.II/base/numbers.h>

#include <cmath>
#include <memory>

#include "tests.h"

using namespace Signorini;

namespace {
using Point = dealii::Point<2>;

const Point x0(0.3, -0.4);

double value(const std::string &text, const Constants &constants = {}) {
  return Expression<2>(text, constants, "here")(x0);
}

/** At x = 0.3, y = -0.4, against the functions of the language. */
void test_values(Checks &checks) {
  const double pi = std::acos(-1.);
  const std::vector<std::pair<std::string, double>> rows = {
    {"1 + 2*3 - 4/8", 6.5},
    {"2^3^2", 512.},
    {"-x^2", -0.09},
    {"2*(x - y)", 1.4},
    {"x > 0 ? 1 : 2", 1.},
    {"y > 0 ? 1 : x > 0 ? 3 : 2", 3.},
    {"(x > 0 && y > 0) + 2*(x > 0 || y > 0)", 2.},
    {"(x <= 0.3) + 2*(x >= 0.3) + 4*(x == 0.3) + 8*(x != 0.3)", 7.},
    {"max(x, y, 0.7) - min(x, y)", 1.1},
    {"pow(x, 3)", 0.027},
    {"erf(x) + erfc(x)", 1.},
    {"erf(0.5)", 0.520499877813046537},
    {"log10(1000)", 3.},
    {"sqrt(abs(y))", std::sqrt(0.4)},
    {"floor(y) + 10*ceil(x)", 9.},
    {"sign(y)", -1.},
    {"sin(pi/6)", 0.5},
    {"tan(x) + atan2(y,x)", std::tan(0.3) + std::atan2(-0.4, 0.3)},
    {"asin(x) + acos(x)", pi / 2.},
    {"sinh(x) + cosh(x) - exp(x)", 0.}};
  for (const auto &row : rows)
    checks.near(row.first, value(row.first), row.second, 1e-14);
  for (const char *text : {"1/0", "sqrt(y)", "log(0)", "0/0"})
    checks.that("not finite: " + std::string(text), !std::isfinite(value(text)));
}

void test_refusals(Checks &checks) {
  for (const char *text :
       {"x=3",        "x+=3",       "1,2",   "(1,2)",   "",         "  ",    "x y",
        "2x",         "x +",        "sin(x", "sin()",   "sin(x,y)", "z",     "unknown",
        "unknown(x)", "if(x>0, 1)", "x ? 1", "1..2",    "\"x\"",    "x; y",  "x @ y",
        "a=1",        "(x)'",       "(x)~",  "(x)^2 2", "(x)^2x",   "(x)^^2"})
    checks.throws<InputError>("refused: '" + std::string(text) + "'", "here: the expression '",
                              [&] { Expression<2>(text, {}, "here"); });
}

void test_constants(Checks &checks) {
  const Constants constants =
    read_constants("E=2.5, nu = 0.25, mu=E/(2*(1+nu)), s=max(E,3), a=2*pi", "c");
  const Constants expected = {
    {"E", 2.5}, {"nu", 0.25}, {"mu", 1.}, {"s", 3.}, {"a", 2. * dealii::numbers::PI}};
  checks.near("number of constants", constants.size(), expected.size(), 0);
  for (const auto &[name, number] : expected)
    checks.near("constant " + name, constants.at(name), number, 1e-15);
  checks.near("constants in a formula", value("mu*x + E", constants), 2.8, 1e-15);
  checks.that("no constants", read_constants(" ", "c").empty());
  for (const char *text : {"2*y", "0*x"})
    checks.that("not constant", !Expression<2>(text, {}, "").is_constant());
  checks.that("is_constant", Expression<2>("2*pi + a", {{"a", 1.}}, "").is_constant());
}

/** Copies compute at points of their own, and longer than the original. */
void test_copies(Checks &checks) {
  auto original = std::make_unique<Expression<2>>("  a*x ", Constants({{"a", 2.}}), "here");
  const Expression<2> copy(*original), copy_of_copy(copy);
  checks.near("original", (*original)(Point(5., 0.)), 10., 0.);
  checks.near("copy at another point", copy(Point(1., 0.)), 2., 0.);
  const Expression<2> moved(std::move(*original));
  original.reset();
  checks.near("copy outlives the original", copy_of_copy(Point(3., 0.)), 6., 0.);
  checks.near("moved", moved(Point(4., 0.)), 8., 0.);
  checks.that("text is trimmed, the place kept",
              copy_of_copy.where() == "here" && copy.text() == "a*x");
}

std::vector<Expression<2>> expressions(const std::vector<std::string> &texts) {
  std::vector<Expression<2>> list;
  for (const std::string &text : texts)
    list.emplace_back(text, Constants(), "here");
  return list;
}

/** Brackets raised to 2 and 3 are multiplied out; everything that only looks like it is not. */
void test_powers(Checks &checks) {
  const double a = x0[0] + 1., b = x0[1] - 1.;
  const std::vector<std::pair<std::string, double>> rows = {
    {"(x+1)^2", a * a},
    {"(x+1)^3", a * a * a},
    {"((x+1)^2+(y-1)^3)^2", (a * a + b * b * b) * (a * a + b * b * b)},
    {"2-(x+1)^3*(y-1)^2/(x+1)^2", 2. - a * b * b},
    {"sin(x+1)^2+cos(x+1)^2", 1.},
    {"max(x,y)^3", std::pow(x0[0], 3)},
    {"(x+1)^2^3", std::pow(a, 8)},
    {"(x+1)^3^y", std::pow(a, std::pow(3., x0[1]))},
    {"(x+1)^2.5", std::pow(a, 2.5)},
    {"(x+1)^22", std::pow(a, 22)},
    {"(x+1)^2e-1", std::pow(a, 0.2)},
    {"2^(x+1)^2", std::pow(2., a * a)},
    {"(x+1)^2>1.5?(y-1)^2:0", b * b},
    {"(-2)^2+(-2)^3+x", -4. + x0[0]}};
  for (const auto &row : rows)
    checks.near("power " + row.first, value(row.first) / row.second, 1., 1e-14);
}

/** u = (sin(2x) exp(y), x^3 y^2), by all ways that a function is called. */
void test_functions(Checks &checks) {
  const std::vector<std::string> u = {"sin(2*x)*exp(y)", "x^3*y^2"};
  const ExpressionFunction<2> exact(expressions(u), {});
  const ExpressionFunction<2> given(
    expressions(u), expressions({"2*cos(2*x)*exp(y)", "sin(2*x)*exp(y)", "3*x^2*y^2", "2*x^3*y"}));
  for (const Point &x : {x0, Point(0.9, 0.1), Point(-0.5, 0.7), Point(0., 0.)}) {
    const double s = std::sin(2. * x[0]), c = std::cos(2. * x[0]), e = std::exp(x[1]);
    const Point gradients[] = {{2. * c * e, s * e},
                               {3. * x[0] * x[0] * x[1] * x[1], 2. * x[0] * x[0] * x[0] * x[1]}};
    const double expected[] = {s * e, std::pow(x[0], 3) * x[1] * x[1]};
    std::vector<std::vector<dealii::Tensor<1, 2>>> list(2, std::vector<dealii::Tensor<1, 2>>(2));
    std::vector<dealii::Vector<double>> values(2, dealii::Vector<double>(2));
    exact.vector_value_list({x0, x}, values);
    for (unsigned int i = 0; i < 2; ++i) {
      checks.near("values in a list", values[1][i], expected[i], 1e-15);
      checks.near("values", exact.value(x, i), expected[i], 1e-15);
    }
    for (const ExpressionFunction<2> *function : {&exact, &given}) {
      function->vector_gradient_list({x0, x}, list);
      for (unsigned int i = 0; i < 2; ++i) {
        checks.near("gradient", function->gradient(x, i), gradients[i], 1e-14);
        checks.near("gradients in a list", list[1][i], gradients[i], 1e-14);
      }
    }
  }
}

/** No step is too long: derivatives beside a singular point and a kink are right to rounding. */
void test_singular_functions(Checks &checks) {
  const ExpressionFunction<2> u(
    expressions({"(x^2 + y^2)^0.25*cos(0.5*atan2(y, x))", "sqrt(max(x, 0))*y"}), {});
  for (const double r : {1e-9, 1e-4, 0.5})
    for (const double angle : {0.3, 2., -3.}) {
      const Point x(r * std::cos(angle), r * std::sin(angle));
      const Point expected(0.5 / std::sqrt(r) * std::cos(0.5 * angle),
                           0.5 / std::sqrt(r) * std::sin(0.5 * angle));
      checks.near("singular", std::sqrt(r) * u.gradient(x, 0), std::sqrt(r) * expected, 1e-13);
      const double root = std::sqrt(std::max(x[0], 0.));
      const Point right(x[0] > 0. ? 0.5 * x[1] / root : 0., root);
      checks.near("root of a positive part", u.gradient(x, 1), right, 1e-13);
    }
}
} // namespace

int main() {
  return run_tests({test_values, test_refusals, test_constants, test_copies, test_powers,
                    test_functions, test_singular_functions});
}
