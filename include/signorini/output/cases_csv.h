// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/load_cases/case_solver.h>

#include <ostream>
#include <vector>

namespace Signorini
{
/** cases.csv: one row per load case; numbers of a case without a solution are empty. */
void write_cases_csv(std::ostream &stream, const std::vector<CaseResult> &cases);
} // namespace Signorini
