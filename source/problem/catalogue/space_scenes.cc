// SPDX-License-Identifier: LGPL-2.1-or-later
// D3: smooth contact on a disc of the lower side of the unit cube.
//
// E = 1, nu = 0.3, clamped at z = 1. With r the distance from (xc, yc) in the plane z = 0,
// W = (1 - r²/s²)_+ and
//
//     a = -0.05 (1 + x (1-x) + y (1-y)),   b = -0.3 W³,
//     A = (1-z)² (1+2z),   B = z (1-z)²,
//     u = (-a_x B, -a_y B, a A + b B).
//
// On z = 0: u = (0, 0, a) and sigma_3. = (0, 0, (lambda + 2 mu) b), so that p = (lambda + 2 mu) b
// and u_n = -a, which is the gap where p < 0.
//
// V3: the same displacement of a body with Young's modulus E = 1 + x/2 + y z; p and the stress are
// E times those of D3.

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "catalogue_scenes.h"

namespace Signorini
{
namespace
{
constexpr double youngs_modulus = 1., poissons_ratio = 0.3;
constexpr double lambda =
  youngs_modulus * poissons_ratio / ((1. + poissons_ratio) * (1. - 2. * poissons_ratio));
constexpr double mu = youngs_modulus / (2. * (1. + poissons_ratio));

/** The centre of the disc and its radius, which coincide with lines of no mesh. */
const double xc = 0.5707106781186547, yc = 0.4422649730810374, s = 1. / numbers::E;

double distance_from_centre(const Point<3> &x)
{
  return std::hypot(x[0] - xc, x[1] - yc);
}

/** Returns W. */
double bump(const Point<3> &x)
{
  const double r = distance_from_centre(x);
  return std::max(0., 1. - r * r / (s * s));
}

/** Returns a. */
double foundation(const Point<3> &x)
{
  return -0.05 * (1. + x[0] * (1. - x[0]) + x[1] * (1. - x[1]));
}

/** A function of z with two derivatives. */
struct Shape
{
  double value, first, second;
};

ExactField<3> d3_field(const Point<3> &x)
{
  const double z = x[2], W = bump(x), r2 = std::pow(distance_from_centre(x), 2);
  const double a = foundation(x), a_x = -0.05 * (1. - 2. * x[0]), a_y = -0.05 * (1. - 2. * x[1]);
  const double a_xx = 0.1, b = -0.3 * W * W * W;
  const double b_x = 1.8 * W * W * (x[0] - xc) / (s * s), b_y = 1.8 * W * W * (x[1] - yc) / (s * s);
  const double laplace_b = 1.8 / (s * s) * (2. * W * W - 4. * W * r2 / (s * s));
  const Shape A = {(1. - z) * (1. - z) * (1. + 2. * z), 6. * z * (z - 1.), 12. * z - 6.};
  const Shape B = {z * (1. - z) * (1. - z), (1. - z) * (1. - 3. * z), 6. * z - 4.};
  ExactField<3> field;
  field.u = {-a_x * B.value, -a_y * B.value, a * A.value + b * B.value};
  field.du = {
    {{-a_xx * B.value, 0., -a_x * B.first},
     {0., -a_xx * B.value, -a_y * B.first},
     {a_x * A.value + b_x * B.value, a_y * A.value + b_y * B.value, a * A.first + b * B.first}}};
  const auto tangential = [&](const double a_t, const double b_t) {
    return mu * a_t * B.second - (lambda + mu) * (a_t * A.first + b_t * B.first);
  };
  field.f = {tangential(a_x, b_x),
             tangential(a_y, b_y),
             -mu * (2. * a_xx * A.value + B.value * laplace_b + a * A.second + b * B.second) -
               (lambda + mu) * (-2. * a_xx * B.first + a * A.second + b * B.second)};
  return field;
}

/** Returns Young's modulus of V3. */
double modulus_of_v3(const Point<3> &x)
{
  return 1. + 0.5 * x[0] + x[1] * x[2];
}

/** Returns the field of V3: f = -div(E sigma) = E f_D3 - sigma grad E, where D3 has the modulus
 * one. */
ExactField<3> v3_field(const Point<3> &x)
{
  ExactField<3> field = d3_field(x);
  const std::array<double, 3> gradient = {0.5, x[2], x[1]};
  const double divergence = field.du[0][0] + field.du[1][1] + field.du[2][2];
  for (unsigned int i = 0; i < 3; ++i)
  {
    field.f[i] *= modulus_of_v3(x);
    for (unsigned int j = 0; j < 3; ++j)
      field.f[i] -= (mu * (field.du[i][j] + field.du[j][i]) + (i == j ? lambda * divergence : 0.)) *
                    gradient[j];
  }
  return field;
}

double pressure_of_d3(const Point<3> &x)
{
  const double W = bump(x);
  return -0.3 * (lambda + 2. * mu) * W * W * W;
}

double gap_of_d3(const Point<3> &x)
{
  const double beyond = std::max(0., distance_from_centre(x) - s);
  return -foundation(x) + 0.5 * beyond * beyond;
}

/** A function with one component. */
class ScalarFunction : public Function<3>
{
public:
  explicit ScalarFunction(double (*formula)(const Point<3> &))
    : formula_(formula)
  {
  }
  double value(const Point<3> &x, const unsigned int = 0) const override
  {
    return formula_(x);
  }

private:
  double (*formula_)(const Point<3> &);
};

Scene<3> contact_on_disc(const FieldOf<3> &field,
                         const char *modulus,
                         double (*pressure)(const Point<3> &))
{
  const auto number = [](const char *text) { return Expression<3>(text, {}, "catalogue"); };
  Scene<3> scene;
  scene.geometry = make_box({0., 0., 0.}, {1., 1., 1.}, {1, 1, 1});
  scene.material = make_isotropic<3>(number(modulus), number("0.3"), PlaneState::strain);
  scene.boundary.resize(scene.geometry.sides.size());
  for (const char *name : {"left", "right", "front", "back"})
  {
    const std::size_t side = scene.geometry.find_side(name);
    scene.boundary[side] = {
      Role::traction,
      traction_of(field, scene.material, scene.geometry.sides[side].normal({0., 0.})),
      nullptr};
  }
  scene.boundary[scene.geometry.find_side("top")].role = Role::clamped;
  scene.boundary[scene.geometry.find_side("bottom")] = {Role::contact,
                                                        std::make_shared<ScalarFunction>(gap_of_d3),
                                                        std::make_shared<ScalarFunction>(pressure)};
  scene.body_force = body_force_of(field);
  scene.exact_displacement = displacement_of(field);
  return scene;
}
} // namespace

Scene<3> make_d3()
{
  return contact_on_disc(d3_field, "1", pressure_of_d3);
}

Scene<3> make_v3()
{
  return contact_on_disc(v3_field, "1 + x/2 + y*z", [](const Point<3> &x) {
    return modulus_of_v3(x) * pressure_of_d3(x);
  });
}
} // namespace Signorini
