// SPDX-License-Identifier: LGPL-2.1-or-later
// What is judged, in which order, and against which bound.

#include <signorini/verdict/accuracy.h>
#include <signorini/verdict/judge.h>
#include <signorini/verdict/residuals.h>

#include <algorithm>

#include "checks.h"

namespace Signorini
{
namespace
{
template <typename Subject>
using Check = std::string (*)(const Subject &, const Judge &);

/** The first one that fails names the cause: a later one may fail for the same reason. */
constexpr Check<LevelRecord> level_checks[] = {check_overflow,
                                               check_rounding,
                                               check_dual_problem,
                                               check_load_cases,
                                               check_residuals};
constexpr Check<std::vector<LevelRecord>> equation_checks[] = {check_finest_level,
                                                               check_uniqueness,
                                                               check_brackets};
constexpr Check<std::vector<LevelRecord>> accuracy_checks[] = {check_locking,
                                                               check_error,
                                                               check_energy,
                                                               check_estimate,
                                                               check_target};

template <typename Checks, typename Subject>
std::string first_objection(const Checks &checks, const Subject &subject, const Judge &judge)
{
  for (const auto check : checks)
  {
    std::string objection = check(subject, judge);
    if (!objection.empty())
      return objection;
  }
  return "";
}
} // namespace

const char *word_for(const Outcome outcome)
{
  switch (outcome)
  {
  case Outcome::unfinished:
    return "unfinished";
  case Outcome::certified:
    return "certified";
  case Outcome::equations_certified:
    return "equations certified";
  case Outcome::accuracy_estimated:
    return "equations certified, accuracy estimated";
  case Outcome::not_resolved:
    return "not resolved";
  default:
    return "not certified";
  }
}

Judge::Judge(const Demands &demands)
  : demands_(demands)
{
}

bool Judge::reaches_target(const LevelRecord &level) const
{
  const std::optional<double> error = relative_error(level);
  return error && *error < demands_.target_error;
}

double Judge::residual_bound(const LevelRecord &level) const
{
  // A residual is a difference of terms that are larger than itself; five digits are asked for.
  constexpr double largest_bound = 1e-5;
  const double of_rounding = std::min(100. * rounding(level), largest_bound);
  // Direct solves and sums over all cells lose some digits of their own, and so do other measures
  // of contact than the KKT residual. No tolerance makes an imbalance of one per cent a balance.
  const double of_tolerance = std::min(100. * demands_.tolerance, 0.01);
  // V-cycles that end at the error of the discretisation leave that much in the forces of nodes.
  const double of_cycles = 10. * level.dual.energy_tolerance;
  return std::max({1e-8, of_tolerance, of_rounding, of_cycles});
}

double Judge::largest_residual_bound(const std::vector<LevelRecord> &levels) const
{
  double bound = residual_bound(LevelRecord());
  for (const LevelRecord &level : levels)
    bound = std::max(bound, residual_bound(level));
  return bound;
}

std::string Judge::doubt(const LevelRecord &level) const
{
  return first_objection(level_checks, level, *this);
}

StudyVerdict Judge::verdict(const std::vector<LevelRecord> &levels) const
{
  if (levels.empty())
    return failed(levels, "No level has been solved.");
  const std::string objection = first_objection(equation_checks, levels, *this);
  if (!objection.empty())
    return failed(levels, objection);
  std::string doubt = first_objection(accuracy_checks, levels, *this);
  if (!doubt.empty() && demands_.can_be_graded && !levels.back().sizes.is_graded())
    doubt += " Or set Discretization/Strategy = hp, which finds a mesh by itself.";
  const Outcome outcome = !doubt.empty()                    ? Outcome::not_resolved
                          : is_guaranteed(levels.back())    ? Outcome::certified
                          : levels.back().sizes.is_graded() ? Outcome::accuracy_estimated
                                                            : Outcome::equations_certified;
  return {outcome, doubt, describe_accuracy(levels), largest_residual_bound(levels)};
}

StudyVerdict Judge::unfinished(const std::vector<LevelRecord> &levels) const
{
  return {Outcome::unfinished, "", "", largest_residual_bound(levels)};
}

StudyVerdict Judge::failed(const std::vector<LevelRecord> &levels, const std::string &reason) const
{
  return {Outcome::not_certified, reason, "", largest_residual_bound(levels)};
}
} // namespace Signorini
