// SPDX-License-Identifier: LGPL-2.1-or-later
// Scenes with scaled loads and moved foundations.

#include <signorini/base/instantiate.h>
#include <signorini/problem/scene/functions.h>
#include <signorini/problem/scene/load_case.h>
#include <signorini/problem/scene/scene.h>

#include <algorithm>
#include <functional>

namespace Signorini {
namespace {
/** Returns the function factor f. */
template <int dim>
FunctionPointer<dim> scale(const FunctionPointer<dim> &function, const double factor) {
  if (function == nullptr || factor == 1.)
    return function;
  std::vector<std::function<double(const Point<dim> &)>> components;
  for (unsigned int c = 0; c < function->n_components; ++c)
    components.emplace_back([=](const Point<dim> &x) { return factor * function->value(x, c); });
  return std::make_shared<FunctionFromFunctionObjects<dim>>(components);
}

/** Returns the tangential motion of a foundation: @p given, and the part of a shift across the
 * direction of contact. */
FunctionPointer<2> slide_along(const Side<2> &side, const ContactDirections<2> &directions,
                               const FunctionPointer<2> &given, const Tensor<1, 2> &shift) {
  return std::make_shared<ScalarFunctionFromFunctionObject<2>>([=](const Point<2> &x) {
    const double s = side.arc_length(x);
    const double along = -shift * cross_product_2d(directions.at(s, x, side.normal(s)));
    return along + (given == nullptr ? 0. : given->value(x));
  });
}

/** In space the tangential part of the whole motion counts. */
FunctionPointer<3> slide_along(const Side<3> & /*side*/,
                               const ContactDirections<3> & /*directions*/,
                               const FunctionPointer<3> &given, const Tensor<1, 3> &shift) {
  return std::make_shared<FieldFunction<3>>([=](const Point<3> &x) {
    Tensor<1, 3> along = shift;
    for (unsigned int c = 0; c < 3 && given != nullptr; ++c)
      along[c] += given->value(x, c);
    return along;
  });
}

/** Moves the foundation of a contact. */
template <int dim>
void move_foundation(const Scene<dim> &scene, ContactCondition<dim> &contact,
                     const Tensor<1, dim> &shift) {
  const Side<dim> &side = scene.geometry.sides[contact.side];
  if (contact.foundation != nullptr)
    contact.gap =
      foundation_gap<dim>(side, contact.foundation, scene.foundation_position, contact.directions);
  if (scene.contact_law.has_tangential_part())
    contact.shift = slide_along(side, contact.directions, contact.shift, shift);
}
} // namespace

template <int dim>
std::vector<Plate<dim>> plates_of_case(std::vector<Plate<dim>> plates, const LoadCase &load_case) {
  for (Plate<dim> &plate : plates) {
    plate.force *= load_case.force;
    plate.moment *= load_case.force;
    plate.cross_force *= load_case.cross;
    plate.travel *= load_case.travel;
  }
  return plates;
}

template <int dim>
Scene<dim> scene_of_case(Scene<dim> scene, const LoadCase &load_case) {
  scene.exact_displacement = nullptr;
  scene.body_force = scale(scene.body_force, load_case.weight);
  scene.plates = plates_of_case(std::move(scene.plates), load_case);
  scene.foundation_position += load_case.shift<dim>();
  for (BoundaryCondition<dim> &condition : scene.boundary) {
    if (condition.role == Role::traction)
      condition.data = scale(condition.data, load_case.force);
    if (condition.role == Role::displacement)
      condition.data = scale(condition.data, load_case.travel);
  }
  for (ContactCondition<dim> &contact : scene.contacts) {
    contact.exact_pressure = contact.exact_tangential = nullptr;
    contact.shift = scale(contact.shift, load_case.slide);
    if (const Tensor<1, dim> shift = load_case.shift<dim>(); shift.norm() > 0.)
      move_foundation(scene, contact, shift);
    contact.gap = scale(contact.gap, load_case.gap);
  }
  return scene;
}

const std::vector<CaseFactor> &case_factors() {
  static const std::vector<CaseFactor> factors = {
    {"force", &LoadCase::force, LoadKind::force, "neither tractions nor plates with a force"},
    {"weight", &LoadCase::weight, LoadKind::weight, "no body force"},
    {"travel", &LoadCase::travel, LoadKind::travel, "no prescribed displacement"},
    {"gap", &LoadCase::gap, {}, ""},
    {"slide", &LoadCase::slide, {}, "no Contact/Foundation shift"},
    {"cross", &LoadCase::cross, LoadKind::cross, "no Load/Plate cross force"},
    {"shift x", &LoadCase::shift_x, {}, ""},
    {"shift y", &LoadCase::shift_y, {}, ""},
    // In space alone.
    {"shift z", &LoadCase::shift_z, {}, ""}};
  return factors;
}

template <int dim>
Scene<dim> with_only(Scene<dim> scene, const LoadKind kind) {
  LoadCase only;
  for (const CaseFactor &factor : case_factors())
    if (factor.kind)
      only.*factor.number = *factor.kind == kind ? 1. : 0.;
  return scene_of_case(std::move(scene), only);
}

template <int dim>
bool has_load(const Scene<dim> &scene, const LoadKind kind) {
  if (kind == LoadKind::weight)
    return scene.body_force != nullptr;
  if (kind == LoadKind::cross)
    return std::any_of(scene.plates.begin(), scene.plates.end(),
                       [](const Plate<dim> &plate) { return plate.drifts; });
  const Role role = kind == LoadKind::force ? Role::traction : Role::displacement;
  const bool on_sides = std::any_of(scene.boundary.begin(), scene.boundary.end(),
                                    [&](const auto &condition) { return condition.role == role; });
  return on_sides || (kind == LoadKind::force && !scene.plates.empty());
}

INSTANTIATE_FUNCTION(plates_of_case);
INSTANTIATE_FUNCTION(scene_of_case);
INSTANTIATE_FUNCTION(with_only);
INSTANTIATE_FUNCTION(has_load);
} // namespace Signorini
