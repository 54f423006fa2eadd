// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/scene/scene.h>

#include <string>
#include <vector>

namespace Signorini
{
/** One scene that the program knows by name. */
struct CatalogueEntry
{
  std::string name;
  std::string title;
  Scene<2> (*make)();
};

/** All scenes known by name; each is defined in a file of its own. */
const std::vector<CatalogueEntry> &catalogue();

/** Body, material, boundary, loads, gap and exact solution of a scene in lines of text: without
 * them nobody could tell from its results alone what was solved. @throws std::out_of_range if
 * catalogue() has no scene of this name. */
std::string describe_scene(const std::string &name);

/** One line per scene: name and title. */
std::string describe_catalogue();
} // namespace Signorini
