// SPDX-License-Identifier: LGPL-2.1-or-later
// Problem (1): a body, what holds it, loads it and stops it.

#include <signorini/scene/scene.h>

namespace Signorini
{
template <int dim>
std::vector<unsigned int> Scene<dim>::contact_sides() const
{
  std::vector<unsigned int> numbers;
  for (unsigned int i = 0; i < boundary.size(); ++i)
    if (boundary[i].role == Role::contact)
      numbers.push_back(i);
  return numbers;
}

template <int dim>
bool Scene<dim>::has_exact_pressure() const
{
  for (const unsigned int i : contact_sides())
    if (boundary[i].exact_pressure == nullptr)
      return false;
  return true;
}

template <int dim>
Scene<dim> with_plates_moved(Scene<dim> scene, const std::vector<PlateMotion> &motions)
{
  if constexpr (dim == 2)
    for (std::size_t p = 0; p < scene.plates.size(); ++p)
      scene.boundary[scene.plates[p].side].data = plate_displacement(scene.plates[p], motions[p]);
  return scene;
}

template <int dim>
Scene<dim> with_only_plates_moved(Scene<dim> scene, const std::vector<PlateMotion> &motions)
{
  for (BoundaryCondition<dim> &condition : scene.boundary)
    if (condition.role == Role::displacement)
      condition.data = std::make_shared<const dealii::Functions::ZeroFunction<dim>>(dim);
  return with_plates_moved(std::move(scene), motions);
}

template Scene<2> with_only_plates_moved(Scene<2>, const std::vector<PlateMotion> &);
template Scene<3> with_only_plates_moved(Scene<3>, const std::vector<PlateMotion> &);
template Scene<2> with_plates_moved(Scene<2>, const std::vector<PlateMotion> &);
template Scene<3> with_plates_moved(Scene<3>, const std::vector<PlateMotion> &);
template struct Scene<2>;
template struct Scene<3>;
} // namespace Signorini
