// SPDX-License-Identifier: LGPL-2.1-or-later
// Catalogue scenes and materials against numbers found elsewhere.

#include <signorini/problem/catalogue/catalogue.h>
#include <signorini/problem/input/make_scene.h>
#include <signorini/problem/parameters/parameters.h>

#include <cmath>

#include "tests.h"

using namespace Signorini;

namespace
{
using Point = dealii::Point<2>;
using Strain = dealii::SymmetricTensor<2, 2>;

const double xi = std::sqrt(0.5);

Parameters parameters(const std::vector<std::string> &settings)
{
  return parse_parameters("", "scenes.prm", settings);
}

Scene<2> scene(const std::vector<std::string> &settings)
{
  return make_scene<2>(parameters(settings));
}

const BoundaryCondition<2> &condition(const Scene<2> &scene, const std::string &side)
{
  return scene.boundary.at(scene.geometry.find_side(side));
}

Strain strain(const double e11, const double e22, const double e12)
{
  Strain e;
  e[0][0] = e11;
  e[1][1] = e22;
  e[0][1] = e12;
  return e;
}

void compare(Checks &checks,
             const std::string &name,
             const dealii::Function<2> &function,
             const Point &x,
             const std::vector<double> &expected,
             const double tolerance)
{
  for (unsigned int c = 0; c < expected.size(); ++c)
    checks.near(name + " " + std::to_string(c + 1), function.value(x, c), expected[c], tolerance);
  if (expected.size() == 1)
    return;
  dealii::Vector<double> values(2);
  function.vector_value(x, values);
  checks.near(name + " as a vector",
              std::hypot(values[0] - expected[0], values[1] - expected[1]),
              0.,
              2. * tolerance);
}

void compare(Checks &checks,
             const std::string &name,
             const Strain &s,
             const Strain &expected,
             const double tolerance)
{
  checks.near(name, (s - expected).norm(), 0., tolerance);
}

/** Stresses on the sides from the closed form; values inside stand in catalogue.cc. */
void test_a1(Checks &checks)
{
  const Scene<2> a1 = scene({"Scene/Name=A1", "Discretization/Kinks at y=0.25"});
  const auto traction = [](const double x, const double y) {
    const double M = std::max(xi - x, 0.);
    const double s11 = M * M * M * (10. * y * y - 10. / 3.) + 0.2 * x * x * y - 0.4 * x * y * y -
                       0.2 * x * y + 8. * x / 15. - 0.6 * y * y * y + 0.6 * y;
    const double s12 = 10. * M * M * (y - y * y * y) - 0.2 * x * x * y - 0.4 * x * y * y +
                       y * y * y / 15. + 0.2 * y * y - y / 15.;
    return std::vector<double>{x == 0. ? -s11 : s11, x == 0. ? -s12 : s12};
  };
  compare(checks,
          "A1 traction left",
          *condition(a1, "left").data,
          Point(0., 0.4),
          traction(0., 0.4),
          1e-14);
  compare(checks,
          "A1 traction right",
          *condition(a1, "right").data,
          Point(1., 0.7),
          traction(1., 0.7),
          1e-14);

  checks.that("A1 roles",
              condition(a1, "left").role == Role::traction &&
                condition(a1, "right").role == Role::traction &&
                condition(a1, "top").role == Role::clamped &&
                a1.contact_sides() == std::vector<unsigned int>{2});
  checks.that("A1 is known exactly", a1.has_exact_pressure());
  const std::vector<KinkLine<2>> &lines = a1.kinks.lines();
  checks.that("A1 kinks and those of the parameters",
              lines.size() == 2 && std::abs(lines[0].position - xi) < 1e-15 &&
                lines[0].normal[0] == 1. && lines[1].position == 0.25 && lines[1].normal[1] == 1.);
  checks.that("A1 contact may end where a kink meets its side",
              a1.kinks.ends().size() == 1 && a1.kinks.ends()[0].distance(Point(xi, 0.)) < 1e-15);
}

void test_other_scenes(Checks &checks)
{
  const Scene<2> d1 = scene({"Scene/Name=D1"});
  const Point x(0.3, 0.4);
  checks.that("D1 has no force", d1.body_force == nullptr);
  compare(checks, "D1 p", *condition(d1, "bottom").exact_pressure, x, {-0.375}, 0.);
  compare(checks, "D1 g", *condition(d1, "bottom").data, x, {-0.125}, 0.);

  const Scene<2> block = scene({"Scene/Name=block on parabola"});
  compare(checks, "block gap", *condition(block, "bottom").data, Point(-0.6, 0.), {0.09}, 1e-16);
  compare(checks, "block displacement", *condition(block, "top").data, x, {0., -0.05}, 0.);
  checks.that("block is not known exactly",
              block.exact_displacement == nullptr && !block.has_exact_pressure());
  bool listed = true, described = true;
  for (const CatalogueEntry<2> &entry : catalogue<2>())
  {
    const Scene<2> found = scene({"Scene/Name=" + entry.name});
    listed = listed && found.name == entry.name && found.title == entry.title &&
             describe_catalogue().find(entry.name) != std::string::npos;
    for (const char *key : {"Body ", "Material ", "Boundary ", "Load ", "Gap ", "Exact u "})
      described = described && found.description.find(key) != std::string::npos;
    described = described && (found.description.find("Exact p ") != std::string::npos) ==
                               found.has_exact_pressure();
  }
  checks.that("all scenes are listed and bear their names", listed);
  checks.that("all scenes are described", described);
}

/** A1 spelled out in a parameter file is A1. */
void test_described(Checks &checks)
{
  const Scene<2> a1 = scene({"Scene/Name=A1"});
  const Scene<2> same = scene(
    {"Constants/Values=xi=sqrt(0.5), lambda=1, mu=1, nu=lambda/(2*(lambda+mu)), E=2*mu*(1+nu)",
     "Material/Young's modulus=E",
     "Material/Poisson's ratio=nu",
     "Boundary/Clamped=top",
     "Boundary/Contact=bottom",
     "Boundary/Traction=right: 0.2*y-0.4*y^2-0.2*y+8/15-0.6*y^3+0.6*y; "
     "-0.2*y-0.4*y^2+y^3/15+0.2*y^2-y/15",
     "Load/Body force=max(xi-x,0)^2*(60*y^2-20)+0.2*x^2+0.4*x*y+0.2*y^2-0.2*y-7/15; "
     "-60*max(xi-x,0)^3*y+20*max(xi-x,0)*(y-y^3)-0.6*x^2-0.4*x*y+0.6*x+y^2-0.2",
     "Contact/Gap=-0.1*x*(1-x)+max(x-xi,0)^2",
     "Exact solution/Displacement=(0.2*x*y-0.1*y+0.1*x^2)*(1-y^2); "
     "(0.1*x*(1-x)-y*(10*max(xi-x,0)^3+0.2*x)/3)*(1-y^2)",
     "Exact solution/Pressure=-10*max(xi-x,0)^3"});
  double off = 0., gradient = 0.;
  for (const Point &x : {Point(0.3, 0.4), Point(0.7, 0.1), Point(0.95, 0.8), Point(0., 0.5)})
    for (unsigned int c = 0; c < 2; ++c)
    {
      const auto difference = [&](const FunctionPointer<2> &a, const FunctionPointer<2> &b) {
        off = std::max(off, std::abs(a->value(x, c) - b->value(x, c)));
      };
      difference(a1.exact_displacement, same.exact_displacement);
      difference(a1.body_force, same.body_force);
      if (c == 0)
      {
        difference(condition(a1, "bottom").data, condition(same, "bottom").data);
        difference(condition(a1, "bottom").exact_pressure,
                   condition(same, "bottom").exact_pressure);
      }
      gradient = std::max(
        gradient,
        (a1.exact_displacement->gradient(x, c) - same.exact_displacement->gradient(x, c)).norm());
    }
  checks.near("described A1 is A1", off, 0., 1e-13);
  checks.near("its gradient by differences", gradient, 0., 1e-10);

  const Scene<2> sides = scene({"Boundary/Clamped=top",
                                "Boundary/Contact=bottom, left",
                                "Contact/Gap=left: y>0.5||y<0.1 ? 1 : 2 | bottom: x^2",
                                "Exact solution/Pressure=x>0.5 ? 0 : -1"});
  compare(checks, "gap left", *condition(sides, "left").data, Point(0., 0.3), {2.}, 0.);
  compare(checks, "gap bottom", *condition(sides, "bottom").data, Point(0.3, 0.), {0.09}, 1e-16);
  compare(checks,
          "one pressure for both",
          *condition(sides, "left").exact_pressure,
          Point(0., 0.5),
          {-1.},
          0.);
  checks.that("two contact sides",
              sides.contact_sides() == std::vector<unsigned int>({0, 2}) &&
                sides.has_exact_pressure() && sides.body_force == nullptr);
}

std::shared_ptr<const Material<2>> material(std::vector<std::string> settings)
{
  settings.insert(settings.end(), {"Boundary/Clamped=top", "Boundary/Contact=bottom"});
  return scene(settings).material;
}

void test_isotropic(Checks &checks)
{
  const Point x(0.3, 0.4);
  const Strain e = strain(0.1, 0.2, 0.3);
  const auto plane_strain =
    material({"Material/Young's modulus=2.5", "Material/Poisson's ratio=0.25"});
  compare(checks, "plane strain", plane_strain->hooke(x) * e, strain(0.5, 0.7, 0.6), 1e-15);
  checks.near("stress across the plane", plane_strain->out_of_plane_stress(x, e), 0.3, 1e-15);
  const auto plane_stress = material({"Material/Plane state=stress"});
  compare(checks,
          "plane stress",
          plane_stress->hooke(x) * e,
          strain((0.1 + 0.06) / 0.91, (0.2 + 0.03) / 0.91, 0.3 / 1.3),
          1e-15);
  checks.near("no stress across the plane", plane_stress->out_of_plane_stress(x, e), 0., 0.);
  const auto varying =
    material({"Material/Young's modulus=1+x", "Material/Poisson's ratio=0.25*(1-y)"});
  compare(
    checks, "varying in space", varying->hooke(Point(0.5, 1.)) * e, strain(0.15, 0.3, 0.45), 1e-15);
  checks.that("is_constant", plane_strain->is_constant() && !varying->is_constant());
}

/** Q11 = 4, Q22 = 1.2, Q12 = 0.5, Q66 = 0.6 turned by 30 degrees, worked out by hand. */
void test_anisotropic(Checks &checks)
{
  const Point x(0.3, 0.4);
  const std::string moduli = "Material/Orthotropic moduli=4; 1.2; 0.5; 0.6";
  const auto turned = material({"Material/Law=orthotropic", moduli, "Material/Orientation=30"});
  const auto C = turned->hooke(x);
  const std::vector<std::pair<double, double>> entries = {{C[0][0][0][0], 2.9625},
                                                          {C[1][1][1][1], 1.5625},
                                                          {C[0][0][1][1], 0.8375},
                                                          {C[0][1][0][1], 0.9375},
                                                          {C[0][0][0][1], 0.8010734985006054},
                                                          {C[1][1][0][1], 0.4113620667976081}};
  for (unsigned int i = 0; i < entries.size(); ++i)
    checks.near(
      "orthotropic entry " + std::to_string(i), entries[i].first, entries[i].second, 1e-14);
  const double c = std::sqrt(0.75), s = 0.5;
  const Strain first = strain(c * c, s * s, s * c), second = strain(s * s, c * c, -s * c);
  checks.near("stiffness along the first axis", first * (C * first), 4., 1e-14);
  checks.near("stiffness along the second axis", second * (C * second), 1.2, 1e-14);
  checks.near("between them", first * (C * second), 0.5, 1e-14);

  const auto swapped = material({"Material/Law=orthotropic", moduli, "Material/Orientation=90"});
  compare(checks,
          "orthotropic at 90 degrees",
          swapped->hooke(x) * strain(1., 2., 3.),
          strain(1.2 + 1., 0.5 + 8., 3.6),
          1e-14);
  const auto general =
    material({"Material/Law=general", "Material/Hooke tensor=3+x; 1; 0.1; 4; 0.2; 1"});
  compare(checks,
          "general",
          general->hooke(Point(1., 0.)) * strain(1., 2., 3.),
          strain(4. + 2. + 0.6, 1. + 8. + 1.2, 0.1 + 0.4 + 6.),
          1e-14);
  checks.that("general is not constant", !general->is_constant() && turned->is_constant());
}
} // namespace

int main()
{
  dealii::deal_II_exceptions::disable_abort_on_exception();
  Checks checks;
  test_a1(checks);
  test_other_scenes(checks);
  test_described(checks);
  test_isotropic(checks);
  test_anisotropic(checks);
  return checks.exit_code();
}
