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

/** One line per scene: name and title. */
std::string describe_catalogue();
} // namespace Signorini
