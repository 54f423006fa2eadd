// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/record/level_record.h>

#include <optional>
#include <string>
#include <vector>

namespace Signorini
{
/** The bound of the relative error of u_h in the energy norm, where there is one; on curved sides
 * it is an estimated bound. */
std::optional<double> bound_of(const LevelRecord &level);

/** Whether there is a bound that is guaranteed. */
bool is_guaranteed(const LevelRecord &level);

/** That bound, or else the estimated relative error in the energy norm. */
std::optional<double> relative_error(const LevelRecord &level);

/** What is known about the error of the finest level, half a sentence: its bound and its
 * estimate, or why there is no bound and whether the estimate was checked. */
std::string describe_accuracy(const std::vector<LevelRecord> &levels);
} // namespace Signorini
