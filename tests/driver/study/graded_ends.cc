// SPDX-License-Identifier: LGPL-2.1-or-later
// How runs on graded meshes end where there is nothing to refine, or no solution to refine from.

#include "graded_steps.h"
#include "tests.h"

using namespace Signorini;

namespace {
/** Contact is at the bottom unless a scene is given. */
StudyResult<2>
solve_hp(std::vector<std::string> overrides,
         const std::string &scene = "subsection Boundary\nset Contact = bottom\nend\n") {
  overrides.insert(overrides.end(), {"Discretization/Strategy=hp", "Output/VTU=none"});
  return solve(scene, overrides);
}

const std::string pressed = "Boundary/Displacement=top: 0; -0.05";

/** Nothing deforms the body: the first step has the answer, up to rounding. */
void check_nothing_to_do(Checks &checks) {
  for (const std::string held : {"Boundary/Clamped=top", "Boundary/Displacement=top: 0.3; -0.1"}) {
    checks.about(held);
    const StudyResult<2> result = solve_hp({held, "Contact/Gap=1"});
    checks.near("one step", result.levels.size(), 1, 0.);
    checks.that("certified", result.verdict.is_certified());
    checks.near("no energy", last(result, "energy"), 0., 1e-20);
  }
}

/** A contact problem that its solver left half done is not refined. */
void check_early_stop(Checks &checks) {
  const StudyResult<2> result =
    solve_hp({pressed, "Contact/Gap=0.3*(x-0.37)^2", "Solver/Contact solver=psor",
              "Solver/Maximum iterations=1"});
  checks.that("One sweep: one step, not certified",
              result.levels.size() == 1 && result.verdict.outcome == Outcome::not_certified);
}

/** Where a prescribed displacement jumps inside a side no displacement has finite energy: whatever
 * the estimate, nothing is claimed. */
void check_contradiction(Checks &checks) {
  const StudyResult<2> result =
    solve_hp({"Boundary/Displacement=top: 0; x > 0.5 ? -0.05 : 0", "Contact/Gap=0.1*x^2"});
  checks.that("Contradiction: not certified, nothing is known",
              !result.verdict.is_certified() && last(result, "estimated_relative") >= 1.);
}

/** A soft coating that is much thinner than the cells of the first mesh. The springs 1 - d and
 * d/1e-5 in a row, drawn by 1e-4: J = 1e-8/2/(1 - d + 1e5 d). */
void check_coating(Checks &checks) {
  for (const double d : {1e-3, 1e-6}) {
    const StudyResult<2> result = solve_hp(
      {"Boundary/Rollers=left, right", "Boundary/Displacement=top: 0; -1e-4", "Contact/Gap=0",
       "Constants/Values=d=" + std::to_string(d), "Material/Young's modulus=y < d ? 1e-5 : 1",
       "Material/Poisson's ratio=0", "Discretization/Target error=0.05"});
    checks.that("Coating: certified", result.verdict.is_certified());
    checks.near("Coating: the energy", last(result, "energy") * (1. - d + 1e5 * d) / 0.5e-8, 1.,
                d == 1e-3 ? 1e-6 : 1e-2);
  }
}

/** A traction of 30 on a thousandth of a side is a force of 0.03, which the clamped side holds. */
void check_spike(Checks &checks) {
  const StudyResult<2> result =
    solve_hp({"Boundary/Clamped=top", "Boundary/Traction=left: abs(y - 0.4003) < 5e-4 ? -30 : 0; 0",
              "Contact/Gap=1", "Discretization/Target error=0.05"});
  checks.near("Spike: its force", result.levels.back().answer.reactions.at(0).resultant.force[0],
              0.03, 2e-4 * 0.03);
}

/** Without a Target error the sequence aims at 1e-3. */
void check_usual_target(Checks &checks) {
  const StudyResult<2> result = solve_hp({}, named_scene("B1"));
  const std::vector<GradedStep> steps = steps_of(result.levels);
  checks.that("No target: certified", result.verdict.outcome == Outcome::certified);
  checks.between("No target: the last step", last(result, "bound_relative"), steps.back().error,
                 1e-3);
  checks.that("No target: the step before", steps[steps.size() - 2].estimate > 1e-3);
}

/** The bound is asked before the estimate reaches the target, where it may exist: B3 ends a step
 * earlier. With Coulomb's law and on bodies of revolution only the last step looks for one. */
void check_early_bound(Checks &checks) {
  const StudyResult<2> result = solve(named_scene("B3"), graded("1e-6"));
  checks.that("Early bound: the estimate has not met the target",
              last(result, "estimated_relative") > 1e-6);
  checks.between("Early bound: guaranteed", last(result, "bound_relative"),
                 steps_of(result.levels).back().error, 1e-6);
  for (const std::string name : {"R2", "KS"})
    for (const LevelRecord &level : solve(named_scene(name), graded("1e-4")).levels)
      checks.that(name + ": no early bound",
                  level.estimate && (level.estimate->relative < 1e-4 || !level.bound));
}

/** A clamped block that is pulled: stresses are infinite at both ends of the clamped side, and
 * their largest value elsewhere is the same on nested and on graded meshes. With nu = 0 the stress
 * is one everywhere, whatever the exponent. */
void check_growth(Checks &checks) {
  const auto pulled = [](const std::string &ratio) {
    return "subsection Boundary\n set Clamped = left\n set Contact = bottom\n"
           " set Traction = right: 1; 0\n end\nsubsection Contact\n set Gap = 10\n end\n"
           "subsection Material\n set Poisson's ratio = " +
           ratio + "\n end\n";
  };
  const VonMises nested = solve(pulled("0.3"), levels(5, 5)).levels.back().answer.von_mises,
                 refined = solve_hp({}, pulled("0.3")).levels.back().answer.von_mises;
  for (const VonMises &stress : {nested, refined}) {
    checks.that("Pulled: grows at a clamped corner",
                stress.grows_at && stress.grows_at->ends[0][0] == 0. &&
                  std::abs(stress.grows_at->ends[0][1] - 0.5) == 0.5);
    checks.near("Pulled: away from it", stress.grows_at->radius, 0.1, 1e-14);
    checks.near("Pulled: the same stress there", stress.away->value, refined.away->value, 0.03);
    checks.that("Pulled: infinite at the corner", stress.value > 1.2 * stress.away->value);
  }
  const VonMises uniform = solve(pulled("0"), levels(3, 3)).levels.back().answer.von_mises;
  checks.that("Pulled, nu = 0: no growth", !uniform.grows_at);
  checks.near("Pulled, nu = 0: the stress", uniform.value, 1., 1e-10);
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv,
                   {check_nothing_to_do, check_early_stop, check_contradiction, check_coating,
                    check_spike, check_usual_target, check_early_bound, check_growth});
}
