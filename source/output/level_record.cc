// SPDX-License-Identifier: LGPL-2.1-or-later
// What is known about a level when it is finished.

#include <signorini/output/level_record.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Signorini
{
std::optional<double> LevelRecord::effectivity() const
{
  if (!estimated_h1 || !u_h1 || *u_h1 == 0.)
    return {};
  return *estimated_h1 / *u_h1;
}

double LevelRecord::residual_bound(const double tolerance) const
{
  // Direct solves and sums over all cells lose some digits of their own.
  return std::max({1e-8, 100. * tolerance, 10. * rounding_error, 10. * certificate.rounding});
}

std::string LevelRecord::doubt(const double tolerance) const
{
  // With less than six digits of U left, nothing that is computed from it can be trusted.
  constexpr double largest_rounding_error = 1e-6;
  const double residual = certificate.worst();
  std::ostringstream text;
  if (!std::isfinite(residual) || !std::isfinite(kkt))
    text << "numbers overflow: choose units in which moduli, lengths and loads are of size one.";
  else if (!(std::max(rounding_error, certificate.rounding) <= largest_rounding_error))
    text << "rounding spoils displacements or forces by the part "
         << std::max(rounding_error, certificate.rounding)
         << " (allowed: 1e-6), because the stiffness matrix is ill-conditioned: Poisson's ratio "
            "near 1/2, moduli of very different size, or a very slender body.";
  else if (!(converged && kkt <= tolerance))
    text << "the contact solver stopped after " << qp_iterations
         << " iterations with the KKT residual " << kkt << ", above the tolerance " << tolerance
         << ": raise Maximum iterations, take a Relaxation between 1 and 1.2, or the active set.";
  else if (!(residual <= residual_bound(tolerance)))
    text << "the largest residual of the certificate is " << residual << ", above "
         << residual_bound(tolerance) << ".";
  return text.str();
}
} // namespace Signorini
