// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace Signorini
{
/** How a number moves from level to level. */
struct Trend
{
  enum class Kind
  {
    /** There is no level before. */
    unknown,
    settled,
    /** It still changes, by more than refinement would let it if it converged. */
    not_settled,
    /** The mesh was not refined where the number comes from. */
    not_refined,
    /** The exact number is infinite. */
    unlimited
  };
  Kind kind = Kind::unknown;
  /** (v_L - v_{L-1})/|v_L|; empty where there is no level before or v_L vanishes. */
  std::optional<double> change;
};

/**
 * The trend of v_0, ..., v_L, levels without a value left out. Settled means: the last change is at
 * most 1 % of v_L; or it is at most 10 % and at most 3/4 of the change before. Convergence of order
 * one halves changes. Under a punch, at a facet or at a sharp corner stresses grow by a constant
 * factor or by a constant amount, and that never settles at 10 %.
 */
Trend trend_of(const std::vector<std::optional<double>> &values);

/** "settled", "not settled", "one level only", "not refined there" or "grows without limit". */
std::string word_for(Trend::Kind kind);
} // namespace Signorini
