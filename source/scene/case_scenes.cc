// SPDX-License-Identifier: LGPL-2.1-or-later
// Scenes with scaled loads and moved foundations.

#include <signorini/scene/case_scenes.h>

#include <algorithm>

namespace Signorini
{
namespace
{
/** factor f. */
class ScaledFunction final : public dealii::Function<2>
{
public:
  ScaledFunction(FunctionPointer<2> function, const double factor)
    : dealii::Function<2>(function->n_components)
    , function_(std::move(function))
    , factor_(factor)
  {
  }

  double value(const dealii::Point<2> &x, const unsigned int component) const override
  {
    return factor_ * function_->value(x, component);
  }
  void vector_value(const dealii::Point<2> &x, dealii::Vector<double> &values) const override
  {
    function_->vector_value(x, values);
    values *= factor_;
  }
  void value_list(const std::vector<dealii::Point<2>> &points,
                  std::vector<double> &values,
                  const unsigned int component) const override
  {
    function_->value_list(points, values, component);
    for (double &value : values)
      value *= factor_;
  }
  void vector_value_list(const std::vector<dealii::Point<2>> &points,
                         std::vector<dealii::Vector<double>> &values) const override
  {
    function_->vector_value_list(points, values);
    for (dealii::Vector<double> &value : values)
      value *= factor_;
  }

private:
  FunctionPointer<2> function_;
  double factor_;
};

FunctionPointer<2> scale(const FunctionPointer<2> &function, const double factor)
{
  if (function == nullptr || factor == 1.)
    return function;
  return std::make_shared<ScaledFunction>(function, factor);
}
} // namespace

std::vector<Plate> plates_of_case(std::vector<Plate> plates, const LoadCase &load_case)
{
  for (Plate &plate : plates)
  {
    plate.force *= load_case.force;
    plate.moment *= load_case.force;
    plate.travel *= load_case.travel;
  }
  return plates;
}

Scene<2> scene_of_case(Scene<2> scene, const LoadCase &load_case)
{
  scene.exact_displacement = nullptr;
  scene.body_force = scale(scene.body_force, load_case.weight);
  scene.plates = plates_of_case(std::move(scene.plates), load_case);
  scene.foundation_position += load_case.shift;
  for (unsigned int i = 0; i < scene.boundary.size(); ++i)
  {
    BoundaryCondition<2> &condition = scene.boundary[i];
    condition.exact_pressure = nullptr;
    if (condition.role == Role::traction)
      condition.data = scale(condition.data, load_case.force);
    if (condition.role == Role::displacement)
      condition.data = scale(condition.data, load_case.travel);
    if (condition.role == Role::contact)
    {
      if (condition.foundation != nullptr && load_case.shift.norm() > 0.)
        condition.data =
          foundation_gap(scene.geometry.sides[i], condition.foundation, scene.foundation_position);
      condition.data = scale(condition.data, load_case.gap);
    }
  }
  return scene;
}

Scene<2> with_only(Scene<2> scene, const LoadKind kind)
{
  return scene_of_case(std::move(scene),
                       {kind == LoadKind::force ? 1. : 0.,
                        kind == LoadKind::weight ? 1. : 0.,
                        kind == LoadKind::travel ? 1. : 0.,
                        1.,
                        {},
                        false});
}

bool has_load(const Scene<2> &scene, const LoadKind kind)
{
  if (kind == LoadKind::weight)
    return scene.body_force != nullptr;
  const Role role = kind == LoadKind::force ? Role::traction : Role::displacement;
  const bool on_sides = std::any_of(scene.boundary.begin(),
                                    scene.boundary.end(),
                                    [&](const auto &condition) { return condition.role == role; });
  return on_sides || (kind == LoadKind::force && !scene.plates.empty());
}
} // namespace Signorini
