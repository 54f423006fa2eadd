// SPDX-License-Identifier: LGPL-2.1-or-later
// A1, A1L, A2: smooth manufactured contact, lambda = mu = 1, plane strain; u in H^{7/2-eps}.

#include <signorini/problem/scene/functions.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

#include "catalogue_scenes.h"

namespace Signorini
{
namespace
{
constexpr double xi = numbers::SQRT1_2;
} // namespace

// A1: p = -10 (xi-x)_+^3, slack (x-xi)_+^2, xi = 1/sqrt(2).
Scene<2> make_a1()
{
  LiftFamily family;
  family.p = cubic_pressure(10., xi);
  family.slack = quadratic_slack(xi);
  family.kinks_at_x = {xi};
  return make_lift_scene(family, make_lame_material(1., 1.));
}

// A1L: as A1, but the gap has a kink, slack 0.3 (x-xi)_+.
Scene<2> make_a1l()
{
  LiftFamily family;
  family.p = cubic_pressure(10., xi);
  family.slack = [](const double x) { return 0.3 * std::max(x - xi, 0.); };
  family.kinks_at_x = {xi};
  return make_lift_scene(family, make_lame_material(1., 1.));
}

// A2: p = -2 q_+^3, q = sin(3 pi x + 1), slack 0.2 (-q)_+^2: three transitions.
Scene<2> make_a2()
{
  constexpr double omega = 3. * numbers::PI;
  LiftFamily family;
  family.p = [](const double x) {
    const double q = std::sin(omega * x + 1.), dq = omega * std::cos(omega * x + 1.);
    const auto p = cube_of_positive_part(-2., {q, dq, -omega * omega * q});
    return Derivatives{p[0], p[1], p[2], 0.};
  };
  family.slack = [](const double x) {
    const double q = std::max(-std::sin(omega * x + 1.), 0.);
    return 0.2 * q * q;
  };
  for (const double k : {1., 2., 3.})
    family.kinks_at_x.push_back((k - 1. / numbers::PI) / 3.);
  return make_lift_scene(family, make_lame_material(1., 1.));
}

// A block (-1,1) x (0,1), E = 1, nu = 0.3, plane strain, lowered by 0.05 onto a foundation that
// falls away from its top as x^2/(2 R), R = 2.

Scene<2> make_block_on_parabola()
{
  const auto function = [](const std::vector<std::string> &components) {
    std::vector<Expression<2>> values;
    for (const std::string &component : components)
      values.emplace_back(component, Constants(), "block on parabola");
    return std::make_shared<ExpressionFunction<2>>(values, std::vector<Expression<2>>(), 1e-4);
  };
  Scene<2> scene;
  scene.geometry = make_rectangle({-1., 0.}, {1., 1.}, {2, 1});
  scene.boundary.resize(scene.geometry.sides.size());
  scene.boundary[scene.geometry.find_side("top")] = {
    Role::displacement, function({"0", "-0.05"}), nullptr};
  scene.boundary[scene.geometry.find_side("bottom")] = {
    Role::contact, function({"x^2/4"}), nullptr};
  scene.material = make_isotropic<2>(Expression<2>("1", {}, "block on parabola"),
                                     Expression<2>("0.3", {}, "block on parabola"),
                                     PlaneState::strain);
  return scene;
}

// O1, V1: the contact of A1 with a rotated orthotropic and with a varying material.

namespace
{
LiftFamily contact_of_a1()
{
  LiftFamily family;
  family.p = cubic_pressure(10., numbers::SQRT1_2);
  family.slack = quadratic_slack(numbers::SQRT1_2);
  family.kinks_at_x = {numbers::SQRT1_2};
  return family;
}
} // namespace

// O1: Q11 = 4, Q22 = 1.2, Q12 = 0.5, Q66 = 0.6, axes turned by 30 degrees.
Scene<2> make_o1()
{
  std::vector<Expression<2>> moduli;
  for (const char *modulus : {"4", "1.2", "0.5", "0.6"})
    moduli.emplace_back(modulus, Constants(), "O1");
  const double c13 = 7.4 * std::sqrt(3.) / 16., c23 = 3.8 * std::sqrt(3.) / 16.;
  LiftFamily family = contact_of_a1();
  family.C = {{{{2.9625, 0.8375, c13}}, {{0.8375, 1.5625, c23}}, {{c13, c23, 0.9375}}}};
  return make_lift_scene(family, make_orthotropic(moduli, 30.));
}

// V1: lambda = mu = m(x,y) = 1 + sin(2x+y)/2.
Scene<2> make_v1()
{
  LiftFamily family = contact_of_a1();
  family.modulus = [](const Point<2> &x) {
    const double phase = 2. * x[0] + x[1];
    return Modulus{1. + 0.5 * std::sin(phase), std::cos(phase), 0.5 * std::cos(phase)};
  };
  return make_lift_scene(family,
                         make_isotropic<2>(Expression<2>("2.5*(1+0.5*sin(2*x+y))", {}, "V1"),
                                           Expression<2>("0.25", {}, "V1"),
                                           PlaneState::strain));
}

// D1: u = (0, eps (1-y)), eps = 0.125, p = -(lambda + 2 mu) eps = -0.375, gap -eps: exact to
// rounding on every mesh and every partition.

namespace
{
FunctionPointer<2> constant(const std::vector<std::string> &components,
                            const std::vector<std::string> &gradients = {})
{
  std::vector<Expression<2>> values;
  for (const std::string &component : components)
    values.emplace_back(component, Constants(), "D1");
  std::vector<Expression<2>> slopes;
  for (const std::string &gradient : gradients)
    slopes.emplace_back(gradient, Constants(), "D1");
  return std::make_shared<ExpressionFunction<2>>(values, slopes, 1e-4);
}
} // namespace

Scene<2> make_patch_test()
{
  Scene<2> scene;
  scene.geometry = make_rectangle({0., 0.}, {1., 1.}, {1, 1});
  scene.boundary.resize(scene.geometry.sides.size());
  const auto side = [&](const char *name) -> BoundaryCondition<2> & {
    return scene.boundary[scene.geometry.find_side(name)];
  };
  side("left") = {Role::traction, constant({"0.125", "0"}), nullptr};
  side("right") = {Role::traction, constant({"-0.125", "0"}), nullptr};
  side("top").role = Role::clamped;
  side("bottom") = {Role::contact, constant({"-0.125"}), constant({"-0.375"})};
  scene.material = make_isotropic<2>(
    Expression<2>("2.5", {}, "D1"), Expression<2>("0.25", {}, "D1"), PlaneState::strain);
  scene.exact_displacement = constant({"0", "0.125*(1-y)"}, {"0", "0", "0", "-0.125"});
  return scene;
}
} // namespace Signorini
