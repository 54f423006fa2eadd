// SPDX-License-Identifier: LGPL-2.1-or-later
// A1, A1L, A2, C1 to C4, D1, O1, V1: manufactured solutions on the unit square, contact at y = 0.

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

#include "catalogue_scenes.h"
#include "manufactured.h"

namespace Signorini {
namespace {
using numbers::PI;
constexpr double xi = numbers::SQRT1_2;

/** A function of x. */
using Jet1 = Jet<1>;
using Profile = std::function<Jet1(const Jet1 &)>;

/** Returns X(x) Y(y). (With functions of x and y all along, loads take three times as long.) */
Jet2 product(const Jet1 &X, const Jet1 &Y) {
  const double dX = X.gradient[0], dY = Y.gradient[0];
  return {X.value * Y.value, Tensor<1, 2>({dX * Y.value, X.value * dY}),
          SymmetricTensor<2, 2>({X.hessian[0][0] * Y.value, X.value * Y.hessian[0][0], dX * dY})};
}

double square_behind(const double x, const double transition) {
  return std::pow(std::max(x - transition, 0.), 2);
}

/** Returns -a (transition - x)_+^3. */
Profile cubic_pressure(const double a, const double transition) {
  return [=](const Jet1 &x) { return -a * cube(positive_part(transition - x)); };
}

Scene<2> square_scene(const std::shared_ptr<const Material<2>> &material, const ScalarField<2> &gap,
                      const ScalarField<2> &pressure, const std::vector<double> &kinks_at_x) {
  Scene<2> scene = contact_scene<2>(make_rectangle({0., 0.}, {1., 1.}, {1, 1}), material, "top",
                                    "bottom", gap, pressure);
  scene.kinks = lines_at<2>({{kinks_at_x, {}}});
  return scene;
}

/**
 * Returns the scene with the displacement that lifts boundary data from y = 0 into the square, for
 * Hooke's tensor m(x, y) C with C constant in Voigt's notation:
 *
 *     u1 = (V + y (gamma - U')) c(y),   u2 = (U + y b) c(y),   c(y) = 1 - y^2,
 *     b = (p - C12* V') / C22*,         gamma = -(C13 V' + C23 b) / C33,
 *     C22* = C22 - C23^2 / C33,         C12* = C12 - C13 C23 / C33,
 *     U = 0.1 x (1 - x),                V = 0.1 x^2,
 *
 * which gives sigma_22 = m(x, 0) p and sigma_12 = 0 on y = 0. With the gap g = -U + s, s >= 0 where
 * p = 0 and s = 0 where p < 0, all conditions of (1) hold.
 *
 * @param modulus m(x, y), with the gradient of its logarithm.
 */
template <typename Pressure>
Scene<2> lift(
  const Pressure &p, const std::function<double(double)> &slack,
  const std::vector<double> &kinks_at_x,
  const std::shared_ptr<const Material<2>> &material = isotropic<2>(),
  const ScalarField<2> &modulus = [](const Point<2> &) { return 1.; },
  const VectorField<2> &log_gradient = {}) {
  const SymmetricTensor<4, 2> C = material->hooke(Point<2>()) / modulus(Point<2>());
  const double C13 = C[0][0][0][1], C23 = C[1][1][0][1], C33 = C[0][1][0][1];
  const double C22s = C[1][1][1][1] - C23 * C23 / C33, C12s = C[0][0][1][1] - C13 * C23 / C33;
  const auto u = [=](const Jets2 &at) {
    const Tensor<1, 1> one({1.});
    const Jet1 x(at[0].value, one), y(at[1].value, one);
    const Jet1 U = 0.1 * x * (1. - x), dU = 0.1 - 0.2 * x, V = 0.1 * x * x, dV = 0.2 * x;
    const Jet1 b = (p(x) - C12s * dV) / C22s, gamma = -(C13 * dV + C23 * b) / C33;
    const Jet1 cut = 1. - y * y;
    return Jets2{product(V, cut) + product(gamma - dU, y * cut),
                 product(U, cut) + product(b, y * cut)};
  };
  Scene<2> scene = square_scene(
    material, [slack](const Point<2> &x) { return -0.1 * x[0] * (1. - x[0]) + slack(x[0]); },
    [p, modulus](const Point<2> &x) { return modulus(Point<2>(x[0], 0.)) * p(x[0]).value; },
    kinks_at_x);
  set_exact_solution<2>(scene, u, log_gradient);
  return scene;
}

/** Returns the contact of A1 in another material. */
Scene<2> contact_of_a1(
  const std::shared_ptr<const Material<2>> &material,
  const ScalarField<2> &modulus = [](const Point<2> &) { return 1.; },
  const VectorField<2> &log_gradient = {}) {
  return lift(
    cubic_pressure(10., xi), [](const double x) { return square_behind(x, xi); }, {xi}, material,
    modulus, log_gradient);
}

Scene<2> make_a1() {
  return contact_of_a1(isotropic<2>());
}

Scene<2> make_a1l() {
  return lift(cubic_pressure(10., xi), [](const double x) { return 0.3 * std::max(x - xi, 0.); },
              {xi});
}

Scene<2> make_a2() {
  const Profile q = [](const Jet1 &x) { return sin(3. * PI * x + 1.); };
  return lift([q](const Jet1 &x) { return -2. * cube(positive_part(q(x))); },
              [q](const double x) { return 0.2 * std::pow(std::min(q(x).value, 0.), 2); },
              {(1. - 1. / PI) / 3., (2. - 1. / PI) / 3., (3. - 1. / PI) / 3.});
}

Scene<2> make_c1() {
  const Profile p = [](const Jet1 &x) { return -2. - sin(PI * (x + 0.5)); };
  return lift(p, [](const double) { return 0.; }, {});
}

Scene<2> make_c2() {
  return lift([](const Jet1 &) { return Jet1(); }, [](const double) { return 0.1; }, {});
}

/** From xi1 to xi the body touches without pressure. */
Scene<2> make_c3() {
  const double xi1 = (std::sqrt(5.) - 1.) / 4.;
  return lift(cubic_pressure(10., xi1), [](const double x) { return square_behind(x, xi); },
              {xi1, xi});
}

/** Returns -A (1 - t²/a²)_+^3. */
Jet2 bump(const double A, const double a, const Jet2 &t) {
  return -A * cube(positive_part(1. - t * t / (a * a)));
}

/** Contact at the bottom, and on the left up to y = 3/4. */
Scene<2> make_c4() {
  const double eta = 1. / std::sqrt(3.);
  Scene<2> scene = square_scene(
    isotropic<2>(), [](const Point<2> &x) { return square_behind(x[0], xi); },
    [](const Point<2> &x) { return bump(2., xi, x[0]).value; }, {});
  scene.kinks = lines_at<2>({{{xi}, {eta}}});
  std::vector<Side<2>> &sides = scene.geometry.sides;
  const std::size_t left = scene.geometry.find_side("left");
  const Point<2> division(0., 0.75), normal(-1., 0.);
  sides.emplace_back("upper left", Curve(division, sides[left].end(), normal));
  sides[left] = Side<2>("left", Curve(sides[left].start(), division, normal));
  scene.geometry.number_after_refinement = [sides](Triangulation<2> &triangulation) {
    number_boundary(sides, triangulation);
  };
  scene.boundary.emplace_back();
  scene.boundary[left] = {
    Role::contact, function_of<2>([eta](const Point<2> &x) { return square_behind(x[1], eta); }),
    function_of<2>([eta](const Point<2> &x) { return bump(6., eta, x[1]).value; })};
  set_exact_solution<2>(scene, [eta](const Jets2 &at) {
    const Jet2 &x = at[0], &y = at[1];
    return Jets2{x * bump(6., eta, y) / 3., (y - cube(y)) * (bump(2., xi, x) + 2.) / 3.};
  });
  return scene;
}

/** Constant strain: exact to rounding on every mesh and every partition. */
Scene<2> make_d1() {
  Scene<2> scene = square_scene(
    isotropic<2>(), [](const Point<2> &) { return -0.125; },
    [](const Point<2> &) { return -0.375; }, {});
  set_exact_solution<2>(scene, [](const Jets2 &x) { return Jets2{Jet2(), 0.125 * (1. - x[1])}; });
  scene.body_force = nullptr;
  return scene;
}

Scene<2> make_o1() {
  std::vector<Expression<2>> moduli;
  for (const char *modulus : {"4", "1.2", "0.5", "0.6"})
    moduli.emplace_back(modulus, Constants(), "O1");
  return contact_of_a1(make_orthotropic(moduli, 30.));
}

Scene<2> make_v1() {
  const auto phase = [](const Point<2> &x) { return 2. * x[0] + x[1]; };
  const auto modulus = [phase](const Point<2> &x) { return 1. + 0.5 * std::sin(phase(x)); };
  return contact_of_a1(isotropic<2>("2.5*(1+0.5*sin(2*x+y))"), modulus, [=](const Point<2> &x) {
    return 0.5 * std::cos(phase(x)) / modulus(x) * Tensor<1, 2>({2., 1.});
  });
}

Scene<2> make_block_on_parabola() {
  Scene<2> scene;
  scene.geometry = make_rectangle({-1., 0.}, {1., 1.}, {2, 1});
  scene.material = isotropic<2>("1", "0.3");
  scene.boundary.resize(scene.geometry.sides.size());
  scene.boundary[scene.geometry.find_side("top")] = {
    Role::displacement,
    std::make_shared<Functions::ConstantFunction<2>>(std::vector<double>{0., -0.05}), nullptr};
  scene.boundary[scene.geometry.find_side("bottom")] = {
    Role::contact, function_of<2>([](const Point<2> &x) { return x[0] * x[0] / 4.; }), nullptr};
  return scene;
}

const std::string square = "Body      the unit square 0 < x < 1, 0 < y < 1\n";
const std::string lame = "Material  E = 2.5, nu = 0.25 (lambda = mu = 1), plane strain\n";
const std::string manufactured =
  "Boundary  clamped at y = 1, contact at y = 0, traction sigma(u) n on x = 0 and x = 1\n"
  "Load      body force -div sigma(u)\n";
const std::string lifted = "Exact u   u1 = (0.1 x^2 - y (0.1 - 0.2 x)) (1 - y^2),\n"
                           "          u2 = (0.1 x (1-x) + y (p(x) - 0.2 x)/3) (1 - y^2)\n";
const std::string square_lame = square + lame + manufactured;
const std::string gap_of_a1 = "Gap       -0.1 x (1-x) + (x-xi)_+^2, xi = 1/sqrt(2)\n";
} // namespace

std::vector<CatalogueEntry<2>> square_scenes() {
  return {
    {"A1", "smooth manufactured contact on half of a side, exact solution known",
     square_lame + "Gap       -0.1 x (1-x) + (x-xi)_+^2\n" + lifted +
       "Exact p   -10 (xi-x)_+^3, xi = 1/sqrt(2)\n",
     make_a1},
    {"A1L", "as A1, with a gap that has a kink where contact ends",
     square_lame + "Gap       -0.1 x (1-x) + 0.3 (x-xi)_+\n" + lifted +
       "Exact p   -10 (xi-x)_+^3, xi = 1/sqrt(2)\n",
     make_a1l},
    {"A2", "smooth manufactured contact in two zones, three transitions",
     square_lame + "Gap       -0.1 x (1-x) + 0.2 (-q)_+^2\n" + lifted +
       "Exact p   -2 q_+^3, q = sin(3 pi x + 1)\n",
     make_a2},
    {"C1", "full contact",
     square_lame + "Gap       -0.1 x (1-x)\n" + lifted + "Exact p   -(2 + cos(pi x))\n", make_c1},
    {"C2", "no contact", square_lame + "Gap       -0.1 x (1-x) + 0.1\n" + lifted + "Exact p   0\n",
     make_c2},
    {"C3", "touching without pressure on a part of the side",
     square_lame + "Gap       -0.1 x (1-x) + (x-xi)_+^2\n" + lifted +
       "Exact p   -10 (xi1-x)_+^3, xi1 = (sqrt(5)-1)/4, xi = 1/sqrt(2)\n",
     make_c3},
    {"C4", "contact on two sides that meet in a corner",
     square + lame +
       "Boundary  clamped at y = 1, contact at y = 0 and at x = 0 for y < 3/4, free at x = 0 for y "
       "> 3/4,\n"
       "          traction sigma(u) n on x = 1\n"
       "Load      body force -div sigma(u)\n"
       "Gap       (x - 1/sqrt(2))_+^2 at the bottom, (y - 1/sqrt(3))_+^2 on the left\n"
       "Exact u   u1 = x p_left(y)/3, u2 = (y - y^3) (p_bottom(x) + 2)/3\n"
       "Exact p   p_bottom = -2 (1 - 2 x^2)_+^3, p_left = -6 (1 - 3 y^2)_+^3\n",
     make_c4},
    {"D1", "patch test: constant strain under full contact, exact on every mesh",
     square + lame +
       "Boundary  clamped at y = 1, contact at y = 0, traction (0.125, 0) on x = 0 and (-0.125, 0) "
       "on x = 1\n"
       "Load      none\n"
       "Gap       -0.125\n"
       "Exact u   u1 = 0, u2 = 0.125 (1-y)\n"
       "Exact p   -0.375\n",
     make_d1},
    {"O1", "the contact of A1 with a rotated orthotropic material",
     square +
       "Material  Q11 = 4, Q22 = 1.2, Q12 = 0.5, Q66 = 0.6, first axis at 30 degrees; in x, y:\n"
       "          C11 = 2.9625, C12 = 0.8375, C13 = 7.4 sqrt(3)/16, C22 = 1.5625, C23 = 3.8 "
       "sqrt(3)/16,\n"
       "          C33 = 0.9375 with the strains e11, e22, 2 e12\n" +
       manufactured + gap_of_a1 +
       "Exact u   u1 = (V + y (c - U')) (1 - y^2), u2 = (U + y b) (1 - y^2), U = 0.1 x (1-x),\n"
       "          V = 0.1 x^2, b = (p - (C12 - C13 C23/C33) V')/(C22 - C23^2/C33),\n"
       "          c = -(C13 V' + C23 b)/C33\n"
       "Exact p   -10 (xi-x)_+^3\n",
     make_o1},
    {"V1", "the contact of A1 with a material that varies in space",
     square +
       "Material  E = 2.5 m, nu = 0.25 (lambda = mu = m), m = 1 + sin(2x+y)/2, plane strain\n" +
       manufactured + gap_of_a1 +
       "Exact u   u1 = (0.1 x^2 - y (0.1 - 0.2 x)) (1 - y^2),\n"
       "          u2 = (0.1 x (1-x) + y (p(x)/m(x,0) - 0.2 x)/3) (1 - y^2)\n"
       "Exact p   -10 m(x,0) (xi-x)_+^3\n",
     make_v1},
    {"block on parabola", "elastic block pressed on a parabolic foundation, no exact solution",
     "Body      the block -1 < x < 1, 0 < y < 1\n"
     "Material  E = 1, nu = 0.3, plane strain\n"
     "Boundary  displacement (0, -0.05) at y = 1, contact at y = 0, free on x = -1 and x = 1\n"
     "Load      none\n"
     "Gap       x^2/4\n"
     "Exact u   not known\n",
     make_block_on_parabola}};
}
} // namespace Signorini
