// SPDX-License-Identifier: LGPL-2.1-or-later
// Whether the answer of one level solves its equations.

#include <signorini/verdict/residuals.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "checks.h"

namespace Signorini
{
namespace
{
constexpr const char *causes_of_condition = "the stiffness matrix is ill-conditioned: Poisson's "
                                            "ratio near 1/2, moduli of very different size, "
                                            "or a very slender body.";

/** Beyond that, the translation of the body takes more digits than a usual matrix. */
constexpr double large_translation = 1e4;

std::string causes_of_rounding(const LevelRecord &level)
{
  const double translation = level.certificate.translation;
  if (translation < large_translation || level.certificate.rounding < level.linear.rounding_error)
    return causes_of_condition;
  std::ostringstream text;
  text << "the body is moved as a whole by " << translation
       << " times as much as it is deformed: subtract that translation from the prescribed "
          "displacements, and its normal component from the gap.";
  return text.str();
}

/** What has searched for contact. */
std::string name_of_method(const DualSolve &dual)
{
  if (dual.active_set_failure)
    return "projected SOR, which replaced the active set method,";
  if (dual.stalled)
    return "MINRES, which replaced V-cycles,";
  switch (dual.method)
  {
  case ContactSolver::psor:
    return "projected SOR";
  case ContactSolver::mprgp:
    return "MPRGP";
  case ContactSolver::multigrid:
    return "the V-cycles";
  default:
    return "the active set method";
  }
}

/** What else may find contact where that method does not. */
std::string other_method(const DualSolve &dual)
{
  if (dual.active_set_failure)
    return ", or take a larger Patch ratio";
  switch (dual.method)
  {
  case ContactSolver::psor:
    return ", take a Relaxation between 1 and 1.2, or Contact solver = active set";
  case ContactSolver::mprgp:
  case ContactSolver::multigrid:
    return ", or take Contact solver = active set";
  default:
    return ", or take Contact solver = psor";
  }
}

/** Why a residual is large that rounding does not explain. */
std::string cause_and_remedy(const Residual::Origin origin, const DualSolve &dual)
{
  const bool cycles = dual.method == ContactSolver::multigrid;
  switch (origin)
  {
  case Residual::Origin::supports:
    return "sides that meet prescribe different displacements: make them agree.";
  case Residual::Origin::contact:
    break;
  default:
    if (!cycles)
      return "the linear system is not solved well enough: take another Linear solver.";
  }
  return name_of_method(dual) + (cycles ? " end" : " ends") +
         " too early for it: take a smaller Tolerance" + other_method(dual) + ".";
}

/** With less than six digits of U left, nothing that is computed from it can be trusted. */
constexpr double largest_rounding = 1e-6;

/** Above this, rounding explains large residuals. */
constexpr double noticeable_rounding = 1e-10;
} // namespace

std::string check_overflow(const LevelRecord &level, const Judge &)
{
  if (std::isfinite(largest_residual(level.certificate).value) && std::isfinite(level.dual.kkt))
    return "";
  return "numbers overflow: choose units in which moduli, lengths and loads are of size one.";
}

std::string check_rounding(const LevelRecord &level, const Judge &)
{
  if (rounding(level) <= largest_rounding)
    return "";
  std::ostringstream text;
  text << "rounding changes displacements or forces by the relative amount " << rounding(level)
       << " (allowed: 1e-6), because " << causes_of_rounding(level);
  return text.str();
}

std::string check_dual_problem(const LevelRecord &level, const Judge &judge)
{
  const double tolerance = std::max(judge.tolerance(), 10. * level.dual.energy_tolerance);
  if (level.dual.converged && level.dual.kkt <= tolerance)
    return "";
  std::ostringstream text;
  text << name_of_method(level.dual) << " stopped after " << level.dual.iterations
       << " iterations with the KKT residual " << level.dual.kkt << ", above the tolerance "
       << tolerance << ": raise Tolerance or Maximum iterations" << other_method(level.dual) << ".";
  return text.str();
}

std::string check_load_cases(const LevelRecord &level, const Judge &)
{
  if (!level.load_cases || level.load_cases->first_failure == 0)
    return "";
  return "the contact solver stopped early in load case " +
         std::to_string(level.load_cases->first_failure) +
         " (cases.csv): raise Tolerance or Maximum iterations" + other_method(level.dual) + ".";
}

std::string check_residuals(const LevelRecord &level, const Judge &judge)
{
  const Residual residual = largest_residual(level.certificate);
  const double bound = judge.residual_bound(level);
  if (residual.value <= bound)
    return "";
  std::ostringstream text;
  text << "the residual " << residual.name << " of the certificate is " << residual.value
       << ", above " << bound << "; ";
  if (rounding(level) > noticeable_rounding && level.dual.method != ContactSolver::multigrid)
    text << "rounding leaves no more, because " << causes_of_rounding(level);
  else
    text << cause_and_remedy(residual.origin, level.dual);
  return text.str();
}
} // namespace Signorini
