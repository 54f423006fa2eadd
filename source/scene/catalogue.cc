// SPDX-License-Identifier: LGPL-2.1-or-later
// The list of scenes known by name.

#include <signorini/scene/catalogue.h>

#include <iomanip>
#include <sstream>

#include "catalogue_scenes.h"

namespace Signorini
{
const std::vector<CatalogueEntry> &catalogue()
{
  static const std::vector<CatalogueEntry> entries = {
    {"A1", "smooth manufactured contact on half of a side, exact solution known", make_a1},
    {"D1", "patch test: constant strain under full contact, exact on every mesh", make_patch_test},
    {"block on parabola",
     "elastic block pressed on a parabolic foundation, no exact solution",
     make_block_on_parabola}};
  return entries;
}

std::string describe_catalogue()
{
  std::ostringstream text;
  text << std::left << std::setw(20) << "described"
       << "everything by the expressions of the parameter file\n";
  for (const CatalogueEntry &entry : catalogue())
    text << std::setw(20) << entry.name << entry.title << "\n";
  return text.str();
}
} // namespace Signorini
