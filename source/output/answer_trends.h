// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/record/level_record.h>

#include <optional>
#include <string>
#include <vector>

namespace Signorini
{
/** A column of convergence.csv, level by level; empty where it is not known. */
std::vector<std::optional<double>> over_levels(const std::vector<LevelRecord> &levels,
                                               const std::string &column);

/** Wall seconds of all levels. */
double total_seconds(const std::vector<LevelRecord> &levels);
} // namespace Signorini
