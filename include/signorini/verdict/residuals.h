// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/record/level_record.h>

namespace Signorini
{
/** The largest of the residuals that must vanish; not a number if one of them is not. */
double largest_residual(const Certificate &certificate);

/** The relative change of U or of its forces by rounding, the larger of both. */
double rounding(const LevelRecord &level);
} // namespace Signorini
