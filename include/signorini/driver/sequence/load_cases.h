// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/driver/level/level.h>

#include <functional>
#include <vector>

namespace Signorini
{
/** The fields of a load case: its number from one on, its scene, U and P. */
using CaseFields =
  std::function<void(unsigned int, const Scene<2> &, const Displacement &, const Pressure &)>;

/**
 * Solves the load cases of the scene on a level that is solved, and adds the summary to the record.
 * The factors of the level are let go. Collective.
 * @param use_fields is called for the cases whose fields are asked for, as they are solved.
 */
std::vector<CaseResult> solve_load_cases(const LevelProblem<2> &problem,
                                         LevelResult<2> &level,
                                         const CaseFields &use_fields,
                                         const Progress &progress);
} // namespace Signorini
