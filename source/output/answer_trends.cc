// SPDX-License-Identifier: LGPL-2.1-or-later
// Numbers of the answer over the levels.

#include "answer_trends.h"

namespace Signorini
{
std::vector<std::optional<double>> over_levels(const std::vector<LevelRecord> &levels,
                                               const std::string &column)
{
  std::vector<std::optional<double>> values;
  for (const LevelRecord &level : levels)
    values.push_back(value(level, column));
  return values;
}

double total_seconds(const std::vector<LevelRecord> &levels)
{
  double seconds = 0.;
  for (const LevelRecord &level : levels)
    seconds += level.times.total();
  return seconds;
}
} // namespace Signorini
