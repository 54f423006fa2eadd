// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/load_cases/case_solver.h>

#include <vector>

namespace Signorini
{
/** How the load cases of a level went. */
struct CaseSummary
{
  unsigned int n_cases = 0;
  /** Cases in which nothing stops the body. */
  unsigned int n_escapes = 0;
  /** The first case whose dual problem was not solved, from 1; 0: none. */
  unsigned int first_failure = 0;
  /** The largest KKT residual of a case with a solution. */
  double largest_kkt = 0.;
  /** Wall seconds of all cases. */
  double seconds = 0.;
};

CaseSummary summarise(const std::vector<CaseResult> &cases, double seconds);
} // namespace Signorini
