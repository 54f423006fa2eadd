// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>

namespace Signorini
{
/**
 * The estimated error of one step after the other, (force length)^{1/2}.
 *
 * The distance d_k between the solutions of steps k and k - 1 is about the error of step k - 1,
 * which is many times that of step k. By how much, the indicators eta and the distances tell:
 *
 *     estimate_k = max(eta_k, d_k max(eta_k/eta_{k-1}, d_k/d_{k-1})),
 *
 * with ratios of at most one. It is reliable as long as the error falls in step k as it fell
 * before, or as the indicator says.
 */
class ErrorHistory
{
public:
  /** @param difference d_k; empty for the first step. @return the estimate of the step. */
  double add(double indicator, const std::optional<double> &difference);

private:
  std::optional<double> last_indicator_, last_difference_;
};
} // namespace Signorini
