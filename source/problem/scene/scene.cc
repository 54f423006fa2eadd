// SPDX-License-Identifier: LGPL-2.1-or-later
// Sides that move as rigid plates.

#include <signorini/base/instantiate.h>
#include <signorini/problem/scene/functions.h>
#include <signorini/problem/scene/scene.h>

#include <algorithm>
#include <functional>
#include <map>

namespace Signorini {
Tensor<1, 2> Plate::displacement(const PlateMotion &motion, const Point<2> &x) const {
  const Tensor<1, 2> arm = x - centre;
  return motion.travel * direction + motion.drift * across() +
         motion.rotation * Tensor<1, 2>({-arm[1], arm[0]});
}

std::shared_ptr<const Function<2>> plate_displacement(const Plate &plate,
                                                      const PlateMotion &motion) {
  // Who reads a constant knows that it is one.
  if (!plate.turns) {
    const Tensor<1, 2> u = plate.displacement(motion, plate.centre);
    return std::make_shared<Functions::ConstantFunction<2>>(std::vector<double>{u[0], u[1]});
  }
  return std::make_shared<FieldFunction<2>>(
    [plate, motion](const Point<2> &x) { return plate.displacement(motion, x); });
}

std::string word_for(const Role role) {
  static const std::map<Role, std::string> words = {
    {Role::free, "free"},         {Role::clamped, "clamped"},
    {Role::roller, "rollers"},    {Role::displacement, "displacement"},
    {Role::traction, "traction"}, {Role::contact, "contact"},
    {Role::opposite, "opposite"}};
  return words.at(role);
}

// Problem (1): a body, its supports, its loads and its foundation.

template <int dim>
std::vector<unsigned int> Scene<dim>::contact_sides() const {
  std::vector<unsigned int> numbers;
  for (unsigned int i = 0; i < boundary.size(); ++i)
    if (boundary[i].role == Role::contact)
      numbers.push_back(i);
  return numbers;
}

template <int dim>
bool Scene<dim>::has_pairs() const {
  return std::any_of(boundary.begin(), boundary.end(),
                     [](const auto &condition) { return condition.opposite.has_value(); });
}

template <int dim>
Tensor<1, dim> Scene<dim>::contact_direction(const unsigned int side, const Point<dim> &x) const {
  AssertIndexRange(side, boundary.size());
  const auto s = geometry.sides[side].coordinates(x);
  if constexpr (dim == 2)
    if (const auto m = boundary[side].directions.at(s[0]))
      return *m;
  return geometry.sides[side].normal(s);
}

template <int dim>
std::vector<unsigned int> Scene<dim>::given_patches() const {
  std::vector<unsigned int> n;
  for (const BoundaryCondition<dim> &condition : boundary)
    n.push_back(condition.n_patches);
  return n;
}

template <int dim>
bool Scene<dim>::has_exact_pressure() const {
  for (const unsigned int i : contact_sides())
    if (boundary[i].exact_pressure == nullptr)
      return false;
  return true;
}

template <int dim>
Scene<dim> with_plates_moved(Scene<dim> scene, const std::vector<PlateMotion> &motions) {
  AssertDimension(motions.size(), scene.plates.size());
  if constexpr (dim == 2)
    for (std::size_t p = 0; p < scene.plates.size(); ++p)
      scene.boundary[scene.plates[p].side].data = plate_displacement(scene.plates[p], motions[p]);
  return scene;
}

template <int dim>
Scene<dim> with_only_plates_moved(Scene<dim> scene, const std::vector<PlateMotion> &motions) {
  for (BoundaryCondition<dim> &condition : scene.boundary)
    if (condition.role == Role::displacement)
      condition.data = std::make_shared<const Functions::ZeroFunction<dim>>(dim);
  return with_plates_moved(std::move(scene), motions);
}

INSTANTIATE_FUNCTION(with_only_plates_moved);
INSTANTIATE_FUNCTION(with_plates_moved);
template struct Scene<2>;
template struct Scene<3>;

// Scenes with scaled loads and moved foundations.

namespace {
/** Returns the function factor f. */
FunctionPointer<2> scale(const FunctionPointer<2> &function, const double factor) {
  if (function == nullptr || factor == 1.)
    return function;
  std::vector<std::function<double(const Point<2> &)>> components;
  for (unsigned int c = 0; c < function->n_components; ++c)
    components.emplace_back([=](const Point<2> &x) { return factor * function->value(x, c); });
  return std::make_shared<FunctionFromFunctionObjects<2>>(components);
}

/** Returns the tangential motion of a foundation: @p given, and the part of a shift across the
 * direction of contact. */
FunctionPointer<2> slide_along(const Side<2> &side, const ContactDirections &directions,
                               const FunctionPointer<2> &given, const Tensor<1, 2> &shift) {
  return std::make_shared<ScalarFunctionFromFunctionObject<2>>([=](const Point<2> &x) {
    const double s = side.arc_length(x);
    const double along = -shift * cross_product_2d(directions.at(s).value_or(side.normal(s)));
    return along + (given == nullptr ? 0. : given->value(x));
  });
}
} // namespace

std::vector<Plate> plates_of_case(std::vector<Plate> plates, const LoadCase &load_case) {
  for (Plate &plate : plates) {
    plate.force *= load_case.force;
    plate.moment *= load_case.force;
    plate.cross_force *= load_case.cross;
    plate.travel *= load_case.travel;
  }
  return plates;
}

Scene<2> scene_of_case(Scene<2> scene, const LoadCase &load_case) {
  scene.exact_displacement = nullptr;
  scene.body_force = scale(scene.body_force, load_case.weight);
  scene.plates = plates_of_case(std::move(scene.plates), load_case);
  scene.foundation_position += load_case.shift();
  for (unsigned int i = 0; i < scene.boundary.size(); ++i) {
    BoundaryCondition<2> &condition = scene.boundary[i];
    condition.exact_pressure = condition.exact_friction = nullptr;
    if (condition.role == Role::traction)
      condition.data = scale(condition.data, load_case.force);
    if (condition.role == Role::displacement)
      condition.data = scale(condition.data, load_case.travel);
    if (condition.role == Role::contact) {
      if (condition.foundation != nullptr && load_case.shift().norm() > 0.)
        condition.data = foundation_gap(scene.geometry.sides[i], condition.foundation,
                                        scene.foundation_position, condition.directions);
      condition.data = scale(condition.data, load_case.gap);
      condition.shift = scale(condition.shift, load_case.slide);
      if (scene.friction != Friction::none && load_case.shift().norm() > 0.)
        condition.shift = slide_along(scene.geometry.sides[i], condition.directions,
                                      condition.shift, load_case.shift());
    }
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
    {"shift y", &LoadCase::shift_y, {}, ""}};
  return factors;
}

Scene<2> with_only(Scene<2> scene, const LoadKind kind) {
  LoadCase only;
  for (const CaseFactor &factor : case_factors())
    if (factor.kind)
      only.*factor.number = *factor.kind == kind ? 1. : 0.;
  return scene_of_case(std::move(scene), only);
}

bool has_load(const Scene<2> &scene, const LoadKind kind) {
  if (kind == LoadKind::weight)
    return scene.body_force != nullptr;
  if (kind == LoadKind::cross)
    return std::any_of(scene.plates.begin(), scene.plates.end(),
                       [](const Plate &plate) { return plate.drifts; });
  const Role role = kind == LoadKind::force ? Role::traction : Role::displacement;
  const bool on_sides = std::any_of(scene.boundary.begin(), scene.boundary.end(),
                                    [&](const auto &condition) { return condition.role == role; });
  return on_sides || (kind == LoadKind::force && !scene.plates.empty());
}
} // namespace Signorini
