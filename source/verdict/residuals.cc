// SPDX-License-Identifier: LGPL-2.1-or-later
// The two numbers of a level that are compared with bounds.

#include <signorini/verdict/residuals.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
Residual largest_residual(const Certificate &certificate)
{
  using Origin = Residual::Origin;
  const Certificate &c = certificate;
  Residual largest;
  for (const Residual &residual :
       {Residual{c.stationarity, "stationarity", Origin::equilibrium},
        Residual{c.penetration, "penetration", Origin::contact},
        Residual{c.sign, "sign", Origin::contact},
        Residual{c.support, "support", Origin::supports},
        Residual{c.complementarity, "complementarity", Origin::contact},
        Residual{c.duality_gap, "duality_gap", Origin::contact},
        Residual{c.force_balance, "force_balance", Origin::equilibrium},
        Residual{c.motion_balance, "motion_balance", Origin::equilibrium},
        Residual{
          c.moments_are_exact ? c.moment_balance : 0., "moment_balance", Origin::equilibrium}})
  {
    if (std::isnan(residual.value))
      return residual;
    if (residual.value > largest.value)
      largest = residual;
  }
  return largest;
}

double rounding(const LevelRecord &level)
{
  return std::max(level.linear.rounding_error, level.certificate.rounding);
}
} // namespace Signorini
