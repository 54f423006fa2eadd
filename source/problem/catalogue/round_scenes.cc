// SPDX-License-Identifier: LGPL-2.1-or-later
// E1, E2: rings with contact on the whole outer circle; E3: a half disc with contact on its arc.
// lambda = mu = 1, plane strain; c and s are cosine and sine of the polar angle t.

#include <algorithm>
#include <cmath>

#include "catalogue_scenes.h"
#include "manufactured.h"

namespace Signorini {
namespace {
constexpr double R1 = 1., R2 = 2.;

Jet2 radius_of(const Jets2 &x) {
  return sqrt(x[0] * x[0] + x[1] * x[1]);
}

/** Returns u_r e_r + u_t e_t. */
Jets2 from_polar(const Jet2 &c, const Jet2 &s, const Jet2 &u_r, const Jet2 &u_t) {
  return {u_r * c - u_t * s, u_r * s + u_t * c};
}

/** Returns the line through the origin at an angle. */
KinkLine<2> line_at_angle(const double angle) {
  return {Tensor<1, 2>({-std::sin(angle), std::cos(angle)}), 0.};
}

/** Lame's solution with the gap -0.1: p = 2 (lambda + mu) a + 2 mu a R1²/R2² with a = -1/15. */
Scene<2> make_e1() {
  Scene<2> scene = contact_scene<2>(
    make_ring(R1, R2), isotropic<2>(), "inner", "outer", [](const Point<2> &) { return -0.1; },
    [](const Point<2> &) { return -0.3; });
  set_exact_solution<2>(scene, [](const Jets2 &x) {
    const Jet2 r = radius_of(x), u_r = (1. / r - r) / 15.;
    return from_polar(x[0] / r, x[1] / r, u_r, 0.);
  });
  scene.body_force = nullptr;
  return scene;
}

/** Returns p of E2 at an angle with this cosine. */
Jet2 pressure_of_e2(const Jet2 &c) {
  return -3. * cube(positive_part(c - 0.3));
}

/** E2: u_r = (U + x b) C, u_t = (V + x a) C, x = r - R2, C = 1 - x^2, which makes sigma_rr = p and
 * sigma_rt = 0 at r = R2. */
Scene<2> make_e2() {
  Scene<2> scene = contact_scene<2>(
    make_ring(R1, R2), isotropic<2>(), "inner", "outer",
    [](const Point<2> &x) {
      const double c = x[0] / x.norm();
      return 0.05 * (2. * c * c - 1.) + 0.5 * std::pow(std::max(0.3 - c, 0.), 2);
    },
    [](const Point<2> &x) { return pressure_of_e2(x[0] / x.norm()).value; });
  set_exact_solution<2>(scene, [](const Jets2 &at) {
    const Jet2 r = radius_of(at), c = at[0] / r, s = at[1] / r, x = r - R2, C = 1. - x * x;
    const Jet2 U = 0.05 * (c * c - s * s), dU = -0.2 * s * c, V = 0.1 * s, dV = 0.1 * c;
    const Jet2 a = (V - dU) / R2, b = (pressure_of_e2(c) - (U + dV) / R2) / 3.;
    return from_polar(c, s, (U + x * b) * C, (V + x * a) * C);
  });
  scene.kinks = Kinks<2>({line_at_angle(std::acos(0.3)), line_at_angle(-std::acos(0.3))});
  return scene;
}

/** Returns p of E3 at an angle with this sine. */
Jet2 pressure_of_e3(const Jet2 &s) {
  return -20. * cube(positive_part(-s - 0.6));
}

/** E3: u = r^4 (r - 1) p(t)/3 e_r. */
Scene<2> make_e3() {
  Scene<2> scene = contact_scene<2>(
    make_half_disc(1.), isotropic<2>(), "flat", "arc",
    [](const Point<2> &x) { return 0.5 * std::pow(std::max(0.6 + x[1] / x.norm(), 0.), 2); },
    [](const Point<2> &x) { return pressure_of_e3(x[1] / x.norm()).value; });
  set_exact_solution<2>(scene, [](const Jets2 &x) {
    // The pressure, and the field with it, is zero near the line y = 0, where r may be zero.
    if (x[1].value > -1e-100)
      return Jets2();
    const Jet2 r = radius_of(x), s = x[1] / r;
    const Jet2 factor = cube(r) * (r - 1.) * pressure_of_e3(s) / 3.;
    return Jets2{factor * x[0], factor * x[1]};
  });
  scene.kinks = Kinks<2>({line_at_angle(-std::asin(0.6)), line_at_angle(std::asin(0.6))});
  return scene;
}

const std::string ring = "Body      the ring 1 < r < 2; polar coordinates r, t\n"
                         "Material  E = 2.5, nu = 0.25 (lambda = mu = 1), plane strain\n"
                         "Boundary  clamped at r = 1, contact at r = 2\n";
} // namespace

std::vector<CatalogueEntry<2>> round_scenes() {
  return {{"E1", "a ring pressed from all around: constant pressure on a circle (Lame)",
           ring + "Load      none\n"
                  "Gap       -0.1\n"
                  "Exact u   u_r = -(r - 1/r)/15, u_t = 0\n"
                  "Exact p   -0.3\n",
           make_e1},
          {"E2", "a ring in contact on a part of its outer circle",
           ring + "Load      body force -div sigma(u)\n"
                  "Gap       0.05 cos 2t + 0.5 (0.3 - cos t)_+^2\n"
                  "Exact u   with s = r - 2, U = 0.05 cos 2t, V = 0.1 sin t:\n"
                  "          u_r = (U + s (p - (U + V')/2)/3) (1 - s^2),\n"
                  "          u_t = (V + s (V - U')/2) (1 - s^2)\n"
                  "Exact p   -3 (cos t - 0.3)_+^3\n",
           make_e2},
          {"E3", "a half disc in contact on a part of its arc",
           "Body      the half disc r < 1, y < 0; polar coordinates r, t\n"
           "Material  E = 2.5, nu = 0.25 (lambda = mu = 1), plane strain\n"
           "Boundary  clamped at y = 0, contact at r = 1\n"
           "Load      body force -div sigma(u)\n"
           "Gap       0.5 (0.6 + sin t)_+^2\n"
           "Exact u   u_r = r^4 (r-1) p(t)/3, u_t = 0\n"
           "Exact p   -20 (-sin t - 0.6)_+^3\n",
           make_e3}};
}
} // namespace Signorini
