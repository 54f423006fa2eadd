// SPDX-License-Identifier: LGPL-2.1-or-later
// C1, C2, C3: full contact, no contact, touching without pressure; C4: two contact sides.

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

#include "catalogue_scenes.h"

namespace Signorini
{
using numbers::PI;

// C1: p = -(2 + cos(pi x)), slack 0.
Scene<2> make_c1()
{
  LiftFamily family;
  family.p = [](const double x) {
    const double c = std::cos(PI * x), s = std::sin(PI * x);
    return Derivatives{-(2. + c), PI * s, PI * PI * c, 0.};
  };
  family.slack = [](const double) { return 0.; };
  return make_lift_scene(family, make_lame_material(1., 1.));
}

// C2: p = 0, slack 0.1.
Scene<2> make_c2()
{
  LiftFamily family;
  family.p = [](const double) { return Derivatives{}; };
  family.slack = [](const double) { return 0.1; };
  return make_lift_scene(family, make_lame_material(1., 1.));
}

// C3: p = -10 (xi1-x)_+^3, slack (x-xi)_+^2, xi1 = (sqrt(5)-1)/4 < xi: from xi1 to xi the body
// touches without pressure.
Scene<2> make_c3()
{
  const double xi1 = (std::sqrt(5.) - 1.) / 4.;
  LiftFamily family;
  family.p = cubic_pressure(10., xi1);
  family.slack = quadratic_slack(numbers::SQRT1_2);
  family.kinks_at_x = {xi1, numbers::SQRT1_2};
  return make_lift_scene(family, make_lame_material(1., 1.));
}

namespace
{
constexpr double xi = numbers::SQRT1_2;
const double eta = 1. / std::sqrt(3.);

/** Returns -A (1 - t²/a²)_+^3 with two derivatives. */
std::array<double, 3> bump(const double A, const double a, const double t)
{
  return cube_of_positive_part(-A, {1. - t * t / (a * a), -2. * t / (a * a), -2. / (a * a)});
}

/** Returns u1 = x q(y), u2 = B(y) d(x), q = p2/L, d = (p1 - p1(0))/L, B = y - y^3, lambda = mu = 1,
 * L = 3. */
FieldAtPoint corner_field(const Point<2> &point)
{
  constexpr double lambda = 1., mu = 1., L = 3.;
  const double x = point[0], y = point[1];
  const auto p1 = bump(2., xi, x), p2 = bump(6., eta, y);
  const double q = p2[0] / L, dq = p2[1] / L, ddq = p2[2] / L;
  const double d = (p1[0] + 2.) / L, dd = p1[1] / L, ddd = p1[2] / L;
  const double B = y - y * y * y, dB = 1. - 3. * y * y, ddB = -6. * y;
  return {
    {x * q, B * d},
    {{{{q, x * dq}}, {{B * dd, dB * d}}}},
    {-(lambda + mu) * dB * dd - mu * x * ddq, -(lambda + mu) * dq - L * ddB * d - mu * B * ddd}};
}
} // namespace

// C4: contact at the bottom, p = -2 (1-x²/xi²)_+^3, and on the left up to y = 3/4, p = -6
// (1-y²/eta²)_+^3.
Scene<2> make_c4()
{
  Scene<2> scene;
  scene.geometry = make_rectangle({0., 0.}, {1., 1.}, {1, 1});
  std::vector<Side<2>> &sides = scene.geometry.sides;
  const std::size_t left = scene.geometry.find_side("left");
  const Point<2> division(0., 0.75), normal(-1., 0.);
  sides.emplace_back("upper left", Curve(division, sides[left].end(), normal));
  sides[left] = Side<2>("left", Curve(sides[left].start(), division, normal));
  scene.geometry.number_after_refinement = [sides](Triangulation<2> &triangulation) {
    number_boundary(sides, triangulation);
  };

  scene.boundary.resize(sides.size());
  const auto condition = [&](const char *name) -> BoundaryCondition<2> & {
    return scene.boundary[scene.geometry.find_side(name)];
  };
  scene.material = make_lame_material(1., 1.);
  condition("top").role = Role::clamped;
  condition("right") = {
    Role::traction, traction_of(corner_field, scene.material, Point<2>(1., 0.)), nullptr};
  condition("bottom") = {Role::contact,
                         function_of(quadratic_slack(xi)),
                         function_of([](const double x) { return bump(2., xi, x)[0]; })};
  condition("left") = {Role::contact,
                       function_of(quadratic_slack(eta), 1),
                       function_of([](const double y) { return bump(6., eta, y)[0]; }, 1)};
  scene.body_force = body_force_of(corner_field);
  scene.exact_displacement = displacement_of(corner_field);
  scene.kinks = lines_at<2>({{{xi}, {eta}}});
  return scene;
}
} // namespace Signorini
