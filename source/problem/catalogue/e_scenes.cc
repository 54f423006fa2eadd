// SPDX-License-Identifier: LGPL-2.1-or-later
// E1, E2: rings with contact on the whole outer circle; E3: a half disc with contact on its arc.
// lambda = mu = 1, plane strain.

#include <algorithm>
#include <cmath>

#include "catalogue_scenes.h"

namespace Signorini
{
namespace
{
constexpr double lambda = 1., mu = 1., M = lambda + 2. * mu;
constexpr double R1 = 1., R2 = 2.;

/** A value with two derivatives. */
using Jet = std::array<double, 3>;

double square_of_positive_part(const double t)
{
  return t > 0. ? t * t : 0.;
}

/** Returns the scene of a body clamped on one side and in contact on another; the data depends on
 * the angle. */
Scene<2> make_scene_of(const Geometry<2> &geometry,
                       const char *clamped,
                       const char *contact,
                       const PolarField &polar,
                       const Profile &gap,
                       const Profile &pressure)
{
  const Field field = field_of(polar, lambda, mu);
  Scene<2> scene;
  scene.geometry = geometry;
  scene.boundary.resize(geometry.sides.size());
  scene.boundary[geometry.find_side(clamped)].role = Role::clamped;
  scene.boundary[geometry.find_side(contact)] = {
    Role::contact, function_of_angle(gap), function_of_angle(pressure)};
  scene.material = make_lame_material(lambda, mu);
  scene.body_force = body_force_of(field);
  scene.exact_displacement = displacement_of(field);
  return scene;
}

/** Returns the ray from the origin at @p angle, continued to a line. */
KinkLine<2> line_at_angle(const double angle)
{
  return {Tensor<1, 2>({-std::sin(angle), std::cos(angle)}), 0.};
}

Jet sum(const Jet &u, const double factor, const Jet &v)
{
  return {u[0] + factor * v[0], u[1] + factor * v[1], u[2] + factor * v[2]};
}

PolarDerivatives sum(const PolarDerivatives &u, const PolarDerivatives &v)
{
  return {u.v + v.v, u.r + v.r, u.t + v.t, u.rr + v.rr, u.rt + v.rt, u.tt + v.tt};
}

/** Returns p = -3 (cos theta - 0.3)_+^3 with two derivatives. */
Jet pressure_of_e2(const double theta)
{
  return cube_of_positive_part(-3., {std::cos(theta) - 0.3, -std::sin(theta), -std::cos(theta)});
}

/** Returns u_r = (U + x b) Cc, u_theta = (V + x a) Cc, x = r - R2, Cc = 1 - (x/(R2-R1))^2, which
 * makes sigma_rr = p and sigma_rt = 0 at r = R2. */
PolarDisplacement displacement_of_e2(const double r, const double theta)
{
  const double s = std::sin(theta), c = std::cos(theta);
  const double s2 = std::sin(2. * theta), c2 = std::cos(2. * theta);
  const Jet U = {0.05 * c2, -0.1 * s2, -0.2 * c2}, dU = {-0.1 * s2, -0.2 * c2, 0.4 * s2};
  const Jet V = {0.1 * s, 0.1 * c, -0.1 * s}, dV = {0.1 * c, -0.1 * s, -0.1 * c};
  Jet a = sum(V, -1., dU), b = sum(pressure_of_e2(theta), -lambda / R2, sum(U, 1., dV));
  for (unsigned int k = 0; k < 3; ++k)
  {
    a[k] /= R2;
    b[k] /= M;
  }
  const double x = r - R2, width2 = (R2 - R1) * (R2 - R1);
  const Jet cut = {1. - x * x / width2, -2. * x / width2, -2. / width2};
  const Jet x_cut = {x * cut[0], cut[0] + x * cut[1], 2. * cut[1] + x * cut[2]};
  return {sum(product(cut, U), product(x_cut, b)), sum(product(cut, V), product(x_cut, a))};
}

/** Returns p = -20 (-sin theta - 0.6)_+^3 with two derivatives. */
Jet pressure_of_e3(const double theta)
{
  return cube_of_positive_part(-20., {-std::sin(theta) - 0.6, -std::cos(theta), std::sin(theta)});
}
} // namespace

// E1: u_r = a (r - R1²/r), gap -0.1: p = 2 (lambda + mu) a + 2 mu a R1²/R2² = -0.3.
Scene<2> make_e1()
{
  constexpr double delta = 0.1, a = -delta * R2 / (R2 * R2 - R1 * R1);
  constexpr double p = 2. * (lambda + mu) * a + 2. * mu * a * R1 * R1 / (R2 * R2);
  const auto displacement = [](const double r, const double) {
    PolarDisplacement u;
    u.radial.v = a * (r - R1 * R1 / r);
    u.radial.r = a * (1. + R1 * R1 / (r * r));
    u.radial.rr = -2. * a * R1 * R1 / (r * r * r);
    return u;
  };
  Scene<2> scene = make_scene_of(
    make_ring(R1, R2),
    "inner",
    "outer",
    displacement,
    [](const double) { return -delta; },
    [](const double) { return p; });
  scene.body_force = nullptr;
  return scene;
}

// E2: p = -3 (cos theta - 0.3)_+^3, slack 0.5 (0.3 - cos theta)_+^2.
Scene<2> make_e2()
{
  Scene<2> scene = make_scene_of(
    make_ring(R1, R2),
    "inner",
    "outer",
    displacement_of_e2,
    [](const double theta) {
      return 0.05 * std::cos(2. * theta) + 0.5 * square_of_positive_part(0.3 - std::cos(theta));
    },
    [](const double theta) { return pressure_of_e2(theta)[0]; });
  scene.kinks = Kinks<2>({line_at_angle(std::acos(0.3)), line_at_angle(-std::acos(0.3))});
  return scene;
}

// E3: u = r^4 (r - 1) p(theta)/(lambda + 2 mu) e_r, p = -20 (-sin theta - 0.6)_+^3, slack
// 0.5 (0.6 + sin theta)_+^2.
Scene<2> make_e3()
{
  const auto displacement = [](const double r, const double theta) {
    const double r2 = r * r, r3 = r2 * r;
    PolarDisplacement u;
    u.radial = product({r3 * r * (r - 1.) / M, r3 * (5. * r - 4.) / M, r2 * (20. * r - 12.) / M},
                       pressure_of_e3(theta));
    return u;
  };
  Scene<2> scene = make_scene_of(
    make_half_disc(1.),
    "flat",
    "arc",
    displacement,
    [](const double theta) { return 0.5 * square_of_positive_part(0.6 + std::sin(theta)); },
    [](const double theta) { return pressure_of_e3(theta)[0]; });
  scene.kinks = Kinks<2>({line_at_angle(-std::asin(0.6)), line_at_angle(std::asin(0.6))});
  return scene;
}
} // namespace Signorini
