// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/record/level_record.h>

#include <optional>
#include <vector>

namespace Signorini
{
/** The peak pressure of every level, empty where nothing presses. */
std::vector<std::optional<double>> peak_pressures(const std::vector<LevelRecord> &levels);

/** The largest von Mises stress of every level. */
std::vector<std::optional<double>> von_mises_stresses(const std::vector<LevelRecord> &levels);
} // namespace Signorini
