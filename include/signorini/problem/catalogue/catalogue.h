// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/problem/scene/scene.h>

#include <functional>
#include <string>
#include <vector>

namespace Signorini {
/** A scene with a name in the program. */
template <int dim>
struct CatalogueEntry {
  std::string name;
  std::string title;
  /** Body, material, boundary, loads, gap and exact solution in lines of text; the results alone do
   * not contain them. */
  std::string description;
  std::function<Scene<dim>()> make;
};

/** Returns all 2-D or 3-D scenes with a name. */
template <int dim>
const std::vector<CatalogueEntry<dim>> &catalogue();
template <>
const std::vector<CatalogueEntry<2>> &catalogue();
template <>
const std::vector<CatalogueEntry<3>> &catalogue();

/** Returns the scene CM, Hertz' pressure with stick and slip; or the state after some of the
 * tangential load is taken back, which follows the slip of CM (Mindlin and Deresiewicz). */
Scene<2> make_cattaneo_mindlin(bool unloaded);

/** Returns one line per scene: name and title. */
std::string describe_catalogue();
} // namespace Signorini
