// SPDX-License-Identifier: LGPL-2.1-or-later
// O1, V1: the contact of A1 with a rotated orthotropic and with a varying material.

#include <deal.II/base/numbers.h>

#include <cmath>

#include "catalogue_scenes.h"
#include "lift_family.h"

namespace Signorini
{
namespace
{
LiftFamily contact_of_a1()
{
  LiftFamily family;
  family.p = cubic_pressure(10., dealii::numbers::SQRT1_2);
  family.slack = quadratic_slack(dealii::numbers::SQRT1_2);
  family.kinks_at_x = {dealii::numbers::SQRT1_2};
  return family;
}
} // namespace

// O1: Q11 = 4, Q22 = 1.2, Q12 = 0.5, Q66 = 0.6, axes turned by 30 degrees.
Scene<2> make_o1()
{
  std::vector<Expression<2>> moduli;
  for (const char *modulus : {"4", "1.2", "0.5", "0.6"})
    moduli.emplace_back(modulus, Constants(), "O1");
  const double c13 = 7.4 * std::sqrt(3.) / 16., c23 = 3.8 * std::sqrt(3.) / 16.;
  LiftFamily family = contact_of_a1();
  family.C = {{{{2.9625, 0.8375, c13}}, {{0.8375, 1.5625, c23}}, {{c13, c23, 0.9375}}}};
  return make_lift_scene(family, make_orthotropic(moduli, 30.));
}

// V1: lambda = mu = m(x,y) = 1 + sin(2x+y)/2.
Scene<2> make_v1()
{
  LiftFamily family = contact_of_a1();
  family.modulus = [](const dealii::Point<2> &x) {
    const double phase = 2. * x[0] + x[1];
    return Modulus{1. + 0.5 * std::sin(phase), std::cos(phase), 0.5 * std::cos(phase)};
  };
  return make_lift_scene(family,
                         make_isotropic<2>(Expression<2>("2.5*(1+0.5*sin(2*x+y))", {}, "V1"),
                                           Expression<2>("0.25", {}, "V1"),
                                           PlaneState::strain));
}
} // namespace Signorini
