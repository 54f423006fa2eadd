// SPDX-License-Identifier: LGPL-2.1-or-later
// What the screen and the verdict hear of load cases.

#include <signorini/record/case_summary.h>

#include <algorithm>

namespace Signorini
{
CaseSummary summarise(const std::vector<CaseResult> &cases, const double seconds)
{
  CaseSummary summary;
  summary.n_cases = cases.size();
  summary.seconds = seconds;
  for (std::size_t i = 0; i < cases.size(); ++i)
    if (!cases[i].escape.empty())
      ++summary.n_escapes;
    else
    {
      summary.largest_kkt = std::max(summary.largest_kkt, cases[i].kkt);
      if (!cases[i].converged && summary.first_failure == 0)
        summary.first_failure = i + 1;
    }
  return summary;
}
} // namespace Signorini
