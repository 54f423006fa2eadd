// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/problem/scene/scene.h>

#include <string>
#include <vector>

namespace Signorini
{
/** One scene that the program knows by name. */
template <int dim>
struct CatalogueEntry
{
  std::string name;
  std::string title;
  Scene<dim> (*make)();
};

/** All scenes of the plane or of space that are known by name. */
template <int dim>
const std::vector<CatalogueEntry<dim>> &catalogue();
template <>
const std::vector<CatalogueEntry<2>> &catalogue();
template <>
const std::vector<CatalogueEntry<3>> &catalogue();

/** Body, material, boundary, loads, gap and exact solution of a scene in lines of text: without
 * them nobody could tell from its results alone what was solved. @throws std::out_of_range if
 * catalogue() has no scene of this name. */
std::string describe_scene(const std::string &name);

/** One line per scene: name and title. */
std::string describe_catalogue();
} // namespace Signorini
