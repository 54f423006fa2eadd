// SPDX-License-Identifier: LGPL-2.1-or-later
// A1: u2(x,0) = 0.1 x (1-x), u1(x,0) = 0.1 x^2, p = -10 (xi-x)_+^3, slack (x-xi)_+^2, xi =
// 1/sqrt(2), lambda = mu = 1 in plane strain; u in H^{7/2-eps}.

#include <deal.II/base/numbers.h>

#include <algorithm>

#include "catalogue_scenes.h"
#include "lift_family.h"

namespace Signorini
{
Scene<2> make_a1()
{
  constexpr double xi = dealii::numbers::SQRT1_2;
  LiftFamily family;
  family.U = [](const double x) {
    return Derivatives{0.1 * x * (1. - x), 0.1 - 0.2 * x, -0.2, 0.};
  };
  family.V = [](const double x) { return Derivatives{0.1 * x * x, 0.2 * x, 0.2, 0.}; };
  family.p = [](const double x)
  {
    const double d = std::max(xi - x, 0.);
    return Derivatives{-10. * d * d * d, 30. * d * d, -60. * d, 0.};
  };
  family.slack = [](const double x)
  {
    const double d = std::max(x - xi, 0.);
    return d * d;
  };
  family.C = {{{{3., 1., 0.}}, {{1., 3., 0.}}, {{0., 0., 1.}}}};
  Scene<2> scene = make_lift_scene(family);
  scene.material = make_isotropic<2>(
    Expression<2>("2.5", {}, "A1"), Expression<2>("0.25", {}, "A1"), PlaneState::strain);
  scene.kinks[0] = {xi};
  return scene;
}
} // namespace Signorini
