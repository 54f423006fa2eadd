// SPDX-License-Identifier: LGPL-2.1-or-later
// Each judgement with its words, their order, and the bound on residuals.

#include <signorini/results/verdict/judge.h>

#include <cmath>
#include <limits>
#include <tuple>

#include "tests.h"

using namespace Signorini;

namespace {
const Judge judge({1e-10, 0.2, 0.});

/** A residual that is not a number is not a small one, whichever it is. */
void residuals(Checks &checks) {
  for (double Certificate::*const member :
       {&Certificate::stationarity, &Certificate::penetration, &Certificate::sign,
        &Certificate::support, &Certificate::complementarity, &Certificate::duality_gap,
        &Certificate::force_balance, &Certificate::moment_balance}) {
    Certificate certificate;
    certificate.*member = std::nan("");
    checks.that("what is not a number", std::isnan(max_residual(certificate).value));
    certificate.*member = 0.5;
    checks.near("the largest residual", max_residual(certificate).value, 0.5, 0.);
  }
  Certificate curved;
  curved.moment_balance = 0.5;
  curved.moments_are_exact = false;
  checks.near("moments of curved cells do not count", max_residual(curved).value, 0., 0.);
}

void bounds(Checks &checks) {
  LevelRecord level, in_U, in_forces, large;
  in_U.linear.rounding_error = 1e-9;
  in_forces.certificate.rounding = 1e-8;
  large.certificate.rounding = 1.;
  for (const auto &[record, tolerance, bound] :
       {std::tuple(level, 1e-10, 1e-8), std::tuple(level, 1e-6, 1e-4),
        std::tuple(level, 1e-2, 0.01), std::tuple(in_U, 1e-10, 1e-7),
        std::tuple(in_forces, 1e-10, 1e-6), std::tuple(large, 1e-10, 1e-5)})
    checks.near("bound on residuals", Judge({tolerance, 0.2, 0.}).residual_bound(record) / bound,
                1., 1e-13);
}

/** From the last cause to the first: each one hides those behind it. */
void doubts(Checks &checks) {
  LevelRecord level;
  const auto doubt = [&](const std::string &beginning) {
    checks.that(beginning, judge.doubt(level).rfind(beginning, 0) == 0 && !judge.accepts(level));
  };
  checks.that("no doubt", judge.accepts(level) && judge.doubt(level).empty());
  level.certificate.force_balance = 1e-3;
  doubt("the residual force_balance of the certificate is 0.001, above 1e-08; the linear system is "
        "not solved well enough: take another Linear solver.");
  level.linear.rounding_error = 1e-9;
  doubt("the residual force_balance of the certificate is 0.001, above 1e-07; rounding leaves no "
        "more, because the stiffness matrix is ill-conditioned");
  level.dual.kkt = 1e-9;
  level.dual.iterations = 7;
  doubt("the active set method stopped after 7 iterations with the KKT residual 1e-09, above the "
        "tolerance 1e-10: raise Tolerance or Maximum iterations, or take Contact solver = psor.");
  level.tangential.emplace();
  level.dual.kkt = 0.1;
  doubt("the active set method stopped after 7 iterations with the KKT residual 0.1, above the "
        "tolerance 1e-10: it did not find where patches stick and slip");
  level.tangential.reset();
  level.dual.method = ContactSolver::psor;
  doubt("projected SOR stopped after 7");
  checks.that("remedy", judge.doubt(level).find("Relaxation") != std::string::npos);
  level.dual = DualSolve();
  level.dual.converged = false;
  doubt("the active set method stopped");
  level.linear.rounding_error = 1e-5;
  doubt("rounding changes displacements or forces by the relative amount 1e-05 (allowed: 1e-6), "
        "because the stiffness matrix is ill-conditioned");
  level.certificate.rounding = 1e-4;
  level.certificate.translation = 1e9;
  doubt("rounding changes displacements or forces by the relative amount 0.0001 (allowed: 1e-6), "
        "because the body is moved as a whole by 1e+09 times");
  level.dual.kkt = std::numeric_limits<double>::infinity();
  doubt("numbers overflow");
}

std::vector<LevelRecord> three_levels() {
  std::vector<LevelRecord> levels(3);
  for (unsigned int k = 0; k < 3; ++k) {
    levels[k].sizes.level = k + 2;
    levels[k].estimate = ErrorEstimate{1., std::pow(0.5, k), 0.1 * std::pow(0.5, k), 0., 0.};
  }
  return levels;
}

/** A bound of this relative size. */
ErrorBound bound_of(const double relative) {
  ErrorBound bound;
  bound.relative = bound.absolute = relative;
  bound.mesh = 0.15;
  bound.oscillation = 0.01;
  bound.contact = 0.05;
  bound.largest_cell = "the cell at (1, 2)";
  bound.worst_face = "bottom at (3, 0)";
  return bound;
}

/** Levels, and the verdict on them as a study. */
struct Study {
  Checks &checks;
  Demands demands = {1e-10, 0.2, 0.};
  std::vector<LevelRecord> levels = three_levels();

  void is(const Outcome outcome, const std::vector<std::string> &parts = {}) {
    const StudyVerdict verdict = Judge(demands).verdict(levels);
    checks.about(parts.empty() ? verdict.accuracy : parts[0]);
    checks.that("outcome", verdict.outcome == outcome);
    for (const std::string &part : parts)
      checks.that(part, (verdict.reason + verdict.accuracy).find(part) != std::string::npos);
  }
};

constexpr Outcome solved = Outcome::equations_certified, certified = Outcome::certified,
                  coarse = Outcome::not_resolved, bad = Outcome::not_certified;

/** From the last cause to the first, likewise. */
void studies(Checks &checks) {
  Study study = {checks};
  std::vector<LevelRecord> &levels = study.levels;
  study.is(solved, {"there is no bound"});
  // One level without progress is none too many, nor are two levels; nor is rounding.
  levels[2].estimate->energy = levels[1].estimate->energy;
  study.is(solved);
  for (LevelRecord &level : levels)
    level.estimate->energy = 1.;
  study.is(coarse, {"The estimated error does not fall"});
  checks.that("two levels", judge.verdict({levels[0], levels[1]}).is_certified());
  levels[1].estimate->relative = 1e-9;
  study.is(solved);
  levels[1].estimate->relative = 0.1;
  // A bound of 19 % does not exclude locking, one of 2 % does.
  levels[2].locking_number = 0.5;
  study.is(coarse, {"The body is nearly incompressible",
                    "level 4: the locking number is 0.5, allowed: at most 0.25;"});
  levels[2].bound = bound_of(0.19);
  study.is(coarse, {"The body is nearly incompressible"});
  levels[2].bound->relative = 0.02;
  study.is(certified);
  levels[2].dual.unique = false;
  study.is(bad, {"Level 4: the contact pressure is not unique"});
  levels[2].dual.converged = false;
  study.is(bad, {"Level 4: the active set method stopped"});
  // A coarse level in doubt does not condemn a finer one.
  levels = three_levels();
  levels[1].dual.converged = levels[1].dual.unique = false;
  study.is(solved);
  checks.that("failed", judge.failed({LevelRecord()}, "it failed.").reason == "it failed.");
  levels.clear();
  study.is(bad, {"."});
}

/** A bound decides where there is one, and the message names its dominant part. */
void errors(Checks &checks) {
  Study study = {checks};
  LevelRecord &level = study.levels[2];
  level.bound = bound_of(0.2);
  study.is(certified, {"the error is at most 20 % (energy norm, guaranteed)"});
  // It sees more than an estimate that does not fall.
  for (LevelRecord &other : study.levels)
    other.estimate->energy = 1.;
  study.is(certified);
  level.bound->relative = 0.21;
  study.is(coarse, {"The error of level 4 may be as large as 21 %", "most in the cell at (1, 2)"});
  level.bound->contact = 0.5;
  study.is(coarse, {"not resolved on bottom at (3, 0)"});
  level.bound->relative = 0.05;
  study.demands.target_error = 0.04;
  study.is(coarse, {"The target error is not reached"});
  checks.that("reaches_target", !Judge(study.demands).reaches_target(level) &&
                                  Judge({1e-10, 0.2, 0.06}).reaches_target(level));
  // A target that nobody has asked for does not refuse a guaranteed and tolerated result.
  study.demands.target_is_given = false;
  study.is(certified, {"the usual aim of graded meshes, 4 %, is missed by a factor of 1.2"});
  level.bound->relative = 0.21;
  study.is(coarse);
}

/** Whatever number judges: above Tolerated error nothing is resolved, nor on graded meshes above
 * the target, and that is said. */
void estimates(Checks &checks) {
  Study study = {checks, {1e-10, 0.02, 0.}};
  study.demands.can_be_graded = true;
  LevelRecord &level = study.levels[2];
  level.estimate->relative = 0.03;
  study.is(
    coarse,
    {"The error of level 4 is about 3 % (energy norm, estimated; Tolerated error: 2 %); refine",
     "Strategy = hp"});
  level.estimate->mesh = 0.1;
  level.estimate->algebra = 0.2;
  study.is(coarse, {"take a smaller Tolerance"});
  level.estimate->contact = 0.3;
  level.estimate->algebra = 0.;
  study.is(coarse, {"contact is not resolved"});
  level.estimate->relative = 0.019;
  study.is(solved);
  // A bound on a condition does not certify, but refuses.
  level.bound = bound_of(0.021);
  level.bound->is_conditional = true;
  study.is(coarse, {"at most 2.1 % if friction carried", "which is more than is tolerated"});
  checks.that("nor does it reach a target", !Judge({1e-10, 0.02, 0.02}).reaches_target(level));
  level.bound->relative = 0.019;
  study.is(solved);
  level.bound.reset();
  level.sizes.strategy = Strategy::hp;
  study.is(Outcome::accuracy_estimated);
  study.demands.target_error = 1e-3;
  study.is(coarse, {"The target error is not reached on step 4, the finest: the relative error is "
                    "1.9 % (energy norm, estimated), allowed: below 0.1 %; raise Maximum"});
  level.estimate->relative = 0.03;
  study.is(coarse, {"The error of step 4 is about 3 %"});
  checks.that("no other strategy is named",
              Judge(study.demands).verdict(study.levels).reason.find("Strategy = hp") ==
                std::string::npos);
  level.estimate.reset();
  study.is(coarse, {"The error of step 4 is not known"});
}

/** The energy must be known to 2.5 times the square of the tolerated error: 10 % of |J|. */
void energies(Checks &checks) {
  using Bracket = std::pair<double, double>;
  const auto check = [&](const double energy, const Bracket &bracket, const Bracket &before,
                         const Outcome outcome, const std::string &reason = "") {
    Study study = {checks};
    LevelRecord &level = study.levels[2], &other = study.levels[1];
    level.certificate.energy = energy;
    level.bound = other.bound = bound_of(0.19);
    std::tie(level.bound->energy_lower, level.bound->energy_upper) = bracket;
    std::tie(other.bound->energy_lower, other.bound->energy_upper) = before;
    study.is(outcome, {reason});
  };
  const Bracket any(-1e3, 1e3);
  check(-2., {-2.199, -2.01}, any, certified);
  check(-2., {-2.201, -2.01}, any, coarse, "The energy of level 4 is known up to");
  check(-2., {-2.01, -1.79}, {-2.2, -2.01}, coarse);
  check(-2., {-2.01, -1.79}, {-2.2, -2.02}, bad, "The energy is at least -2.01 by");
  // Rounding of an energy that cancels.
  check(0., {-1e-13, 1e-13}, any, certified);
}
} // namespace

int main() {
  return run_tests({residuals, bounds, doubts, studies, errors, estimates, energies});
}
