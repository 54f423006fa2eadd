// SPDX-License-Identifier: LGPL-2.1-or-later
// Whether all levels are solved, and whether the finest one resolves the solution.

#include <algorithm>
#include <cmath>
#include <sstream>

#include "checks.h"

namespace Signorini
{
namespace
{
/** Above this locking_number() contact forces are wrong by ten per cent and more. */
constexpr double largest_locking_number = 0.25;

/** So many levels with the same estimate show that refinement does not help. */
constexpr std::size_t n_stagnant_levels = 3;
} // namespace

std::string check_levels(const std::vector<LevelRecord> &levels, const Judge &judge)
{
  for (const LevelRecord &level : levels)
  {
    const std::string doubt = judge.doubt(level);
    if (!doubt.empty())
      return "Level " + std::to_string(level.sizes.level) + ": " + doubt;
  }
  return "";
}

std::string check_uniqueness(const std::vector<LevelRecord> &levels, const Judge &)
{
  const LevelRecord &finest = levels.back();
  if (finest.dual.unique)
    return "";
  return "Level " + std::to_string(finest.sizes.level) +
         ": the contact pressure is not unique, because contact patches are finer than the mesh; "
         "take a Patch ratio of 2 or more, or fewer Patches.";
}

std::string check_locking(const std::vector<LevelRecord> &levels, const Judge &)
{
  const LevelRecord &finest = levels.back();
  if (finest.locking_number.value_or(0.) <= largest_locking_number)
    return "";
  std::ostringstream text;
  text << "The body is nearly incompressible, and bilinear elements lock on a mesh as coarse as "
          "level "
       << finest.sizes.level << ": K/mu (h/l)^2 = " << *finest.locking_number
       << ", allowed: at most " << largest_locking_number
       << "; set Discretization/Element = Q1 B-bar, or refine.";
  return text.str();
}

std::string check_estimate(const std::vector<LevelRecord> &levels, const Judge &)
{
  if (levels.size() < n_stagnant_levels)
    return "";
  // Solutions in V^h have estimates that are nothing but rounding.
  const double negligible = std::max(1e-8, 100. * levels.back().linear.rounding_error);
  const double slowest = std::pow(2., -0.1);
  const auto first = levels.end() - n_stagnant_levels;
  const bool all_matter = std::all_of(first, levels.end(), [&](const LevelRecord &level) {
    return level.estimate && !(level.estimate->relative < negligible);
  });
  const auto falls = [&](const LevelRecord &coarse, const LevelRecord &fine) {
    return fine.estimate->absolute < slowest * coarse.estimate->absolute;
  };
  if (!all_matter || std::adjacent_find(first, levels.end(), falls) != levels.end())
    return "";
  return "The estimated error does not fall from level to level, so that the mesh does not resolve "
         "the solution: refine, or take cells that are as wide as high (long cells are too stiff "
         "in bending).";
}
} // namespace Signorini
