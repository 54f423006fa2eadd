// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/problem/parameters/parameters.h>
#include <signorini/problem/scene/scene.h>

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
};

/**
 * Decides Strategy = automatic, and with hp a Coarsest level that is not given. Meshes are nested
 * where levels are given, where the exact solution is known, which shows orders, where an entry is
 * given that has no meaning with hp, and in space; else they are graded.
 */
template <int dim>
StrategyDecision decide_strategy(const Parameters &parameters, const Scene<dim> &scene);
} // namespace Signorini
