// SPDX-License-Identifier: LGPL-2.1-or-later
// Exact solutions in polar coordinates.

#include "polar_field.h"

#include <cmath>

namespace Signorini
{
namespace
{
class AngleFunction : public dealii::Function<2>
{
public:
  explicit AngleFunction(Profile profile)
    : profile_(std::move(profile))
  {
  }
  double value(const dealii::Point<2> &x, const unsigned int) const override
  {
    return profile_(std::atan2(x[1], x[0]));
  }

private:
  Profile profile_;
};

FieldAtPoint to_cartesian(const PolarDisplacement &u,
                          const double r,
                          const double theta,
                          const double lambda,
                          const double mu)
{
  const PolarDerivatives &ur = u.radial, &ut = u.angular;
  const double M = lambda + 2. * mu, r2 = r * r;
  const double gradient[2][2] = {{ur.r, (ur.t - ut.v) / r}, {ut.r, (ut.t + ur.v) / r}};
  const double force[2] = {-(M * (ur.rr + ur.r / r - ur.v / r2) + mu * ur.tt / r2 +
                             (lambda + mu) * ut.rt / r - (lambda + 3. * mu) * ut.t / r2),
                           -(mu * (ut.rr + ut.r / r - ut.v / r2) + M * ut.tt / r2 +
                             (lambda + mu) * ur.rt / r + (lambda + 3. * mu) * ur.t / r2)};
  // e[a][i]: component i of e_r and e_theta.
  const double e[2][2] = {{std::cos(theta), std::sin(theta)}, {-std::sin(theta), std::cos(theta)}};
  FieldAtPoint field = {};
  for (unsigned int i = 0; i < 2; ++i)
  {
    field.u[i] = ur.v * e[0][i] + ut.v * e[1][i];
    field.f[i] = force[0] * e[0][i] + force[1] * e[1][i];
    for (unsigned int j = 0; j < 2; ++j)
      for (unsigned int a = 0; a < 2; ++a)
        for (unsigned int b = 0; b < 2; ++b)
          field.du[i][j] += e[a][i] * gradient[a][b] * e[b][j];
  }
  return field;
}
} // namespace

PolarDerivatives product(const std::array<double, 3> &u, const std::array<double, 3> &v)
{
  return {u[0] * v[0], u[1] * v[0], u[0] * v[1], u[2] * v[0], u[1] * v[1], u[0] * v[2]};
}

Field field_of(const PolarField &polar, const double lambda, const double mu)
{
  return [=](const dealii::Point<2> &x) {
    const double r = x.norm(), theta = std::atan2(x[1], x[0]);
    return r < 1e-100 ? FieldAtPoint{} : to_cartesian(polar(r, theta), r, theta, lambda, mu);
  };
}

FunctionPointer<2> function_of_angle(const Profile &profile)
{
  return std::make_shared<AngleFunction>(profile);
}
} // namespace Signorini
