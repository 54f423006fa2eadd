// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "manufactured_scene.h"

namespace Signorini
{
/** A function of r and theta with its first and second derivatives. */
struct PolarDerivatives
{
  double v = 0.;
  double r = 0.;
  double t = 0.;
  double rr = 0.;
  double rt = 0.;
  double tt = 0.;
};

/** u_r and u_theta at a point. */
struct PolarDisplacement
{
  PolarDerivatives radial;
  PolarDerivatives angular;
};

using PolarField = std::function<PolarDisplacement(double r, double theta)>;

/** u(r) v(theta), from the values and the first two derivatives of both. */
PolarDerivatives product(const std::array<double, 3> &u, const std::array<double, 3> &v);

/**
 * A displacement in polar coordinates about the origin as a field in the plane, with the body force
 * of an isotropic material, M = lambda + 2 mu:
 *
 *     f_r     = -[M (u_r,rr + u_r,r/r - u_r/r²) + mu u_r,tt/r² + (lambda + mu) u_t,rt/r
 *                 - (lambda + 3 mu) u_t,t/r²]
 *     f_theta = -[mu (u_t,rr + u_t,r/r - u_t/r²) + M u_t,tt/r² + (lambda + mu) u_r,rt/r
 *                 + (lambda + 3 mu) u_r,t/r²]
 *
 * Everything is zero at the origin, where a field must vanish like r³.
 */
Field field_of(const PolarField &polar, double lambda, double mu);

/** A function of the angle. */
FunctionPointer<2> function_of_angle(const Profile &profile);
} // namespace Signorini
