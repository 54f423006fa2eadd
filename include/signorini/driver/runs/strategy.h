// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/problem/parameters/parameters.h>
#include <signorini/problem/scene/scene.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace Signorini {
/** What a run decides where its parameters leave it open. */
struct StrategyDecision {
  /** The decided entries, "Subsection/Parameter=value". */
  std::vector<std::string> overrides;
  /** "hp, since ..." for the user; empty where the parameters state a strategy
   * or levels. */
  std::string sentence;
  /** With pairs of bodies, the first and the last of nested levels where none is stated. */
  std::optional<std::array<unsigned int, 2>> levels;
};

/**
 * Decides Strategy = automatic, and with hp a Coarsest level that is not given. Meshes are nested
 * where levels are given, where the exact solution is known, which shows orders, where an entry is
 * given that has no meaning with hp, with pairs and in space; else they are graded. The levels of
 * pairs follow from the number of cells: meshes from files have many on level 0.
 */
template <int dim>
StrategyDecision decide_strategy(const Parameters &parameters, const Scene<dim> &scene);
} // namespace Signorini
