// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/problem/scene/scene.h>

#include <array>
#include <functional>

namespace Signorini
{
// The file of each scene describes it.
Scene<2> make_a1();
Scene<2> make_a1l();
Scene<2> make_a2();
Scene<2> make_a3();
Scene<2> make_b1();
Scene<2> make_b1q();
Scene<2> make_b1t();
Scene<2> make_b2();
Scene<2> make_b3();
Scene<2> make_b4();
Scene<2> make_c1();
Scene<2> make_c2();
Scene<2> make_c3();
Scene<2> make_c4();
Scene<2> make_e1();
Scene<2> make_e2();
Scene<2> make_e3();
Scene<2> make_o1();
Scene<2> make_v1();
/** Returns constant strain under full contact, which is exact on every mesh. */
Scene<2> make_patch_test();
/** Returns an elastic block pressed on a parabolic foundation. */
Scene<2> make_block_on_parabola();
/** Returns smooth contact on a disc, in 3-D. */
Scene<3> make_d3();
/** Returns the same with a material that varies from point to point. */
Scene<3> make_v3();

/** An exact displacement u_i, its gradient u_{i,k} and the body force f = -div sigma at a point. */
template <int dim>
struct ExactField
{
  std::array<double, dim> u;
  std::array<std::array<double, dim>, dim> du;
  std::array<double, dim> f;
};

template <int dim>
using FieldOf = std::function<ExactField<dim>(const Point<dim> &)>;

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
                               const Tensor<1, 2> &normal);
FunctionPointer<3> traction_of(const FieldOf<3> &field,
                               std::shared_ptr<const Material<3>> material,
                               const Tensor<1, 3> &normal);
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
  std::function<Modulus(const Point<2> &)> modulus = [](const Point<2> &) {
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
