// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/problem/scene/scene.h>

#include <array>
#include <functional>

namespace Signorini
{
/** An exact displacement u_i, its gradient u_{i,k} and the body force f = -div sigma at a point. */
template <int dim>
struct ExactField
{
  std::array<double, dim> u;
  std::array<std::array<double, dim>, dim> du;
  std::array<double, dim> f;
};

template <int dim>
using FieldOf = std::function<ExactField<dim>(const dealii::Point<dim> &)>;

using FieldAtPoint = ExactField<2>;
using Field = FieldOf<2>;

/** Returns a (q)_+^3 with two derivatives, from q with two derivatives. */
std::array<double, 3> cube_of_positive_part(double a, const std::array<double, 3> &q);

/** A function of the coordinate x or y. */
using Profile = std::function<double(double)>;

/** Returns u and its gradient as a deal.II function. */
FunctionPointer<2> displacement_of(const Field &field);
FunctionPointer<3> displacement_of(const FieldOf<3> &field);
/** Returns f as a deal.II function. */
FunctionPointer<2> body_force_of(const Field &field);
FunctionPointer<3> body_force_of(const FieldOf<3> &field);
/** Returns t = sigma n as a deal.II function. */
FunctionPointer<2> traction_of(const Field &field,
                               std::shared_ptr<const Material<2>> material,
                               const dealii::Tensor<1, 2> &normal);
FunctionPointer<3> traction_of(const FieldOf<3> &field,
                               std::shared_ptr<const Material<3>> material,
                               const dealii::Tensor<1, 3> &normal);
/** Returns a profile in the coordinate @p d as a deal.II function. */
FunctionPointer<2> function_of(const Profile &profile, unsigned int d = 0);

/** Returns the material with lambda and mu: E = mu (3 lambda + 2 mu)/(lambda + mu), nu = lambda/(2
 * (lambda + mu)). */
std::shared_ptr<const Material<2>> make_lame_material(double lambda, double mu);

/**
 * Returns the scene on the unit square, clamped at the top, in contact at the bottom with the given
 * gap and pressure, with the field's tractions on the left and right.
 */
Scene<2> make_manufactured_scene(const Field &field,
                                 const std::shared_ptr<const Material<2>> &material,
                                 const Profile &gap,
                                 const Profile &pressure,
                                 const std::vector<double> &kinks_at_x);

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

/** The components u_r and u_theta at a point. */
struct PolarDisplacement
{
  PolarDerivatives radial;
  PolarDerivatives angular;
};

using PolarField = std::function<PolarDisplacement(double r, double theta)>;

/** Returns u(r) v(theta), from the values and the first two derivatives of both. */
PolarDerivatives product(const std::array<double, 3> &u, const std::array<double, 3> &v);

/**
 * Returns a displacement in polar coordinates about the origin as a 2-D field, with the body force
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

/** Returns a function of the angle as a deal.II function. */
FunctionPointer<2> function_of_angle(const Profile &profile);
} // namespace Signorini
