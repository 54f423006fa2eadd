// SPDX-License-Identifier: LGPL-2.1-or-later
// Numbers of the answer over the levels.

#include "answer_trends.h"

namespace Signorini
{
std::vector<std::optional<double>> peak_pressures(const std::vector<LevelRecord> &levels)
{
  std::vector<std::optional<double>> values;
  for (const LevelRecord &level : levels)
    values.push_back(level.answer.peak_pressure
                       ? std::optional<double>(level.answer.peak_pressure->value)
                       : std::nullopt);
  return values;
}

std::vector<std::optional<double>> von_mises_stresses(const std::vector<LevelRecord> &levels)
{
  std::vector<std::optional<double>> values;
  for (const LevelRecord &level : levels)
    values.emplace_back(level.answer.von_mises.value);
  return values;
}
} // namespace Signorini
