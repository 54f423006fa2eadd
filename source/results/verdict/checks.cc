// SPDX-License-Identifier: LGPL-2.1-or-later
// The checks of a study in their order: whether each level solves its equations, and whether the
// finest one resolves the solution.

#include <signorini/base/message.h>
#include <signorini/results/verdict/judge.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace Signorini {
namespace {
constexpr const char *causes_of_condition = "the stiffness matrix is ill-conditioned: Poisson's "
                                            "ratio near 1/2, moduli of very different size, "
                                            "or a very slender body.";

/** The ratio of translation to deformation beyond which the translation costs more digits than a
 * usual matrix. */
constexpr double large_translation = 1e4;

std::string causes_of_rounding(const LevelRecord &level) {
  const double translation = level.certificate.translation;
  if (translation < large_translation || level.certificate.rounding < level.linear.rounding_error)
    return causes_of_condition;
  return concatenate(
    "the body is moved as a whole by ", translation,
    " times as much as it is deformed: subtract that translation from the prescribed "
    "displacements, and its normal component from the gap.");
}

/** Returns the name of the method that has searched for contact. */
std::string name_of_method(const DualSolve &dual) {
  if (dual.active_set_failure)
    return "projected SOR, which replaced the active set method,";
  if (dual.stalled)
    return "MINRES, which replaced V-cycles,";
  switch (dual.method) {
  case ContactSolver::psor:
    return "projected SOR";
  case ContactSolver::multigrid:
    return "the V-cycles";
  default:
    return "the active set method";
  }
}

/** Returns other settings that may find contact where that method does not. */
std::string other_method(const DualSolve &dual) {
  if (dual.active_set_failure)
    return ", or take a larger Patch ratio";
  switch (dual.method) {
  case ContactSolver::psor:
    return ", take a Relaxation between 1 and 1.2, or Contact solver = active set";
  case ContactSolver::multigrid:
    return ", or take Contact solver = active set";
  default:
    return ", or take Contact solver = psor";
  }
}

/** Returns the cause of a large residual that rounding does not explain, and the remedy. */
std::string cause_and_remedy(const Residual::Origin origin, const DualSolve &dual) {
  const bool cycles = dual.method == ContactSolver::multigrid;
  switch (origin) {
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

/** The largest rounding: with less than six digits of U left, nothing that is computed from it can
 * be trusted. */
constexpr double max_rounding = 1e-6;

/** The rounding above which it explains large residuals. */
constexpr double noticeable_rounding = 1e-10;

/** Checks that no number is infinite or not a number. */
std::string check_overflow(const LevelRecord &level, const Judge &) {
  if (std::isfinite(max_residual(level.certificate).value) && std::isfinite(level.dual.kkt))
    return "";
  return "numbers overflow: choose units in which moduli, lengths and loads are of size one.";
}

/** Checks that rounding leaves at least six digits of U. */
std::string check_rounding(const LevelRecord &level, const Judge &) {
  if (rounding(level) <= max_rounding)
    return "";
  return concatenate("rounding changes displacements or forces by the relative amount ",
                     rounding(level), " (allowed: 1e-6), because ", causes_of_rounding(level));
}

/** Checks the KKT residual of the dual problem against the tolerance. */
std::string check_dual_problem(const LevelRecord &level, const Judge &judge) {
  const double tolerance = judge.demands.tolerance;
  if (level.dual.converged && level.dual.kkt <= tolerance)
    return "";
  std::ostringstream text;
  text << name_of_method(level.dual) << " stopped after " << level.dual.iterations
       << " iterations with the KKT residual " << level.dual.kkt << ", above the tolerance "
       << tolerance;
  constexpr double hopeless = 1e-4;
  if (level.tangential && level.dual.kkt > hopeless)
    text
      << ": it did not find where patches stick and slip, as happens with large coefficients of "
         "friction on fine meshes; take a smaller Friction coefficient, or a larger Target error "
         "or Tolerated error.";
  else
    text << ": raise Tolerance or Maximum iterations" << other_method(level.dual) << ".";
  return text.str();
}

/** Checks that the dual problem of every load case was solved. */
std::string check_load_cases(const LevelRecord &level, const Judge &) {
  if (!level.load_cases || level.load_cases->first_failure == 0)
    return "";
  return "the contact solver stopped early in load case " +
         std::to_string(level.load_cases->first_failure) +
         " (cases.csv): raise Tolerance or Maximum iterations" + other_method(level.dual) + ".";
}

/** Checks the residuals of the certificate against their bound. */
std::string check_residuals(const LevelRecord &level, const Judge &judge) {
  const Residual residual = max_residual(level.certificate);
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

/** The largest locking_number(): above it contact forces are wrong by ten per cent and more. */
constexpr double max_locking_number = 0.25;

/** The number of levels with the same estimate that shows that refinement does not help. */
constexpr std::size_t n_stagnant_levels = 3;

/** Returns where the error is largest, and the remedy. */
std::string remedy_for(const LevelRecord &level) {
  if (level.sizes.is_graded())
    return "take a Target error below Tolerated error, raise Maximum unknowns, or see where the "
           "mesh is finest (mesh-LL.svg, with Output/Pictures): data that contradict each other "
           "there have no solution.";
  constexpr const char *usual = "refine, or take cells that are as wide as high (long cells are "
                                "too stiff in bending).";
  // A distance has no parts.
  if (!level.bound || !level.bound->mesh) {
    const ErrorEstimate estimate = level.estimate.value_or(ErrorEstimate());
    const double algebra = estimate.algebra.value_or(0.), contact = estimate.contact.value_or(0.);
    const double largest =
      std::max({algebra, contact, estimate.mesh.value_or(0.), estimate.pressure.value_or(0.)});
    if (largest == 0. || largest > std::max(algebra, contact))
      return usual;
    return largest == algebra ? "the contact solver stops too early: take a smaller Tolerance."
                              : "contact is not resolved: refine, or take a smaller Patch ratio.";
  }
  const ErrorBound &bound = *level.bound;
  switch (bound.dominant_part()) {
  case ErrorBound::Part::contact:
    return "contact is not resolved on " + bound.worst_face +
           ": refine, take a smaller Patch ratio, or more Patches.";
  case ErrorBound::Part::oscillation:
    return "loads vary too much within cells, most in " + bound.largest_cell + ": refine.";
  default:
    return "the mesh is too coarse, most in " + bound.largest_cell + ": " + usual;
  }
}

/** Checks that the finest level is not in doubt. Coarser ones do not matter: it does not depend on
 * them. */
std::string check_finest_level(const std::vector<LevelRecord> &levels, const Judge &judge) {
  const LevelRecord &finest = levels.back();
  const std::string doubt = judge.doubt(finest);
  return doubt.empty() ? "" : "Level " + std::to_string(finest.sizes.level) + ": " + doubt;
}

/** Checks that the bound of the error on the finest level, or without one its estimate, is known
 * and tolerated, and a bound that is conditional, too. */
std::string check_error(const std::vector<LevelRecord> &levels, const Judge &judge) {
  const LevelRecord &finest = levels.back();
  const std::optional<double> error = relative_error(finest);
  const double allowed = judge.demands.tolerated_error,
               conditional = conditional_bound_of(finest).value_or(0.);
  if (error && *error <= allowed && conditional <= allowed)
    return "";
  std::ostringstream text;
  text << "The error of " << finest.sizes.word() << " " << finest.sizes.level;
  if (!error)
    text << " is not known";
  else if (bound_of(finest))
    text << " may be as large as " << 100. * *error << " % (energy norm, "
         << (is_guaranteed(finest) ? "guaranteed" : "estimated")
         << " bound; Tolerated error: " << 100. * allowed << " %)";
  else
    text << " is about " << 100. * *error
         << " % (energy norm, estimated; Tolerated error: " << 100. * allowed << " %)";
  if (const std::string reason = why_no_bound(finest); !reason.empty())
    text << ", and there is no bound: " << reason;
  if (conditional > allowed)
    text << ", which is more than is tolerated";
  text << "; " << remedy_for(finest);
  return text.str();
}

/** Checks that the bracket of the energy is not too wide: strain energy and work of loads may
 * nearly cancel. */
std::string check_energy(const std::vector<LevelRecord> &levels, const Judge &judge) {
  const LevelRecord &finest = levels.back();
  if (!is_guaranteed(finest) || !finest.bound->energy_lower || !finest.bound->energy_upper)
    return "";
  const double J = finest.certificate.energy;
  const double off = std::max(J - *finest.bound->energy_lower, *finest.bound->energy_upper - J);
  // An error of 20 % in the energy norm is one of 4 % in the strain energy. The bracket is about
  // twice as wide as the error, and |J| may be smaller than the strain energy.
  const double tolerated = 2.5 * judge.demands.tolerated_error * judge.demands.tolerated_error;
  // Relative to the strain energy, a bracket below this is rounding.
  constexpr double rounding = 1e-10;
  const double strain_energy = std::pow(*finest.bound->absolute / *finest.bound->relative, 2);
  if (off <= tolerated * std::abs(J) || !(off > rounding * strain_energy))
    return "";
  return concatenate("The energy of level ", finest.sizes.level, " is known up to ",
                     100. * off / std::abs(J),
                     " % only (guaranteed; allowed with this Tolerated error: ", 100. * tolerated,
                     " %); ", remedy_for(finest));
}

/** Returns whether the last of graded meshes did not lessen the estimate, where Newton's method
 * does not find the states of patches: they differ from mesh to mesh. */
bool states_differ(const std::vector<LevelRecord> &levels) {
  const LevelRecord &finest = levels.back();
  return finest.sizes.is_graded() && finest.dual.by_path && levels.size() > 1 && finest.estimate &&
         levels.end()[-2].estimate &&
         finest.estimate->relative >= 0.9 * levels.end()[-2].estimate->relative;
}

/** Returns whether a target that the user has not set is missed by an error that is guaranteed and
 * tolerated. */
bool misses_default_target(const LevelRecord &level, const Demands &demands) {
  return demands.target_error > 0. && !demands.target_is_given && is_guaranteed(level) &&
         *bound_of(level) >= demands.target_error && *bound_of(level) <= demands.tolerated_error;
}

/** Checks that the finest level reaches the target error, if there is one. */
std::string check_target(const std::vector<LevelRecord> &levels, const Judge &judge) {
  const LevelRecord &finest = levels.back();
  if (judge.demands.target_error == 0. || judge.reaches_target(finest) ||
      misses_default_target(finest, judge.demands))
    return "";
  std::ostringstream text;
  text << "The target error is not reached on " << finest.sizes.word() << " " << finest.sizes.level
       << ", the finest: the relative error is ";
  if (const std::optional<double> error = relative_error(finest))
    text << 100. * *error << " %"
         << (is_guaranteed(finest) ? " (energy norm, guaranteed)"
             : bound_of(finest)    ? " (energy norm, estimated bound)"
                                   : " (energy norm, estimated)");
  else
    text << "not known";
  text << ", allowed: below " << 100. * judge.demands.target_error << " %";
  // A run of graded meshes ends where the bound does not follow the estimate.
  const auto missed = std::find_if(levels.begin(), levels.end(), [&](const LevelRecord &level) {
    return level.sizes.is_graded() && bound_of(level) && level.estimate &&
           level.estimate->relative < judge.demands.target_error;
  });
  if (missed != levels.end())
    text << "; the estimate met it on step " << missed->sizes.level
         << ", the bound did not, most on "
         << (missed->bound->dominant_part() == ErrorBound::Part::contact
               ? missed->bound->worst_face
               : missed->bound->largest_cell);
  text
    << (bound_exceeds_mesh(finest)
          ? "; what is left is rounding, or data that no mesh resolves: take a larger Target "
            "error."
        : states_differ(levels)
          ? "; finer meshes do not come closer, because other patches stick and slip on each, as "
            "happens with large coefficients of friction: take a smaller Friction coefficient, "
            "or a larger Target error."
        : finest.sizes.is_graded()
          ? "; raise Maximum unknowns, or see where the mesh is finest (mesh-LL.svg, with "
            "Output/Pictures): data that contradict each other there have no solution."
          : "; raise Finest level.");
  return text.str();
}

/** Checks the estimates of load cases, whose mesh may suit the scene's own loads only. */
std::string check_errors_of_cases(const std::vector<LevelRecord> &levels, const Judge &judge) {
  const LevelRecord &finest = levels.back();
  const double allowed = judge.demands.tolerated_error;
  if (!finest.load_cases || finest.load_cases->max_estimate <= allowed)
    return "";
  return concatenate(
    "The error of load case ", finest.load_cases->worst, " is about ",
    100. * finest.load_cases->max_estimate,
    " % (energy norm, estimated; cases.csv has those of all cases; Tolerated error: ",
    100. * allowed, " %); ",
    (finest.sizes.is_graded() ? "set Strategy = nested" : "raise Finest level"),
    ", or solve the case as a scene whose own loads are those of the case.");
}

/** Checks that no other pressures solve the dual problem on the finest level. */
std::string check_uniqueness(const std::vector<LevelRecord> &levels, const Judge &) {
  const LevelRecord &finest = levels.back();
  if (finest.dual.unique)
    return "";
  return "Level " + std::to_string(finest.sizes.level) +
         ": the contact pressure is not unique, because contact patches are finer than the mesh; "
         "take a Patch ratio of 2 or more, or fewer Patches.";
}

/** Checks that all brackets of the energy have a number in common. */
std::string check_brackets(const std::vector<LevelRecord> &levels, const Judge &) {
  const auto has_bracket = [](const LevelRecord &level) {
    return is_guaranteed(level) && level.bound->energy_lower && level.bound->energy_upper;
  };
  const LevelRecord *highest = nullptr, *lowest = nullptr;
  for (const LevelRecord &level : levels)
    if (has_bracket(level)) {
      if (highest == nullptr || *level.bound->energy_lower > *highest->bound->energy_lower)
        highest = &level;
      if (lowest == nullptr || *level.bound->energy_upper < *lowest->bound->energy_upper)
        lowest = &level;
    }
  // The share that rounding leaves of the terms that J is the sum of.
  constexpr double rounding = 1e-8;
  if (highest == nullptr)
    return "";
  const double strain_energy = std::pow(*highest->bound->absolute / *highest->bound->relative, 2);
  const double allowed = rounding * (std::abs(*highest->bound->energy_lower) + strain_energy);
  if (!(*highest->bound->energy_lower - *lowest->bound->energy_upper > allowed))
    return "";
  return concatenate(
    "The energy is at least ", *highest->bound->energy_lower, " by the bound of level ",
    highest->sizes.level, " and at most ", *lowest->bound->energy_upper, " by that of level ",
    lowest->sizes.level,
    ": they contradict each other, and one of them is lost to rounding or to data that vary "
    "between the points where they are sampled.");
}

/** Checks that on the finest level bilinear elements are not too stiff for a nearly incompressible
 * body, unless the known error excludes that. */
std::string check_locking(const std::vector<LevelRecord> &levels, const Judge &judge) {
  const LevelRecord &finest = levels.back();
  const double number = finest.locking_number.value_or(0.);
  // A guaranteed bound excludes large errors; solutions in V^h, such as rigid motions, do not lock.
  const double excluded = is_guaranteed(finest) ? 0.1 * max_locking_number : 1e-6;
  if (number <= max_locking_number || relative_error(finest).value_or(1.) <= excluded)
    return "";
  return concatenate(
    "The body is nearly incompressible, and bilinear elements lock on a mesh as coarse as "
    "level ",
    finest.sizes.level, ": the locking number is ", number, ", allowed: at most ",
    max_locking_number, "; ",
    (judge.demands.has_b_bar ? "set Discretization/Element = Q1 B-bar, or refine." : "refine."));
}

/** Checks, without a bound, that the estimated error falls. */
std::string check_estimate(const std::vector<LevelRecord> &levels, const Judge &) {
  if (bound_of(levels.back()) || levels.back().sizes.is_graded() ||
      levels.size() < n_stagnant_levels)
    return "";
  // Solutions in V^h have estimates that are nothing but rounding.
  const double negligible = std::max(1e-8, 100. * levels.back().linear.rounding_error);
  const double slowest = std::pow(2., -0.1);
  const auto first = levels.end() - n_stagnant_levels;
  const bool all_matter = std::all_of(first, levels.end(), [&](const LevelRecord &level) {
    return level.estimate && !(level.estimate->relative < negligible);
  });
  const auto falls = [&](const LevelRecord &coarse, const LevelRecord &fine) {
    return fine.estimate->energy < slowest * coarse.estimate->energy;
  };
  if (!all_matter || std::adjacent_find(first, levels.end(), falls) != levels.end())
    return "";
  return "The estimated error does not fall from level to level, so that the mesh does not resolve "
         "the solution: refine, or take cells that are as wide as high (long cells are too stiff "
         "in bending).";
}

template <typename Subject>
using Check = std::string (*)(const Subject &, const Judge &);

/** The checks of a level. The first one that fails names the cause: a later one may fail for the
 * same reason. */
constexpr Check<LevelRecord> level_checks[] = {check_overflow, check_rounding, check_dual_problem,
                                               check_load_cases, check_residuals};
constexpr Check<std::vector<LevelRecord>> equation_checks[] = {check_finest_level, check_uniqueness,
                                                               check_brackets};
constexpr Check<std::vector<LevelRecord>> accuracy_checks[] = {
  check_locking, check_error, check_energy, check_estimate, check_target};

template <typename Checks, typename Subject>
std::string first_objection(const Checks &checks, const Subject &subject, const Judge &judge) {
  for (const auto check : checks) {
    std::string objection = check(subject, judge);
    if (!objection.empty())
      return objection;
  }
  return "";
}
} // namespace

std::string Judge::doubt(const LevelRecord &level) const {
  return first_objection(level_checks, level, *this);
}

StudyVerdict Judge::verdict(const std::vector<LevelRecord> &levels) const {
  if (levels.empty())
    return failed(levels, "No level has been solved.");
  const std::string objection = first_objection(equation_checks, levels, *this);
  if (!objection.empty())
    return failed(levels, objection);
  std::string doubt = first_objection(accuracy_checks, levels, *this);
  if (!doubt.empty() && demands.can_be_graded && !levels.back().sizes.is_graded())
    doubt += " Or set Discretization/Strategy = hp, which finds a mesh by itself.";
  if (doubt.empty())
    doubt = check_errors_of_cases(levels, *this);
  const Outcome outcome = !doubt.empty()                    ? Outcome::not_resolved
                          : is_guaranteed(levels.back())    ? Outcome::certified
                          : levels.back().sizes.is_graded() ? Outcome::accuracy_estimated
                                                            : Outcome::equations_certified;
  std::ostringstream accuracy;
  accuracy << describe_accuracy(levels);
  if (misses_default_target(levels.back(), demands))
    accuracy << "; the usual aim of graded meshes, " << 100. * demands.target_error
             << " %, is missed by a factor of " << std::setprecision(2)
             << *bound_of(levels.back()) / demands.target_error;
  return {outcome, doubt, accuracy.str(), max_residual_bound(levels)};
}
} // namespace Signorini
