// SPDX-License-Identifier: LGPL-2.1-or-later
// Each judgement with what it says, their order, and the bound on residuals.

#include <signorini/results/verdict/judge.h>

#include <cmath>
#include <limits>

#include "tests.h"

using namespace Signorini;

namespace
{
const Judge judge({1e-10, 0.2, 0.});

bool begins_with(const std::string &text, const std::string &beginning)
{
  return text.compare(0, beginning.size(), beginning) == 0;
}

/** A residual that is not a number is not a small one, whichever it is. */
void residuals(Checks &checks)
{
  double Certificate::*const members[] = {&Certificate::stationarity,
                                          &Certificate::penetration,
                                          &Certificate::sign,
                                          &Certificate::support,
                                          &Certificate::complementarity,
                                          &Certificate::duality_gap,
                                          &Certificate::force_balance,
                                          &Certificate::moment_balance};
  bool noticed = true;
  for (const auto member : members)
  {
    Certificate certificate;
    certificate.*member = std::nan("");
    noticed = noticed && std::isnan(max_residual(certificate).value);
    certificate.*member = 0.5;
    noticed = noticed && max_residual(certificate).value == 0.5;
  }
  checks.that("the largest residual, and what is not a number", noticed);
  Certificate curved;
  curved.moment_balance = 0.5;
  curved.moments_are_exact = false;
  checks.near("moments of curved cells do not count", max_residual(curved).value, 0., 0.);
}

void bounds(Checks &checks)
{
  LevelRecord level;
  checks.near("without rounding", judge.residual_bound(level), 1e-8, 1e-22);
  checks.near("of a large tolerance", Judge({1e-6, 0.2, 0.}).residual_bound(level), 1e-4, 1e-18);
  checks.near("one per cent is no balance", Judge({1e-2, 0.2, 0.}).residual_bound(level), 0.01, 0.);
  level.linear.rounding_error = 1e-9;
  checks.near("of rounding in U", judge.residual_bound(level), 1e-7, 1e-21);
  level.certificate.rounding = 1e-8;
  checks.near("of rounding in forces", judge.residual_bound(level), 1e-6, 1e-20);
  level.certificate.rounding = 1.;
  checks.near("never above 1e-5", judge.residual_bound(level), 1e-5, 1e-19);
}

/** From the last cause to the first: each one hides those behind it. */
void doubts(Checks &checks)
{
  LevelRecord level;
  checks.that("no doubt", judge.accepts(level) && judge.doubt(level).empty());
  level.certificate.force_balance = 1e-3;
  checks.that("a large residual",
              judge.doubt(level) ==
                "the residual force_balance of the certificate is 0.001, above 1e-08; the linear "
                "system is not solved well enough: take another Linear solver.");
  level.linear.rounding_error = 1e-9;
  checks.that(
    "a large residual with rounding",
    begins_with(judge.doubt(level),
                "the residual force_balance of the certificate is 0.001, above 1e-07; "
                "rounding leaves no more, because the stiffness matrix is ill-conditioned"));
  level.dual.kkt = 1e-9;
  level.dual.iterations = 7;
  checks.that("a KKT residual above the tolerance",
              begins_with(judge.doubt(level),
                          "the active set method stopped after 7 iterations with the KKT residual "
                          "1e-09, above the tolerance 1e-10: raise Tolerance or Maximum "
                          "iterations, or take Contact solver = psor."));
  level.dual.method = ContactSolver::psor;
  checks.that("projected SOR",
              begins_with(judge.doubt(level), "projected SOR stopped after 7") &&
                judge.doubt(level).find("Relaxation") != std::string::npos);
  level.dual = DualSolve();
  level.dual.converged = false;
  checks.that("no convergence", !judge.accepts(level));
  level.linear.rounding_error = 1e-5;
  checks.that("rounding",
              begins_with(judge.doubt(level),
                          "rounding changes displacements or forces by the relative amount 1e-05 "
                          "(allowed: 1e-6), because the stiffness matrix is ill-conditioned"));
  level.certificate.rounding = 1e-4;
  level.certificate.translation = 1e9;
  checks.that("rounding by a translation",
              begins_with(judge.doubt(level),
                          "rounding changes displacements or forces by the relative amount 0.0001 "
                          "(allowed: 1e-6), because the body is moved as a whole by 1e+09 times"));
  level.dual.kkt = std::numeric_limits<double>::infinity();
  checks.that("overflow", begins_with(judge.doubt(level), "numbers overflow"));
}

std::vector<LevelRecord> three_levels()
{
  std::vector<LevelRecord> levels(3);
  for (unsigned int k = 0; k < 3; ++k)
  {
    levels[k].sizes.level = k + 2;
    levels[k].estimate = ErrorEstimate{1., std::pow(0.5, k), 0.1 * std::pow(0.5, k), 0., 0.};
  }
  return levels;
}

/** From the last cause to the first, likewise. */
void studies(Checks &checks)
{
  std::vector<LevelRecord> levels = three_levels();
  const StudyVerdict good = judge.verdict(levels);
  checks.that("certified", good.is_certified() && good.reason.empty());
  levels[2].estimate->energy = levels[1].estimate->energy;
  checks.that("one level without progress is none too many", judge.verdict(levels).is_certified());
  for (LevelRecord &level : levels)
    level.estimate->energy = 1.;
  checks.that("the estimate does not fall",
              begins_with(judge.verdict(levels).reason, "The estimated error does not fall"));
  checks.that("two levels do not show it", judge.verdict({levels[0], levels[1]}).is_certified());
  levels[1].estimate->relative = 1e-9;
  checks.that("an estimate that is rounding", judge.verdict(levels).is_certified());
  levels[1].estimate->relative = 0.1;
  levels[2].locking_number = 0.5;
  checks.that("locking",
              begins_with(judge.verdict(levels).reason, "The body is nearly incompressible") &&
                judge.verdict(levels).reason.find("level 4: K/mu (h/l)^2 = 0.5, allowed: at most "
                                                  "0.25;") != std::string::npos);
  ErrorBound bound;
  bound.relative = bound.absolute = 0.19;
  levels[2].bound = bound;
  checks.that("a bound of 19 % does not exclude locking",
              begins_with(judge.verdict(levels).reason, "The body is nearly incompressible"));
  levels[2].bound->relative = 0.02;
  checks.that("one of 2 % does", judge.verdict(levels).outcome == Outcome::certified);
  levels[2].dual.unique = false;
  checks.that(
    "many pressures",
    begins_with(judge.verdict(levels).reason, "Level 4: the contact pressure is not unique"));
  levels[2].dual.converged = false;
  const StudyVerdict bad = judge.verdict(levels);
  checks.that("a level in doubt",
              begins_with(bad.reason, "Level 4: the active set method stopped"));
  checks.that("not certified", bad.outcome == Outcome::not_certified && !bad.is_certified());
  levels = three_levels();
  levels[1].dual.converged = false;
  checks.that("a coarse level in doubt does not condemn a finer one",
              judge.verdict(levels).is_certified());
  levels = three_levels();
  levels[1].dual.unique = false;
  checks.that("only the finest level's pressure must be unique",
              judge.verdict(levels).is_certified());
}

/** A bound decides where there is one, and the message names what dominates it. */
void errors(Checks &checks)
{
  std::vector<LevelRecord> levels = three_levels();
  checks.that("without a bound",
              judge.verdict(levels).outcome == Outcome::equations_certified &&
                judge.verdict(levels).accuracy.find("there is no bound") != std::string::npos);
  ErrorBound bound;
  bound.relative = bound.absolute = 0.2;
  bound.mesh = 0.15;
  bound.oscillation = 0.01;
  bound.contact = 0.05;
  bound.largest_cell = "the cell at (1, 2)";
  bound.worst_face = "bottom at (3, 0)";
  levels[2].bound = bound;
  checks.that("a bound that is tolerated", judge.verdict(levels).outcome == Outcome::certified);
  checks.that("what is guaranteed",
              begins_with(judge.verdict(levels).accuracy,
                          "the error is at most 20 % (energy norm, guaranteed)"));
  for (LevelRecord &level : levels)
    level.estimate->energy = 1.;
  checks.that("a bound sees more than an estimate that does not fall",
              judge.verdict(levels).outcome == Outcome::certified);
  levels[2].bound->relative = 0.21;
  const StudyVerdict large = judge.verdict(levels);
  checks.that("a bound that is too large",
              large.outcome == Outcome::not_resolved && !large.is_certified() &&
                large.equations_hold() &&
                begins_with(large.reason, "The error of level 4 may be as large as 21 %") &&
                large.reason.find("most in the cell at (1, 2)") != std::string::npos);
  levels[2].bound->contact = 0.5;
  checks.that("contact dominates",
              judge.verdict(levels).reason.find("not resolved on bottom at (3, 0)") !=
                std::string::npos);
  levels[2].bound->relative = 0.05;
  const Judge strict({1e-10, 0.2, 0.04});
  checks.that("a target error that is not reached",
              strict.verdict(levels).outcome == Outcome::not_resolved &&
                !strict.reaches_target(levels[2]) &&
                begins_with(strict.verdict(levels).reason, "The target error is not reached"));
  checks.that("one that is", Judge({1e-10, 0.2, 0.06}).reaches_target(levels[2]));
}

/** Whatever number judges: above Tolerated error nothing is resolved, and below it an aim that the
 * user has not set condemns nothing. */
void estimates(Checks &checks)
{
  Demands demands;
  demands.tolerated_error = 0.02;
  demands.target_error = 1e-4;
  demands.target_is_given = false;
  demands.can_be_graded = true;
  const Judge judge(demands);
  std::vector<LevelRecord> levels = three_levels();
  levels[2].estimate->relative = 0.03;
  const StudyVerdict large = judge.verdict(levels);
  checks.that("an estimate that is too large",
              large.outcome == Outcome::not_resolved &&
                begins_with(large.reason,
                            "The error of level 4 is about 3 % (energy norm, "
                            "estimated; Tolerated error: 2 %); refine"));
  checks.that("graded meshes are named", large.reason.find("Strategy = hp") != std::string::npos);
  levels[2].estimate->mesh = 0.1;
  levels[2].estimate->algebra = 0.2;
  checks.that("the solver's part is named",
              judge.verdict(levels).reason.find("take a smaller Tolerance") != std::string::npos);
  levels[2].estimate->contact = 0.3;
  levels[2].estimate->algebra = 0.;
  checks.that("missed contact is named",
              judge.verdict(levels).reason.find("penetrates where no patch presses") !=
                std::string::npos);
  levels[2].estimate->relative = 0.019;
  checks.that("one that is tolerated",
              judge.verdict(levels).outcome == Outcome::equations_certified);
  levels[2].sizes.strategy = Strategy::hp;
  checks.that("on a graded mesh, above its usual aim",
              judge.verdict(levels).outcome == Outcome::accuracy_estimated);
  levels[2].estimate->relative = 0.03;
  checks.that("too large on a graded mesh",
              begins_with(judge.verdict(levels).reason, "The error of step 4 is about 3 %") &&
                judge.verdict(levels).reason.find("Strategy = hp") == std::string::npos);
  levels[2].estimate.reset();
  checks.that("nothing is known",
              begins_with(judge.verdict(levels).reason, "The error of step 4 is not known"));
}

/** The energy must be known to 2.5 times the square of the tolerated error: 10 % of |J|. */
void energies(Checks &checks)
{
  std::vector<LevelRecord> levels = three_levels();
  ErrorBound bound;
  bound.relative = bound.absolute = 0.19;
  bound.largest_cell = "the cell at (1, 2)";
  levels[2].bound = bound;
  levels[2].certificate.energy = -2.;
  levels[2].bound->energy_lower = -2.199;
  levels[2].bound->energy_upper = -2.01;
  checks.that("an energy that is known well enough",
              judge.verdict(levels).outcome == Outcome::certified);
  levels[2].bound->energy_lower = -2.201;
  checks.that("an energy that is not",
              judge.verdict(levels).outcome == Outcome::not_resolved &&
                begins_with(judge.verdict(levels).reason, "The energy of level 4 is known up to"));
  levels[2].bound->energy_lower = -2.01;
  levels[2].bound->energy_upper = -1.79;
  levels[1].bound = bound;
  levels[1].bound->energy_lower = -2.2;
  levels[1].bound->energy_upper = -2.01;
  checks.that("brackets with a common end", judge.verdict(levels).outcome == Outcome::not_resolved);
  levels[1].bound->energy_upper = -2.02;
  checks.that("brackets that contradict",
              judge.verdict(levels).outcome == Outcome::not_certified &&
                begins_with(judge.verdict(levels).reason, "The energy is at least -2.01 by"));
  levels[1].bound.reset();
  levels[2].certificate.energy = 0.;
  levels[2].bound->energy_lower = -1e-13;
  levels[2].bound->energy_upper = 1e-13;
  checks.that("rounding of an energy that cancels",
              judge.verdict(levels).outcome == Outcome::certified);
}

void endings(Checks &checks)
{
  checks.that("failed", judge.failed({LevelRecord()}, "it failed.").reason == "it failed.");
  const StudyVerdict empty = judge.verdict({});
  checks.that("no level at all", !empty.is_certified() && !empty.reason.empty());
}
} // namespace

int main()
{
  Checks checks;
  residuals(checks);
  bounds(checks);
  doubts(checks);
  studies(checks);
  errors(checks);
  estimates(checks);
  energies(checks);
  endings(checks);
  return checks.exit_code();
}
