// SPDX-License-Identifier: LGPL-2.1-or-later
// The two numbers of a level that are compared with bounds.

#include <signorini/verdict/residuals.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
double largest_residual(const Certificate &certificate)
{
  double largest = 0.;
  for (const double residual : {certificate.stationarity,
                                certificate.penetration,
                                certificate.sign,
                                certificate.support,
                                certificate.complementarity,
                                certificate.duality_gap,
                                certificate.force_balance,
                                certificate.motion_balance,
                                certificate.moments_are_exact ? certificate.moment_balance : 0.})
  {
    // For std::max a residual that is not a number would be a small one.
    if (std::isnan(residual))
      return residual;
    largest = std::max(largest, residual);
  }
  return largest;
}

double rounding(const LevelRecord &level)
{
  return std::max(level.linear.rounding_error, level.certificate.rounding);
}
} // namespace Signorini
