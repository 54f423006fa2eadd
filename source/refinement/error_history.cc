// SPDX-License-Identifier: LGPL-2.1-or-later
// What steps predict for the next one.

#include <signorini/refinement/error_history.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
double ErrorHistory::add(const double indicator,
                         const std::optional<double> &difference,
                         const double planned)
{
  constexpr double safety = 4. / 3.;
  double estimate = indicator;
  if (difference && last_indicator_)
  {
    const double of_indicators = *last_indicator_ > 0. ? indicator / *last_indicator_ : 1.;
    double ratio = std::max(of_indicators, planned);
    if (last_difference_ && *last_difference_ > 0.)
      ratio = std::max(ratio, std::min(*difference / *last_difference_, 4. * of_indicators));
    estimate = std::max(estimate, *difference * std::min(1., ratio));
  }
  last_indicator_ = indicator;
  last_difference_ = difference;
  estimates_.push_back(safety * estimate);
  return estimates_.back();
}

bool ErrorHistory::stagnates() const
{
  if (!estimates_.empty() && !std::isfinite(estimates_.back()))
    return true;
  // The first steps see more and more of what the scene holds.
  constexpr std::size_t patience = 8, n_compared = 4;
  return estimates_.size() > patience &&
         estimates_.back() > 0.5 * estimates_[estimates_.size() - 1 - n_compared];
}
} // namespace Signorini
