// SPDX-License-Identifier: LGPL-2.1-or-later
// What is known about a level when it is finished.

#include <signorini/output/level_record.h>

#include <algorithm>

namespace Signorini
{
std::optional<double> LevelRecord::effectivity() const
{
  if (!estimated_h1 || !u_h1 || *u_h1 == 0.)
    return {};
  return *estimated_h1 / *u_h1;
}

double certificate_bound(const double tolerance)
{
  // Direct solves and sums over all cells lose some digits of their own.
  return std::max(1e-8, 100. * tolerance);
}

bool LevelRecord::is_certified(const double tolerance) const
{
  return converged && kkt <= tolerance && certificate.worst() <= certificate_bound(tolerance);
}
} // namespace Signorini
