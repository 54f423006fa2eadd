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

template struct Scene<2>;
template struct Scene<3>;
} // namespace Signorini
