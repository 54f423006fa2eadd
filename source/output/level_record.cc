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

namespace
{
constexpr const char *causes_of_rounding = "the stiffness matrix is ill-conditioned: Poisson's "
                                           "ratio near 1/2, moduli of very different size, "
                                           "or a very slender body.";
} // namespace

double LevelRecord::rounding() const
{
  return std::max(rounding_error, certificate.rounding);
}

double LevelRecord::residual_bound(const double tolerance) const
{
  // A residual is a difference of terms that are larger than itself; five digits are asked for.
  constexpr double largest_bound = 1e-5;
  const double of_rounding = std::min(100. * rounding(), largest_bound);
  // Direct solves and sums over all cells lose some digits of their own.
  return std::max({1e-8, 100. * tolerance, of_rounding});
}

std::string LevelRecord::doubt(const double tolerance) const
{
  // With less than six digits of U left, nothing that is computed from it can be trusted.
  constexpr double largest_rounding_error = 1e-6;
  const double residual = certificate.worst();
  std::ostringstream text;
  if (!std::isfinite(residual) || !std::isfinite(kkt))
    text << "numbers overflow: choose units in which moduli, lengths and loads are of size one.";
  else if (!(rounding() <= largest_rounding_error))
    text << "rounding spoils displacements or forces by the part " << rounding()
         << " (allowed: 1e-6), because " << causes_of_rounding;
  else if (!(converged && kkt <= tolerance))
    text << "the contact solver stopped after " << qp_iterations
         << " iterations with the KKT residual " << kkt << ", above the tolerance " << tolerance
         << ": raise Maximum iterations, take a Relaxation between 1 and 1.2, or the active set.";
  else if (!(residual <= residual_bound(tolerance)))
  {
    text << "the largest residual of the certificate is " << residual << ", above "
         << residual_bound(tolerance);
    if (rounding() > 1e-10)
      text << "; rounding leaves no more, because " << causes_of_rounding;
    else
      text << ".";
  }
  return text.str();
}

double largest_residual_bound(const std::vector<LevelRecord> &levels, const double tolerance)
{
  double bound = LevelRecord().residual_bound(tolerance);
  for (const LevelRecord &level : levels)
    bound = std::max(bound, level.residual_bound(tolerance));
  return bound;
}
} // namespace Signorini
