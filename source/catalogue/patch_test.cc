// SPDX-License-Identifier: LGPL-2.1-or-later
// D1: u = (0, eps (1-y)), eps = 0.125, p = -(lambda + 2 mu) eps = -0.375, gap -eps: exact to
// rounding on every mesh and every partition.

#include <signorini/scene/functions.h>

#include "catalogue_scenes.h"

namespace Signorini
{
namespace
{
FunctionPointer<2> constant(const std::vector<std::string> &components,
                            const std::vector<std::string> &gradients = {})
{
  std::vector<Expression<2>> values;
  for (const std::string &component : components)
    values.emplace_back(component, Constants(), "D1");
  std::vector<Expression<2>> slopes;
  for (const std::string &gradient : gradients)
    slopes.emplace_back(gradient, Constants(), "D1");
  return std::make_shared<ExpressionFunction<2>>(values, slopes, 1e-4);
}
} // namespace

Scene<2> make_patch_test()
{
  Scene<2> scene;
  scene.geometry = make_rectangle({0., 0.}, {1., 1.}, {1, 1});
  scene.boundary.resize(scene.geometry.sides.size());
  const auto side = [&](const char *name) -> BoundaryCondition<2> & {
    return scene.boundary[scene.geometry.find_side(name)];
  };
  side("left") = {Role::traction, constant({"0.125", "0"}), nullptr};
  side("right") = {Role::traction, constant({"-0.125", "0"}), nullptr};
  side("top").role = Role::clamped;
  side("bottom") = {Role::contact, constant({"-0.125"}), constant({"-0.375"})};
  scene.material = make_isotropic<2>(
    Expression<2>("2.5", {}, "D1"), Expression<2>("0.25", {}, "D1"), PlaneState::strain);
  scene.exact_displacement = constant({"0", "0.125*(1-y)"}, {"0", "0", "0", "-0.125"});
  return scene;
}
} // namespace Signorini
