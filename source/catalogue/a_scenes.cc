// SPDX-License-Identifier: LGPL-2.1-or-later
// A1, A1L, A2: smooth manufactured contact, lambda = mu = 1, plane strain; u in H^{7/2-eps}.

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

#include "catalogue_scenes.h"
#include "lift_family.h"

namespace Signorini
{
namespace
{
constexpr double xi = dealii::numbers::SQRT1_2;
} // namespace

// A1: p = -10 (xi-x)_+^3, slack (x-xi)_+^2, xi = 1/sqrt(2).
Scene<2> make_a1()
{
  LiftFamily family;
  family.p = cubic_pressure(10., xi);
  family.slack = quadratic_slack(xi);
  family.kinks_at_x = {xi};
  return make_lift_scene(family, make_lame_material(1., 1.));
}

// A1L: as A1, but the gap has a kink, slack 0.3 (x-xi)_+.
Scene<2> make_a1l()
{
  LiftFamily family;
  family.p = cubic_pressure(10., xi);
  family.slack = [](const double x) { return 0.3 * std::max(x - xi, 0.); };
  family.kinks_at_x = {xi};
  return make_lift_scene(family, make_lame_material(1., 1.));
}

// A2: p = -2 q_+^3, q = sin(3 pi x + 1), slack 0.2 (-q)_+^2: three transitions.
Scene<2> make_a2()
{
  constexpr double omega = 3. * dealii::numbers::PI;
  LiftFamily family;
  family.p = [](const double x) {
    const double q = std::sin(omega * x + 1.), dq = omega * std::cos(omega * x + 1.);
    const auto p = cube_of_positive_part(-2., {q, dq, -omega * omega * q});
    return Derivatives{p[0], p[1], p[2], 0.};
  };
  family.slack = [](const double x) {
    const double q = std::max(-std::sin(omega * x + 1.), 0.);
    return 0.2 * q * q;
  };
  for (const double k : {1., 2., 3.})
    family.kinks_at_x.push_back((k - 1. / dealii::numbers::PI) / 3.);
  return make_lift_scene(family, make_lame_material(1., 1.));
}
} // namespace Signorini
