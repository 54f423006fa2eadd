// SPDX-License-Identifier: LGPL-2.1-or-later
// The findings of the scan of formulas: integrals of data that hides between points, against closed
// forms, and nothing where data is smooth.

#include <signorini/discretization/mesh/cut_quadrature.h>
#include <signorini/problem/input/make_scene.h>
#include <signorini/problem/parameters/parameters.h>
#include <signorini/problem/scene/functions.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/grid/grid_generator.h>

#include <cmath>

#include "scene_text.h"
#include "tests.h"

using namespace Signorini;

namespace {
using Point = dealii::Point<2>;

/** The unit square with a body force along y, or a bound of friction on the bottom. */
Scene<2> scene_with(const std::string &force, const std::string &bound = "0") {
  const std::string text = "subsection Boundary\n set Clamped = top\n set Contact = bottom\n end\n"
                           "subsection Contact\n set Gap = 0.1\n set Friction = tresca\n"
                           " set Friction bound = " +
                           bound + "\n end\nsubsection Load\n set Body force = 0; " + force +
                           "\n end\n";
  return make_scene<2>(parse_parameters(parameter_file(text), "test"));
}

/** The integral of the force on 8 x 8 cells. */
double integral(const Scene<2> &scene) {
  dealii::Triangulation<2> mesh;
  dealii::GridGenerator::subdivided_hyper_cube(mesh, 8);
  const dealii::QGauss<2> plain(5);
  double sum = 0.;
  for (const auto &cell : mesh.active_cell_iterators()) {
    const bool is_cut = needs_cuts<2>(scene.kinks, cell);
    const dealii::Quadrature<2> rule =
      is_cut ? cut_quadrature(scene.kinks, cell, 5) : dealii::Quadrature<2>(plain);
    for (unsigned int q = 0; q < rule.size(); ++q) {
      const Point x = cell->vertex(0) + (rule.point(q) - Point()) / 8.;
      sum += scene.body_force->value(x, 1) * rule.weight(q) / 64.;
    }
  }
  return sum;
}

struct Family {
  std::string formula;
  double integral, tolerance;
};

void test_integrals(Checks &checks) {
  const double pi = dealii::numbers::PI, a = 0.317, w = 3e-3;
  const std::vector<Family> families = {
    {"abs(y - 0.3) < 0.006 ? -4.1667 : -0.01", -0.012 * 4.1567 - 0.01, 1e-13},
    {"abs(x - 0.61803) < 5e-5 ? 100 : 0.01", 1e-4 * 99.99 + 0.01, 1e-12},
    {"abs(x + 0.5*y - 0.7) < 1e-3 ? 1 : 0", 2e-3, 1e-13},
    {"(x - 0.4)^2 + (y - 0.6)^2 < 0.09 ? 1 : 0", 0.09 * pi, 1e-6},
    {"(x - 0.4)^2 + (y - 0.6)^2 < 1e-4 ? 1 : 0", 1e-4 * pi, 1e-7},
    {"exp(-((x - 0.317)/0.003)^2)", w * std::sqrt(pi), 1e-10},
    {"exp(-((x - 0.317)^2 + (y - 0.2)^2)/9e-6)", w * w * pi, 1e-9},
    {"1 + tanh((x - 0.317)/0.0003)", 2. * (1. - a), 1e-7},
    {"cos(200*pi*x)^2", 0.5, 1e-8},
    {"cos(40*pi*x) < 0 ? 1 : 0", 0.5, 1e-5},
    {"max(0, x + y - 1.3)", std::pow(0.7, 3) / 6., 1e-13},
    {"sqrt(abs(x - 0.317))", (std::pow(a, 1.5) + std::pow(1. - a, 1.5)) / 1.5, 1e-6},
    // Jumps on short lines, and details below the boxes that all data gets.
    {"abs(x - 0.5) < 0.004 && abs(y - 0.5) < 0.004 ? -500 : 0", -0.032, 1e-13},
    {"abs(x + y - 0.7) < 0.002 && abs(x - y + 0.1) < 0.003 ? 3000 : 0", 0.036, 1e-12},
    {"1 - (abs(y - 0.3) > 1e-6 || x < 0.25 || x > 0.250001 ? 1 : 1 - 1e12)", 2., 1e-3},
    {"max(abs(x - 0.61)/1e-4, abs(y - 0.43)/2e-4) < 1 ? 1e6 : 0", 0.08, 1e-12},
    {"1e4*max(0, 1 - ((x - 0.5)/0.004)^2)^2*max(0, 1 - ((y - 0.3)/0.004)^2)^2", 0.16 * 256. / 225.,
     1e-12},
    {"(x - 0.4)^2 + (y - 0.6)^2 < 1e-10 ? 1e10 : 0", pi, 1e-3},
    {"1e10*exp(-((x - 0.317)^2 + (y - 0.2)^2)*1e10)", pi, 1e-6}};
  for (const auto &[formula, expected, tolerance] : families)
    checks.near("integral of " + formula, integral(scene_with(formula)), expected, tolerance);
}

/** The scan begins with sixteenths of the body and with quarters of sides: a jump between two of
 * them is not lost. */
void test_jump_between_boxes(Checks &checks) {
  for (const char *formula : {"y < 0.5 ? -1 : 0", "(y - 0.2)^2 < 0.09 ? -1 : 0"})
    checks.that("a jump between boxes has a line: " + std::string(formula),
                scene_with(formula).kinks.lines().size() == 1);
  checks.near("a jump between quarters of a side cuts it",
              scene_with("0", "x < 0.5 ? 1 : 0").kinks.cut(Point(0.4, 0.), Point(0.6, 0.)),
              {0., 0.5, 1.}, 1e-13);
}

/** Lines on which conditions change and data does not are no lines. */
void test_lines_without_effect(Checks &checks) {
  for (const auto &[formula, n] : std::vector<std::pair<std::string, std::size_t>>{
         {"abs(x - 0.61) < 0.01 ? 1 : 0", 2},
         {"abs(x + y - 0.9) < 0.05 ? 1 : 0", 2},
         {"cos(3*atan2(y - 0.4, x - 1.1))", 0},
         {"1 + abs(x - 0.4)^2", 0},
         {"abs(x - 0.5) < 0.004 && abs(y - 0.5) < 0.004 ? -500 : 0", 4}})
    checks.near("lines of " + formula, scene_with(formula).kinks.lines().size(), double(n), 0.);
}

/** Plain rules stay plain where they are right. */
void test_smooth(Checks &checks) {
  for (const char *formula :
       {"0.1 + 0.3*x - 0.2*y", "0.25*x^2", "sin(pi*y)*cos(3*x)", "(1 + x^2)*(2 + y)",
        "exp(3*x)*(1 + 0.1*y)", "x*(1 - x)*y*(1 - y)", "1/(x + y + 0.3)", "(x*(1 - x)*y*(1 - y))^2",
        "atan2(y + 1, x - 0.7)", "atan2(abs(y) + 1, 0.3 - x)", "(1 - y)*(1 - 3*y)*x*(1 - x)"}) {
    const Scene<2> scene = scene_with(formula, formula);
    checks.about(formula);
    const dealii::BoundingBox<2> square({Point(0., 0.), Point(1., 1.)});
    checks.that("no lines", scene.kinks.lines().empty());
    checks.that("no boxes", !scene.kinks.boxes().divides(square));
    checks.that("no breaks", !scene.kinks.has_breaks(Point(0., 0.), Point(1., 0.)));
  }
}

/** The integral of the bound of friction over four faces. */
double integral_on_bottom(const Scene<2> &scene) {
  const dealii::QGauss<1> gauss(4);
  double sum = 0.;
  for (unsigned int i = 0; i < 4; ++i) {
    const Point a(0.25 * i, 0.), b(0.25 * (i + 1), 0.);
    const dealii::Quadrature<1> rule = split_quadrature(gauss, scene.kinks.cut(a, b));
    for (unsigned int q = 0; q < rule.size(); ++q)
      sum += 0.25 * rule.weight(q) *
             (scene.contacts[0].*scene.contact_law.limits()[0].data)
               ->value(a + rule.point(q)[0] * (b - a));
  }
  return sum;
}

void test_sides(Checks &checks) {
  checks.about("");
  const double pi = dealii::numbers::PI;
  const std::vector<Family> families = {
    {"abs(x - 0.3203125) < 0.00234375 ? 4.26667 : 0.001", 0.0046875 * 4.26567 + 0.001, 1e-13},
    // Nowhere else in the body.
    {"y < 1e-6 && abs(x - 0.3203) < 0.002 ? 5 : 0.001", 0.004 * 4.999 + 0.001, 1e-13},
    {"x*y < 1e-9 && abs(x - 0.3203) < 1e-6 ? 5e5 : 0.001", 1.001, 1e-8},
    {"x^2 < 0.1 ? 1 : 0", std::sqrt(0.1), 1e-10},
    {"exp(-((x - 0.317)/3e-4)^2)", 3e-4 * std::sqrt(pi), 1e-8},
    {"0.1 + (abs(x - 0.6) < 1e-7 ? 1e5 : 0)", 0.12, 1e-8},
    {"cos(400*pi*x) < 0 ? 1 : 0", 0.5, 1e-8},
    {"1 + cos(200*pi*x)", 1., 1e-6}};
  for (const auto &[formula, expected, tolerance] : families)
    checks.near("bound " + formula, integral_on_bottom(scene_with("0", formula)), expected,
                tolerance);
}
} // namespace

int main() {
  return run_tests(
    {test_integrals, test_jump_between_boxes, test_lines_without_effect, test_smooth, test_sides});
}
