// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/driver/level/level.h>

#include "results_writer.h"

namespace Signorini
{
/** Solves the load cases of the scene on a level that is solved, writes cases.csv and the fields of
 * the cases that are listed, and adds the summary to the record. Collective. */
void solve_load_cases(const Parameters &parameters,
                      const Scene<2> &scene,
                      const Discretization<2> &discretization,
                      const Progress &progress,
                      ResultsWriter &writer,
                      LevelSolution<2> &solution);
} // namespace Signorini
