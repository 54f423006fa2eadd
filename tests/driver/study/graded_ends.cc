// SPDX-License-Identifier: LGPL-2.1-or-later
// How runs on graded meshes end where there is nothing to refine, or no solution to refine from.

#include <deal.II/base/mpi.h>

#include "graded_steps.h"
#include "tests.h"

using namespace Signorini;

namespace
{
StudyResult<2> solve_hp(const std::string &scene, std::vector<std::string> overrides = {})
{
  overrides.insert(overrides.end(), {"Discretization/Strategy=hp", "Output/VTU=none"});
  return solve(scene, overrides);
}

/** Nothing deforms the body: the first step has the answer, up to rounding. */
void check_nothing_to_do(Checks &checks)
{
  const std::string far = "subsection Contact\n set Gap = 1\n end\n";
  const std::string held = "subsection Boundary\n set Contact = bottom\n set Clamped = top\n end\n";
  const std::string moved = "subsection Boundary\n set Contact = bottom\n"
                            " set Displacement = top: 0.3; -0.1\n end\n";
  for (const std::string &boundary : {held, moved})
  {
    const StudyResult<2> result = solve_hp(boundary + far);
    const std::string name = boundary == held ? "No load" : "A translation";
    checks.that(name + ": one step", result.levels.size() == 1);
    checks.that(name + ": certified", result.verdict.is_certified());
    checks.near(name + ": no energy", result.levels.back().certificate.energy, 0., 1e-20);
  }
}

/** What a contact solver left half done is not refined. */
void check_early_stop(Checks &checks)
{
  const StudyResult<2> result =
    solve_hp("subsection Boundary\n set Contact = bottom\n set Displacement = top: 0; -0.05\n end\n"
             "subsection Contact\n set Gap = 0.3*(x-0.37)^2\n end\n",
             {"Solver/Contact solver=psor", "Solver/Maximum iterations=1"});
  checks.that("One sweep: one step", result.levels.size() == 1);
  checks.that("One sweep: not certified", result.verdict.outcome == Outcome::not_certified);
}

/** Where a prescribed displacement jumps inside a side no displacement has finite energy: whatever
 * the estimate, nothing is claimed. */
void check_contradiction(Checks &checks)
{
  const StudyResult<2> result = solve_hp("subsection Boundary\n set Contact = bottom\n"
                                         " set Displacement = top: 0; x > 0.5 ? -0.05 : 0\n end\n"
                                         "subsection Contact\n set Gap = 0.1*x^2\n end\n");
  checks.that("Contradiction: not certified", !result.verdict.is_certified());
  checks.that("Contradiction: nothing is known", result.levels.back().estimate->relative >= 1.);
}

/** A coating that is soft and a thousandth of the body thick lies between the Gauss points of the
 * first mesh. The springs 0.999 and 0.001/1e-5 in a row, drawn by 1e-4: J = 1e-8/2/100.999. */
void check_coating(Checks &checks)
{
  const std::string coated =
    "subsection Boundary\n set Contact = bottom\n set Rollers = left, right\n"
    " set Displacement = top: 0; -1e-4\n end\n"
    "subsection Contact\n set Gap = 0\n end\n"
    "subsection Material\n set Young's modulus = y < 0.001 ? 1e-5 : 1\n"
    " set Poisson's ratio = 0\n end\n";
  const StudyResult<2> unaligned =
    solve_hp(coated, {"Discretization/Maximum unknowns=10000", "Discretization/Target error=0.05"});
  checks.that("Coating: not certified", !unaligned.verdict.is_certified());
  const StudyResult<2> aligned = solve_hp(coated, {"Discretization/Kinks at y=0.001"});
  checks.that("Coating, kinks given: certified by a second step",
              aligned.verdict.is_certified() && aligned.levels.size() == 2);
  checks.near("Coating, kinks given: the energy",
              aligned.levels.back().certificate.energy,
              0.5e-8 / 100.999,
              1e-8 * 0.5e-8);
  std::string message;
  try
  {
    solve_hp(coated, {"Material/Young's modulus=y < 1e-6 ? 1e-5 : 1"});
  }
  catch (const InputError &error)
  {
    message = error.what();
  }
  checks.that("A film: refused", message.find("Kinks at y") != std::string::npos);
}

/** A traction of 30 on a thousandth of a side is a force of 0.03, which the clamped side holds. */
void check_spike(Checks &checks)
{
  const StudyResult<2> result =
    solve_hp("subsection Boundary\n set Contact = bottom\n set Clamped = top\n"
             " set Traction = left: abs(y - 0.4003) < 5e-4 ? -30 : 0; 0\n end\n"
             "subsection Contact\n set Gap = 1\n end\n",
             {"Discretization/Target error=0.05"});
  checks.near("Spike: its force",
              result.levels.back().answer.reactions.at(0).resultant.force[0],
              0.03,
              2e-4 * 0.03);
}

/** Without a Target error the sequence aims at 1e-3. */
void check_usual_target(Checks &checks)
{
  const StudyResult<2> result =
    solve(named_scene("B1"), {"Discretization/Strategy=hp", "Output/VTU=none"});
  const std::vector<GradedStep> steps = steps_of(result.levels);
  checks.that("No target: certified", result.verdict.outcome == Outcome::accuracy_estimated);
  checks.between("No target: the last step", steps.back().estimate, steps.back().error, 1e-3);
  checks.that("No target: the step before", steps[steps.size() - 2].estimate > 1e-3);
}
/** A clamped block that is pulled: stresses are infinite at both ends of the clamped side, and
 * their largest value elsewhere is the same on nested and on graded meshes. With nu = 0 the stress
 * is one everywhere, whatever the exponent. */
void check_growth(Checks &checks)
{
  const auto pulled = [](const std::string &ratio) {
    return "subsection Boundary\n set Clamped = left\n set Contact = bottom\n"
           " set Traction = right: 1; 0\n end\nsubsection Contact\n set Gap = 10\n end\n"
           "subsection Material\n set Poisson's ratio = " +
           ratio + "\n end\n";
  };
  const StudyResult<2> nested = solve(pulled("0.3"), levels(5, 5));
  const StudyResult<2> graded_result = solve_hp(pulled("0.3"));
  for (const StudyResult<2> *result : {&nested, &graded_result})
  {
    const VonMises &stress = result->levels.back().answer.von_mises;
    const std::string name = result == &nested ? "Pulled, nested" : "Pulled, graded";
    checks.that(name + ": grows at a clamped corner",
                stress.grows_at && stress.grows_at->ends[0][0] == 0. &&
                  std::abs(stress.grows_at->ends[0][1] - 0.5) == 0.5);
    checks.near(name + ": away from it", stress.grows_at->radius, 0.1, 1e-14);
    checks.near(name + ": the same stress there",
                stress.away->value,
                graded_result.levels.back().answer.von_mises.away->value,
                0.03);
    checks.that(name + ": infinite at the corner", stress.value > 1.2 * stress.away->value);
  }
  const VonMises uniform = solve(pulled("0"), levels(3, 3)).levels.back().answer.von_mises;
  checks.that("Pulled, nu = 0: no growth", !uniform.grows_at);
  checks.near("Pulled, nu = 0: the stress", uniform.value, 1., 1e-10);
}
} // namespace

int main(int argc, char **argv)
{
  dealii::deal_II_exceptions::disable_abort_on_exception();
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  Checks checks;
  check_nothing_to_do(checks);
  check_early_stop(checks);
  check_contradiction(checks);
  check_coating(checks);
  check_spike(checks);
  check_usual_target(checks);
  check_growth(checks);
  return checks.exit_code();
}
