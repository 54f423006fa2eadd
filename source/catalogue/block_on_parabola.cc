// SPDX-License-Identifier: LGPL-2.1-or-later
// A block (-1,1) x (0,1), E = 1, nu = 0.3, plane strain, lowered by 0.05 onto a foundation that
// falls away from its top as x^2/(2 R), R = 2.

#include <signorini/scene/functions.h>

#include "catalogue_scenes.h"

namespace Signorini
{
Scene<2> make_block_on_parabola()
{
  const auto function = [](const std::vector<std::string> &components) {
    std::vector<Expression<2>> values;
    for (const std::string &component : components)
      values.emplace_back(component, Constants(), "block on parabola");
    return std::make_shared<ExpressionFunction<2>>(values, std::vector<Expression<2>>(), 1e-4);
  };
  Scene<2> scene;
  scene.geometry = make_rectangle({-1., 0.}, {1., 1.}, {2, 1});
  scene.boundary.resize(scene.geometry.sides.size());
  scene.boundary[scene.geometry.find_side("top")] = {
    Role::displacement, function({"0", "-0.05"}), nullptr};
  scene.boundary[scene.geometry.find_side("bottom")] = {
    Role::contact, function({"x^2/4"}), nullptr};
  scene.material = make_isotropic<2>(Expression<2>("1", {}, "block on parabola"),
                                     Expression<2>("0.3", {}, "block on parabola"),
                                     PlaneState::strain);
  return scene;
}
} // namespace Signorini
