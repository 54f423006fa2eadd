// SPDX-License-Identifier: LGPL-2.1-or-later
// Problem (1): a body, its supports, its loads and its foundation.

#include <signorini/base/instantiate.h>
#include <signorini/problem/scene/scene.h>

#include <algorithm>
#include <map>

namespace Signorini {
std::string word_for(const Role role) {
  static const std::map<Role, std::string> words = {
    {Role::free, "free"},         {Role::clamped, "clamped"},
    {Role::roller, "rollers"},    {Role::displacement, "displacement"},
    {Role::traction, "traction"}, {Role::contact, "contact"}};
  return words.at(role);
}

template <int dim>
bool Scene<dim>::has_pairs() const {
  return std::any_of(contacts.begin(), contacts.end(),
                     [](const auto &contact) { return contact.opposite.has_value(); });
}

template <int dim>
std::vector<unsigned int> Scene<dim>::given_patches() const {
  std::vector<unsigned int> n;
  for (const ContactCondition<dim> &contact : contacts)
    n.push_back(contact.n_patches);
  return n;
}

template <int dim>
bool Scene<dim>::has_contact_on(const unsigned int side) const {
  return std::any_of(contacts.begin(), contacts.end(),
                     [side](const auto &contact) { return contact.side == side; });
}

template <int dim>
bool Scene<dim>::has_exact_pressure() const {
  return std::none_of(contacts.begin(), contacts.end(),
                      [](const auto &contact) { return contact.exact_pressure == nullptr; });
}

template <int dim>
Scene<dim> with_plates_moved(Scene<dim> scene, const std::vector<PlateMotion<dim>> &motions) {
  AssertDimension(motions.size(), scene.plates.size());
  for (std::size_t p = 0; p < scene.plates.size(); ++p)
    scene.boundary[scene.plates[p].side].data = plate_displacement(scene.plates[p], motions[p]);
  return scene;
}

template <int dim>
Scene<dim> with_only_plates_moved(Scene<dim> scene, const std::vector<PlateMotion<dim>> &motions) {
  for (BoundaryCondition<dim> &condition : scene.boundary)
    if (condition.role == Role::displacement)
      condition.data = std::make_shared<const Functions::ZeroFunction<dim>>(dim);
  return with_plates_moved(std::move(scene), motions);
}

INSTANTIATE_FUNCTION(with_only_plates_moved);
INSTANTIATE_FUNCTION(with_plates_moved);
template struct Scene<2>;
template struct Scene<3>;

} // namespace Signorini
