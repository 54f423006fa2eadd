// SPDX-License-Identifier: LGPL-2.1-or-later
// Graded meshes on every scene with a known solution: the estimate is nowhere below half of the
// error, the bound is between the error and one and a half of it, the error falls exponentially
// with the cubic root of the unknowns, and the cost of coming below 1e-6.

#include <signorini/verification/catalogue/catalogue.h>

#include <algorithm>
#include <map>

#include "graded_steps.h"
#include "tests.h"

using namespace Signorini;

namespace {
/** At most so many unknowns for an error of 1e-6, and at least this |correlation| of log(error)
 * over N^{1/3}, for singular solutions, which the theory is about. C4 has no singularity; once all
 * its ends of contact are found, the error falls faster than on a line. */
const std::map<std::string, std::pair<double, double>> exponential = {
  {"A3", {11000., 0.97}}, {"B1", {10000., 0.97}}, {"B2", {17000., 0.97}}, {"B3", {25000., 0.97}},
  {"B4", {10000., 0.97}}, {"C4", {25000., 0.9}},  {"E2", {40000., 0.97}}};

/** @param reason a word of why there is no bound, if there is none. */
std::vector<GradedStep> check_estimate(Checks &checks, const StudyResult<2> &result,
                                       const std::string &reason = "curved") {
  constexpr double rounding = 1e-11;
  const std::vector<GradedStep> steps = steps_of(result.levels);
  const LevelRecord &finest = result.levels.back();
  if (const std::string &missing = finest.bound->missing; missing.empty()) {
    checks.that("the target is reached", result.verdict.outcome == Outcome::certified);
    // Where u_h is nearly exact, the roots of rounding count.
    if (steps.back().error > rounding)
      checks.between("bound over error", last(result, "bound_energy") / last(result, "u_energy"),
                     1., steps.back().error > 1e-7 ? 1.5 : 10.);
  } else {
    checks.that("the reason why there is no bound: " + reason,
                missing.find(reason) != std::string::npos);
    checks.that("the target is reached", result.verdict.outcome == Outcome::accuracy_estimated);
  }
  for (const GradedStep &step : steps)
    if (step.estimate > rounding || step.error > rounding)
      checks.that("estimate over error", step.estimate >= 0.5 * step.error);
  checks.between("error of the last step", steps.back().error, 0., 2e-6);
  return steps;
}

void check_catalogue(Checks &checks) {
  std::vector<std::string> scenes;
  // B1t is B1 with another end of contact.
  for (const CatalogueEntry<2> &scene : catalogue<2>())
    if (scene.name != "block on parabola" && scene.name != "A1L" && scene.name != "B1t" &&
        !scene.make().contact_law.has_tangential_part())
      scenes.push_back(scene.name);
  for (const std::string &scene : checks.rows(scenes, 3)) {
    checks.about(scene);
    const std::vector<GradedStep> steps = check_estimate(
      checks, solve(named_scene(scene), graded("1e-6")), scene[0] == 'R' ? "revolution" : "curved");
    const auto expected = exponential.find(scene);
    if (expected == exponential.end())
      continue;
    const Line line = fit_exponential(steps);
    checks.between("slope of log(error) over N^{1/3}", line.slope, -2., -0.3);
    checks.between("correlation", line.correlation, -1., -expected->second.second);
    checks.that("unknowns for an error of 1e-6",
                std::any_of(steps.begin(), steps.end(), [&](const GradedStep &step) {
                  return step.error <= 1e-6 && step.n_unknowns <= expected->second.first;
                }));
  }
}

/** Scenes by expressions; nu = 0.4999 does not lock. */
void check_files(Checks &checks) {
  for (const auto &[name, setting] : {std::pair("nearly_incompressible", "Constants/nu=0.4999"),
                                      std::pair("two_contact_sides", "Output/VTU=none")}) {
    checks.about(name);
    std::vector<std::string> overrides = graded("1e-6");
    overrides.emplace_back(setting);
    check_estimate(checks, solve_file(SOURCE_DIR "/prm/" + std::string(name) + ".prm", overrides));
  }
}

/** A disc and a plane: four ends of contact, two of which lie in one patch of the first meshes.
 * Deep layers would fill that patch with cells. */
void check_two_things(Checks &checks) {
  checks.about("disc and plane");
  std::vector<std::string> overrides = graded("1e-3");
  overrides.emplace_back(
    "Contact/Foundation=circle 0.3,-0.3 radius 0.3 | plane 0,-0.01 normal 0,1");
  const StudyResult<2> result = solve(
    "Boundary/Clamped = top\nBoundary/Contact = bottom\nLoad/Body force = 0; -0.1\n", overrides);
  checks.that("the target is reached", result.verdict.outcome == Outcome::certified);
  checks.between("relative bound", last(result, "bound_relative"), 0., 1e-3);
  for (std::size_t k = 2; k < result.levels.size(); ++k)
    checks.between("growth of the unknowns",
                   static_cast<double>(result.levels[k].sizes.dofs) /
                     static_cast<double>(result.levels[k - 1].sizes.dofs),
                   1., 6.);
}

/** Cells at the ends of contact become 1e-9 of the body. Rounding of their corners leaves them
 * without 1e-7 of their tractions, but not without a force: there is a bound. */
void check_turning_plate(Checks &checks) {
  if (!checks.is_long())
    return;
  checks.about("turning plate");
  std::vector<std::string> overrides = graded("1e-6");
  overrides.insert(overrides.end(),
                   {"Discretization/Coarsest level=0", "Load cases/Cases=", "Load cases/Fields="});
  const StudyResult<2> result = solve_file(SOURCE_DIR "/prm/pressed_by_force.prm", overrides);
  checks.that("certified", result.verdict.outcome == Outcome::certified);
  checks.between("relative bound", last(result, "bound_relative"), 0., 1e-6);
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv,
                   {check_catalogue, check_files, check_two_things, check_turning_plate});
}
