// SPDX-License-Identifier: LGPL-2.1-or-later
// Manufactured solutions by lifting boundary data from y = 0 into the square.

#include <algorithm>

#include "catalogue_scenes.h"

namespace Signorini
{
namespace
{
/** A field with its second derivatives u_{i,kl}. */
struct Jet
{
  FieldAtPoint field;
  std::array<std::array<std::array<double, 2>, 2>, 2> ddu;
};

/** A Voigt vector (11, 22, 12). */
using Voigt = std::array<double, 3>;

Voigt multiply(const std::array<Voigt, 3> &C, const Voigt &e)
{
  Voigt s = {};
  for (unsigned int a = 0; a < 3; ++a)
    for (unsigned int b = 0; b < 3; ++b)
      s[a] += C[a][b] * e[b];
  return s;
}

Jet lift(const LiftFamily &family, const Point<2> &x)
{
  const auto &C = family.C;
  const Derivatives U = family.U(x[0]), V = family.V(x[0]), p = family.p(x[0]);
  const double C22s = C[1][1] - C[1][2] * C[1][2] / C[2][2];
  const double C12s = C[0][1] - C[0][2] * C[1][2] / C[2][2];
  std::array<std::array<double, 3>, 2> slope;
  for (unsigned int k = 0; k < 3; ++k)
  {
    slope[1][k] = (p[k] - C12s * V[k + 1]) / C22s;
    slope[0][k] = -(C[0][2] * V[k + 1] + C[1][2] * slope[1][k]) / C[2][2] - U[k + 1];
  }
  const double y = x[1], c = 1. - y * y, c1 = -2. * y, c2 = -2.;
  Jet jet;
  for (unsigned int i = 0; i < 2; ++i)
  {
    const Derivatives &trace = i == 0 ? V : U;
    const auto &s = slope[i];
    jet.field.u[i] = (trace[0] + y * s[0]) * c;
    jet.field.du[i][0] = (trace[1] + y * s[1]) * c;
    jet.field.du[i][1] = s[0] * c + (trace[0] + y * s[0]) * c1;
    jet.ddu[i][0][0] = (trace[2] + y * s[2]) * c;
    jet.ddu[i][0][1] = jet.ddu[i][1][0] = s[1] * c + (trace[1] + y * s[1]) * c1;
    jet.ddu[i][1][1] = 2. * s[0] * c1 + (trace[0] + y * s[0]) * c2;
  }
  return jet;
}

/** Returns f = -div(m C eps) = -(m C eps_{,k} + m_{,k} C eps) contracted. */
std::array<double, 2> body_force(const LiftFamily &family, const Point<2> &x, const Jet &jet)
{
  const Modulus m = family.modulus(x);
  const auto &du = jet.field.du;
  const Voigt s = multiply(family.C, {du[0][0], du[1][1], du[0][1] + du[1][0]});
  std::array<Voigt, 2> ds;
  for (unsigned int k = 0; k < 2; ++k)
  {
    ds[k] =
      multiply(family.C, {jet.ddu[0][0][k], jet.ddu[1][1][k], jet.ddu[0][1][k] + jet.ddu[1][0][k]});
    for (unsigned int a = 0; a < 3; ++a)
      ds[k][a] = m[0] * ds[k][a] + m[1 + k] * s[a];
  }
  return {-(ds[0][0] + ds[1][2]), -(ds[0][2] + ds[1][1])};
}
} // namespace

Scene<2> make_lift_scene(const LiftFamily &family,
                         const std::shared_ptr<const Material<2>> &material)
{
  const Field field = [family](const Point<2> &x) {
    Jet jet = lift(family, x);
    jet.field.f = body_force(family, x, jet);
    return jet.field;
  };
  return make_manufactured_scene(
    field,
    material,
    [family](const double x) { return -family.U(x)[0] + family.slack(x); },
    [family](const double x) { return family.modulus(Point<2>(x, 0.))[0] * family.p(x)[0]; },
    family.kinks_at_x);
}

std::function<Derivatives(double)> cubic_pressure(const double a, const double xi)
{
  return [=](const double x) {
    const auto p = cube_of_positive_part(-a, {xi - x, -1., 0.});
    return Derivatives{p[0], p[1], p[2], 0.};
  };
}

Profile quadratic_slack(const double xi)
{
  return [=](const double x) {
    const double d = std::max(x - xi, 0.);
    return d * d;
  };
}
} // namespace Signorini
