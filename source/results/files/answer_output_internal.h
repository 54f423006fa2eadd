// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/postprocessing/quantities/answer_vector.h>
#include <signorini/results/record/level_record.h>

#include <optional>
#include <string>
#include <vector>

namespace Signorini
{
/** The trends of a maximum over the levels, and of the maximum away from the place where it grows.
 */
struct MaximumTrends
{
  Trend largest, away;
};
MaximumTrends trends_of_peak(const std::vector<LevelRecord> &levels);
MaximumTrends trends_of_stress(const std::vector<LevelRecord> &levels);

/** Returns the wall seconds of all levels. */
double total_seconds(const std::vector<LevelRecord> &levels);
} // namespace Signorini
