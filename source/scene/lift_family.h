// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/scene/scene.h>

#include <array>
#include <functional>

namespace Signorini
{
/** A function of x with its first three derivatives. */
using Derivatives = std::array<double, 4>;

/**
 * Manufactured solutions with exact complementarity on the unit square, contact at y = 0, clamped
 * at y = 1, for a constant Hooke tensor C in Voigt's notation:
 *
 *     u1 = (V + y (gamma - U')) c(y),   u2 = (U + y b) c(y),   c(y) = 1 - y^2,
 *     b = (p - C12* V') / C22*,         gamma = -(C13 V' + C23 b) / C33,
 *     C22* = C22 - C23^2 / C33,         C12* = C12 - C13 C23 / C33,
 *
 * which gives sigma_22 = p and sigma_12 = 0 on y = 0. With the gap g = -U + s, s >= 0 where p = 0
 * and s = 0 where p < 0, all conditions of (1) hold.
 */
struct LiftFamily
{
  /** U(x) = u2(x, 0). */
  std::function<Derivatives(double)> U;
  /** V(x) = u1(x, 0). */
  std::function<Derivatives(double)> V;
  /** Contact pressure p(x) <= 0; the third derivative is not needed. */
  std::function<Derivatives(double)> p;
  /** Slack s(x) of the gap. */
  std::function<double(double)> slack;
  /** C[i][j], strains (e11, e22, 2 e12). */
  std::array<std::array<double, 3>, 3> C;
};

/** The unit square with all data and the exact solution of the family; the material is left open.
 */
Scene<2> make_lift_scene(const LiftFamily &family);
} // namespace Signorini
