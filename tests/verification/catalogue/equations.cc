// SPDX-License-Identifier: LGPL-2.1-or-later
// Every catalogue scene with an exact solution: values from an independent program, and the
// equations of (1) by differences.

#include <signorini/problem/input/make_scene.h>
#include <signorini/problem/parameters/parameters.h>
#include <signorini/problem/scene/strain.h>
#include <signorini/verification/catalogue/catalogue.h>

#include <algorithm>
#include <cmath>

#include "contact_of.h"
#include "tests.h"

using namespace Signorini;

namespace {
using Point = dealii::Point<2>;
using Stress = dealii::SymmetricTensor<2, 2>;

/** Both components of a function; zero if there is none. */
Point vector(const FunctionPointer<2> &function, const Point &x) {
  return function == nullptr ? Point() : Point(function->value(x, 0), function->value(x, 1));
}

Strain<2> strain(const Scene<2> &scene, const Point &x) {
  dealii::Tensor<2, 2> gradient;
  for (unsigned int c = 0; c < 2; ++c)
    gradient[c] = scene.exact_displacement->gradient(x, c);
  return strain_at<2>(scene.geometry, x, vector(scene.exact_displacement, x), gradient);
}

HookesLaw<2> law(const Scene<2> &scene, const Point &x) {
  return {scene.material->hooke(x), scene.material->across(x)};
}

Stress stress(const Scene<2> &scene, const Point &x) {
  return law(scene, x).stress(strain(scene, x));
}

Scene<2> named(const std::string &name) {
  return make_scene<2>(parse_parameters("", "a.prm", {"Scene/Name=" + name}), named_scenes());
}

struct Sample {
  std::string name;
  /** u1, u2 at (0.3, 0.4); p and g at x = 0.3, g at x = 0.8 of the bottom. All else follows by the
   * equations. */
  std::vector<double> values;
};

/** D1 stands in scenes.cc. */
const std::vector<Sample> samples = {
  {"A1", {-0.00588, -0.0646488880953, -0.674722215136, -0.021, -0.00737084989848}},
  {"A1L", {-0.00588, -0.0646488880953, -0.674722215136, -0.021, 0.011867965644}},
  {"A2", {-0.00588, 0.01092, 0, 0.0592198245486, -0.016}},
  {"A3", {-0.0527558053156, -0.0262739529623, -0.814213562373, -0.0553409176183, 0.0405212555028}},
  {"B1", {-0.0242181967967, -0.0489067511214, -0.63804919966, 0, 0}},
  {"B2", {0.108667866821, 0.0255254554876, 0, 0, 0}},
  {"B3", {0.00892671459183, -0.0327479012783, 0, 0.0293730437689, 0.0684487100945}},
  {"B4", {-0.309224568007, -0.17075419907, -0.945741609003, 0.11348899308, -0.116429809617}},
  {"C1", {-0.00588, -0.278911948257, -2.58778525229, -0.021, -0.016}},
  {"C2", {-0.00588, 0.01092, 0, 0.079, 0.084}},
  {"C3", {-0.00588, 0.0109191788861, -7.33137435857e-06, -0.021, -0.00737084989848}},
  {"C4", {-0.0843648, 0.100493568, -1.102736, 0, 0.00862915010152}},
  {"O1", {0.0519840763419, -0.153492000207, -0.674722215136, -0.021, -0.00737084989848}},
  {"V1", {-0.00588, -0.0646488880953, -0.865210625341, -0.021, -0.00737084989848}}};

/** Twelve digits are known. */
void test_samples(Checks &checks) {
  for (const Sample &sample : samples) {
    const Scene<2> scene = named(sample.name);
    const Point u = vector(scene.exact_displacement, Point(0.3, 0.4)), near(0.3, 0.), far(0.8, 0.);
    const ContactCondition<2> &bottom = contact_of(scene, "bottom");
    const std::vector<double> found = {u[0], u[1], bottom.exact_pressure->value(near),
                                       bottom.gap->value(near), bottom.gap->value(far)};
    for (unsigned int i = 0; i < found.size(); ++i)
      checks.near(sample.name + ": sample values", found[i], sample.values.at(i),
                  2e-11 * std::max(1e-2, std::abs(sample.values[i])));
  }
}

/** Fourth-order difference of a vector in direction d. */
template <typename Function>
auto difference(const Function &f, const Point &x, const unsigned int d) {
  const double h = 5e-4;
  const dealii::Tensor<1, 2> step = h * Point::unit_vector(d);
  return (8. * (f(x + step) - f(x - step)) - (f(x + 2. * step) - f(x - 2. * step))) / (12. * h);
}

/** grad u and -div sigma = f at points away from kinks. */
void test_interior(Checks &checks, const Scene<2> &scene) {
  const auto u = [&](const Point &x) { return vector(scene.exact_displacement, x); };
  const auto sigma = [&](const Point &x) { return stress(scene, x); };
  const std::vector<Point> in_square = {{0.3, 0.4}, {0.62, 0.23}, {0.85, 0.7}, {0.1, 0.9}};
  const std::vector<Point> in_circle = {
    {1.2, 0.4}, {0.45, -0.7}, {-0.15, -0.95}, {0.1, -0.8}, {-0.9, 1.2}};
  for (const Point &x : scene.geometry.curved ? in_circle : in_square) {
    dealii::Tensor<1, 2> balance = vector(scene.body_force, x);
    for (unsigned int d = 0; d < 2; ++d) {
      balance += difference(sigma, x, d) * Point::unit_vector(d);
      for (unsigned int c = 0; c < 2; ++c)
        checks.near("gradient", scene.exact_displacement->gradient(x, c)[d], difference(u, x, d)[c],
                    1e-8);
    }
    // Around an axis, the hoop stress pulls inwards.
    if (scene.geometry.axisymmetric)
      balance +=
        Point(sigma(x)[0][0] - law(scene, x).stress_across(strain(scene, x)), sigma(x)[0][1]) /
        x[0];
    checks.near("-div sigma = f", balance.norm(), 0., 1e-7);
  }
}

/** The conditions of each role of a side on the exact solution. */
void test_sides(Checks &checks, const Scene<2> &scene) {
  for (unsigned int i = 0; i < scene.boundary.size(); ++i) {
    const BoundaryCondition<2> &condition = scene.boundary[i];
    const Side<2> &side = scene.geometry.sides[i];
    for (const double share : {0.01, 0.21, 0.4, 0.55, 0.76, 0.99}) {
      const double s = share * side.length();
      const Point x = side.point(s), u = vector(scene.exact_displacement, x);
      const auto n = side.normal(s), t = stress(scene, x) * n;
      if (condition.role == Role::clamped)
        checks.near("clamped", u.norm(), 0., 1e-14);
      if (condition.role == Role::roller)
        checks.near("axis", u * n, 0., 1e-14);
      if (condition.role == Role::free || condition.role == Role::traction)
        checks.near("tractions", t, vector(condition.data, x), 1e-13);
      if (condition.role != Role::contact)
        continue;
      const ContactCondition<2> &contact = contact_of(scene, side.name());
      const double p = contact.exact_pressure->value(x), w = u * n - contact.gap->value(x);
      const dealii::Tensor<1, 2> along({-n[1], n[0]});
      const double q =
        scene.contact_law.has_tangential_part() ? contact.exact_tangential->value(x) : 0.;
      checks.near("sigma n = p n + q t", t, p * n + q * along, 1e-13);
      if (scene.contact_law.has_tangential_part()) {
        const double slip = u * along - contact.shift->value(x),
                     s = scene.contact_law.bound(contact, x, p);
        checks.that("|q| <= s", std::abs(q) <= s + 1e-14);
        checks.near("q w = -s |w|", q * slip + s * std::abs(slip), 0., 1e-14);
      }
      checks.near("p w = 0", p * w, 0., 1e-14);
      checks.that("p <= 0, w <= 0", std::max(p, w) <= 1e-14);
    }
  }
}

void test_equations(Checks &checks) {
  for (const CatalogueEntry<2> &entry : catalogue<2>()) {
    const Scene<2> scene = named(entry.name);
    if (scene.exact_displacement == nullptr)
      continue;
    checks.about(entry.name);
    test_interior(checks, scene);
    test_sides(checks, scene);
  }
}

/** E2 at r = 1.5, theta = 0.7 and on its circle, from an independent program. */
void test_e2(Checks &checks) {
  const Scene<2> scene = named("E2");
  const auto at = [](const double r, const double theta) {
    return Point(r * std::cos(theta), r * std::sin(theta));
  };
  const Point x = at(1.5, 0.7);
  const ContactCondition<2> &contact = contact_of(scene, "outer");
  checks.near("E2: u", vector(scene.exact_displacement, x), Point(0.0263044093388, 0.0453764564707),
              1e-11);
  checks.near("E2: p(0.7), g(0.7), g(2)",
              {contact.exact_pressure->value(at(2., 0.7)), contact.gap->value(at(2., 0.7)),
               contact.gap->value(at(2., 2.))},
              {-0.301326871725, 0.00849835714501, 0.223750964705}, 1e-11);
}
} // namespace

int main() {
  return run_tests({test_samples, test_e2, test_equations});
}
