// SPDX-License-Identifier: LGPL-2.1-or-later
// Formulas of the parameter file: values, refusals, constants, copies, gradients.

#include <signorini/base/errors.h>
#include <signorini/problem/scene/expression.h>
#include <signorini/problem/scene/functions.h>

#include <deal.II/base/numbers.h>

#include <cmath>
#include <memory>
#include <thread>

#include "tests.h"

using namespace Signorini;

namespace
{
using Point = dealii::Point<2>;

const Point x0(0.3, -0.4);

double value(const std::string &text, const Constants &constants = {})
{
  return Expression<2>(text, constants, "here")(x0);
}

/** At x = 0.3, y = -0.4, against the functions of the language. */
void test_values(Checks &checks)
{
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
  const Expression<2> formula("  x + y ", {}, "here");
  checks.that("text is trimmed", formula.text() == "x + y" && formula.where() == "here");
  for (const char *text : {"1/0", "sqrt(y)", "log(0)", "0/0"})
    checks.that("not finite: " + std::string(text), !std::isfinite(value(text)));
}

void test_refusals(Checks &checks)
{
  for (const char *text :
       {"x=3",   "x+=3",  "1,2",   "(1,2)",    "",      "  ",      "x y",        "2x",
        "x +",   "sin(x", "sin()", "sin(x,y)", "z",     "unknown", "unknown(x)", "if(x>0, 1)",
        "x ? 1", "1..2",  "\"x\"", "x; y",     "x @ y", "a=1"})
    checks.throws<InputError>("refused: '" + std::string(text) + "'",
                              "here: the expression '",
                              [&] { Expression<2>(text, {}, "here"); });
}

void test_constants(Checks &checks)
{
  const Constants constants = read_constants("E=2.5, nu = 0.25, mu=E/(2*(1+nu)), s=max(E,3)", "c");
  checks.near("number of constants", constants.size(), 4, 0);
  checks.near("plain constant", constants.at("nu"), 0.25, 0.);
  checks.near("constant of earlier ones", constants.at("mu"), 1., 1e-15);
  checks.near("comma inside of parentheses", constants.at("s"), 3., 0.);
  checks.near("constants in a formula", value("mu*x + E", constants), 2.8, 1e-15);
  checks.near(
    "pi in a constant", read_constants("a=2*pi", "c").at("a"), 2. * std::acos(-1.), 1e-15);
  checks.that("no constants", read_constants(" ", "c").empty());
}

void test_copies(Checks &checks)
{
  checks.that("is_constant",
              Expression<2>("2*pi + a", {{"a", 1.}}, "").is_constant() &&
                !Expression<2>("2*y", {}, "").is_constant() &&
                !Expression<2>("0*x", {}, "").is_constant());
  auto original = std::make_unique<Expression<2>>("a*x", Constants({{"a", 2.}}), "here");
  const Expression<2> copy(*original);
  const Expression<2> copy_of_copy(copy);
  const double before = (*original)(Point(5., 0.));
  checks.near("copy at another point", copy(Point(1., 0.)), 2., 0.);
  checks.near("original after the copy", (*original)(Point(5., 0.)), before, 0.);
  const Expression<2> moved(std::move(*original));
  original.reset();
  checks.near("copy outlives the original", copy_of_copy(Point(3., 0.)), 6., 0.);
  checks.near("moved", moved(Point(4., 0.)), 8., 0.);
  checks.that("copy keeps its place", copy_of_copy.where() == "here" && copy.text() == "a*x");
}

std::vector<Expression<2>> expressions(const std::vector<std::string> &texts)
{
  std::vector<Expression<2>> list;
  for (const std::string &text : texts)
    list.emplace_back(text, Constants(), "here");
  return list;
}

/** Brackets raised to 2 and 3 are multiplied out; everything that only looks like it is not. */
void test_powers(Checks &checks)
{
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
  for (const char *text : {"(x)'", "(x)~", "(x)^2 2", "(x)^2x", "(x)^^2"})
    checks.throws<InputError>("refused: " + std::string(text), "here: the expression '", [&] {
      Expression<2>(text, {}, "here");
    });
}

/** Several threads evaluate one formula at different points at the same time. */
void test_threads(Checks &checks)
{
  const ExpressionFunction<2> function(expressions({"(x+1)^3*sin(y)", "max(x,y)^2"}), {}, 1e-4);
  std::vector<std::vector<double>> values(4, std::vector<double>(5000));
  std::vector<std::thread> threads;
  for (unsigned int t = 0; t < values.size(); ++t)
    threads.emplace_back([&function, t, &mine = values[t]] {
      std::vector<Point> points(10);
      std::vector<double> list(10);
      for (unsigned int i = 0; i < mine.size(); i += 10)
      {
        for (unsigned int q = 0; q < 10; ++q)
          points[q] = Point(1e-3 * (i + q), t);
        function.value_list(points, list, 0);
        for (unsigned int q = 0; q < 10; ++q)
          mine[i + q] = list[q] + function.value(points[q], 1);
      }
    });
  for (std::thread &thread : threads)
    thread.join();
  double largest = 0.;
  for (unsigned int t = 0; t < values.size(); ++t)
    for (unsigned int i = 0; i < values[t].size(); ++i)
    {
      const Point x(1e-3 * i, t);
      largest =
        std::max(largest, std::abs(values[t][i] - (function.value(x, 0) + function.value(x, 1))));
    }
  checks.near("four threads", largest, 0., 0.);
}

/** u = (sin(2x) exp(y), x^3 y^2). */
void test_functions(Checks &checks)
{
  const std::vector<std::string> u = {"sin(2*x)*exp(y)", "x^3*y^2"};
  const std::vector<std::string> du = {
    "2*cos(2*x)*exp(y)", "sin(2*x)*exp(y)", "3*x^2*y^2", "2*x^3*y"};
  const ExpressionFunction<2> differences(expressions(u), {}, 1e-4);
  const ExpressionFunction<2> exact(expressions(u), expressions(du), 1e-4);
  double value_error = 0., difference_error = 0., exact_error = 0., list_error = 0.;
  for (const Point &x : {x0, Point(0.9, 0.1), Point(-0.5, 0.7), Point(0., 0.)})
  {
    const double s = std::sin(2. * x[0]), c = std::cos(2. * x[0]), e = std::exp(x[1]);
    const dealii::Tensor<1, 2> expected[2] = {
      Point(2. * c * e, s * e),
      Point(3. * x[0] * x[0] * x[1] * x[1], 2. * x[0] * x[0] * x[0] * x[1])};
    dealii::Vector<double> values(2);
    differences.vector_value(x, values);
    value_error = std::max({value_error,
                            std::abs(values[0] - s * e),
                            std::abs(values[1] - std::pow(x[0], 3) * x[1] * x[1]),
                            std::abs(values[1] - differences.value(x, 1))});
    std::vector<std::vector<dealii::Tensor<1, 2>>> list(2, std::vector<dealii::Tensor<1, 2>>(2));
    std::vector<dealii::Vector<double>> value_list(2, dealii::Vector<double>(2));
    exact.vector_gradient_list({x0, x}, list);
    differences.vector_value_list({x0, x}, value_list);
    value_error = std::max({value_error,
                            std::abs(value_list[1][0] - values[0]),
                            std::abs(value_list[1][1] - values[1])});
    for (unsigned int i = 0; i < 2; ++i)
    {
      const auto off = [&](const dealii::Tensor<1, 2> &g) { return (g - expected[i]).norm(); };
      difference_error = std::max(difference_error, off(differences.gradient(x, i)));
      exact_error = std::max(exact_error, off(exact.gradient(x, i)));
      list_error = std::max(list_error, off(list[1][i]));
    }
  }
  checks.near("values of a function", value_error, 0., 1e-15);
  checks.near("gradient by differences", difference_error, 0., 1e-10);
  checks.near("gradient by expressions", exact_error, 0., 1e-14);
  checks.near("lists use the expressions", list_error, 0., 1e-14);
}
} // namespace

int main()
{
  dealii::deal_II_exceptions::disable_abort_on_exception();
  Checks checks;
  test_values(checks);
  test_refusals(checks);
  test_constants(checks);
  test_copies(checks);
  test_powers(checks);
  test_threads(checks);
  test_functions(checks);
  return checks.exit_code();
}
