// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "manufactured_scene.h"

namespace Signorini
{
/** A function of x with its first three derivatives. */
using Derivatives = std::array<double, 4>;

/** A modulus m(x, y) with its partial derivatives. */
using Modulus = std::array<double, 3>;

/**
 * Manufactured solutions with exact complementarity on the unit square, contact at y = 0, clamped
 * at y = 1, for the Hooke tensor m(x, y) C, C constant in Voigt's notation:
 *
 *     u1 = (V + y (gamma - U')) c(y),   u2 = (U + y b) c(y),   c(y) = 1 - y^2,
 *     b = (ptilde - C12* V') / C22*,    gamma = -(C13 V' + C23 b) / C33,
 *     C22* = C22 - C23^2 / C33,         C12* = C12 - C13 C23 / C33,
 *
 * which gives sigma_22 = p = m(x, 0) ptilde and sigma_12 = 0 on y = 0. With the gap g = -U + s, s
 * >= 0 where p = 0 and s = 0 where p < 0, all conditions of (1) hold.
 */
struct LiftFamily
{
  /** The displacement U(x) = u2(x, 0); by default 0.1 x (1 - x). */
  std::function<Derivatives(double)> U = [](const double x) {
    return Derivatives{0.1 * x * (1. - x), 0.1 - 0.2 * x, -0.2, 0.};
  };
  /** The displacement V(x) = u1(x, 0); by default 0.1 x^2. */
  std::function<Derivatives(double)> V = [](const double x) {
    return Derivatives{0.1 * x * x, 0.2 * x, 0.2, 0.};
  };
  /** The pressure ptilde(x) <= 0; the third derivative is not needed. */
  std::function<Derivatives(double)> p;
  /** The slack s(x) of the gap. */
  Profile slack;
  /** The Voigt matrix C[i][j], strains (e11, e22, 2 e12); by default lambda = mu = 1. */
  std::array<std::array<double, 3>, 3> C = {{{{3., 1., 0.}}, {{1., 3., 0.}}, {{0., 0., 1.}}}};
  std::function<Modulus(const dealii::Point<2> &)> modulus = [](const dealii::Point<2> &) {
    return Modulus{1., 0., 0.};
  };
  std::vector<double> kinks_at_x;
};

/** Returns the scene of the family, for a material whose Hooke tensor is m C. */
Scene<2> make_lift_scene(const LiftFamily &family,
                         const std::shared_ptr<const Material<2>> &material);

/** Returns ptilde = -a (xi - x)_+^3. */
std::function<Derivatives(double)> cubic_pressure(double a, double xi);

/** Returns s = (x - xi)_+^2. */
Profile quadratic_slack(double xi);
} // namespace Signorini
