// SPDX-License-Identifier: LGPL-2.1-or-later
// Friction on graded meshes: exponential convergence to known solutions, whether the ends of zones
// are nodes of the mesh or have to be found.

#include <signorini/postprocessing/quantities/friction.h>
#include <signorini/verification/catalogue/catalogue.h>

#include <cmath>

#include "driver/study/graded_steps.h"
#include "study_helpers.h"
#include "tests.h"

using namespace Signorini;

namespace {
/** Solves a scene of the catalogue. @param is_known whether its kinks are lines of the mesh. */
StudyResult<2> solve_graded(const std::string &name, const std::string &target,
                            const bool is_known) {
  const Parameters parameters = parse_parameters(named_scene(name), "test", graded(target));
  Scene<2> scene = make_scene<2>(parameters, named_scenes());
  if (!is_known)
    scene.kinks = Kinks<2>();
  return run(parameters, scene);
}

/** A scene with its target, the unknowns that suffice for it, and T and the dissipation. */
struct Expectation {
  std::string scene, target;
  double n_unknowns, tangential_force, dissipation;
};

/** In TS q = -1 + 9/4 (xi-x)_+^{1/2} and u_t = (x-xi)_+^{3/2}, xi = 1/sqrt(2). */
const double xi = std::sqrt(0.5);
const std::vector<Expectation> expectations = {
  {"TS", "1e-6", 9000., -1. + 1.5 * std::pow(xi, 1.5), 0.4 * std::pow(1. - xi, 2.5)},
  {"KS", "1e-6", 8000., NAN, NAN},
  {"KO", "1e-5", 10000., NAN, NAN},
  {"CM", "1e-4", 21000., 0.0265437760, NAN}};

void check_scene(Checks &checks, const Expectation &expected, const bool is_known) {
  checks.about(expected.scene + (is_known ? ", known ends" : ", ends that are found"));
  const StudyResult<2> found = solve_graded(expected.scene, expected.target, is_known);
  const bool is_tresca = expected.scene.front() == 'T';
  checks.that("verdict", found.verdict.outcome ==
                           (is_tresca ? Outcome::certified : Outcome::accuracy_estimated));
  const std::vector<GradedStep> steps = steps_of(found.levels);
  checks.between("correlation of log(error) and N^{1/3}", fit_exponential(steps).correlation, -1.,
                 -0.97);
  checks.between("error", steps.back().error, 0., std::stod(expected.target));
  checks.between("unknowns", steps.back().n_unknowns, 0., expected.n_unknowns);
  for (const GradedStep &step : steps)
    checks.between("estimate over error, step " + std::to_string(step.number),
                   step.estimate / step.error, 0.8, step.number > 1 ? 8. : 50.);
  if (is_tresca)
    checks.between("bound over error", last(found, "bound_energy") / last(found, "u_energy"), 1.,
                   1.5);
  // Forces and works converge twice as fast as the energy norm.
  const double small = 1e-3 * std::stod(expected.target);
  if (!std::isnan(expected.tangential_force))
    checks.near("T", last(found, "tangential_force"), expected.tangential_force, small);
  if (!std::isnan(expected.dissipation))
    checks.near("dissipation", last(found, "dissipation"), expected.dissipation, small);
  const TangentialSummary &friction = *found.levels.back().tangential;
  if (expected.scene == "TS" || expected.scene == "KS") {
    const ZoneEnd &end = friction.stick_zones.at(0).end;
    checks.near("stick ends at 1/sqrt(2)", end.at.arc_length, xi, 2. * end.uncertainty);
    checks.between("uncertainty", end.uncertainty, 0., 1e-3);
    checks.near("stick and slip", friction.stick_length + friction.slip_length, 1., 1e-12);
  }
}

void test_exponential(Checks &checks) {
  for (const Expectation &expected : checks.rows(expectations, 1))
    for (const bool is_known : {true, false})
      check_scene(checks, expected, is_known);
}

StudyResult<2> solve_scene(const std::string &name, const std::string &target) {
  return solve_file(SOURCE_DIR "/prm/friction/" + name + ".prm", graded(target));
}

/** Hild's block: N and T on uniform meshes with 32 and 128 cells tend to those of the graded mesh.
 */
void test_limit_of_levels(Checks &checks) {
  const StudyResult<2> found = solve_scene("hild_block", "1e-4");
  const auto check = [&](const std::string &column, const double with_32, const double with_128) {
    checks.between(column + ": distances of 128 and of 32 cells",
                   (last(found, column) - 1e6 * with_128) / (last(found, column) - 1e6 * with_32),
                   0., 0.2);
  };
  check("contact_force_n", 5.6537069252e-02, 5.6452776395e-02);
  check("tangential_force", -8.0139940624e-04, -8.4000041845e-04);
}

/** A block that contact and friction alone hold: P is a sum of several corrections, and patches
 * that slip have to stay exactly at their bounds. */
void test_free_body(Checks &checks) {
  const StudyResult<2> found = solve_scene("sliding_block", "1e-3");
  const TangentialSummary &friction = *found.levels.back().tangential;
  checks.near("zones of stick and slip",
              {double(friction.stick_zones.size()), double(friction.slip_zones.size())}, {1., 1.},
              0.);
  checks.near("T/N", friction.tangential_force / last(found, "contact_force_n"), -0.4, 1e-9);
}

void check_sticking(Checks &checks, const std::string &scene) {
  const StudyResult<2> found = solve(scene + "\nContact/Friction = coulomb", graded("1e-3"));
  checks.that("accuracy estimated", found.verdict.outcome == Outcome::accuracy_estimated);
  const LevelRecord &finest = found.levels.back();
  checks.between("KKT residual", finest.dual.kkt, 0., 1e-13);
  // Slip needs a pressure that is small there.
  checks.between("dissipation over energy",
                 finest.tangential->dissipation / std::abs(finest.certificate.energy), 0., 0.05);
}

/** Strongly sheared bodies with stick almost without limit: Newton's sets come back or wander, and
 * the path of solutions ends where they are valid. */
void test_stick_without_limit(Checks &checks) {
  const std::vector<std::array<std::string, 3>> scenes = {{"0.02; -0.03", "0.02*(x-0.4)^2", "10"},
                                                          {"-0.067; -0.001", "0", "10"},
                                                          {"0.024; -0.016", "0", "1e6"}};
  for (const auto &[displacement, gap, f] : scenes) {
    checks.about("f = " + f + ", displacement " + displacement);
    check_sticking(checks, "Boundary/Displacement = top: " + displacement +
                             "\nBoundary/Contact = bottom\nContact/Gap = " + gap +
                             "\nContact/Friction coefficient = " + f);
  }
  checks.about("f = 50, held by two contact sides");
  check_sticking(
    checks,
    "Boundary/Traction = top: 0.01; -0.05\nBoundary/Contact = bottom right\nContact/Gap = 0\n"
    "Contact/Friction coefficient = 50");
}

/** A coefficient with which other patches stick and slip on each mesh: the run ends with that
 * reason where a finer mesh does not lessen the estimate. */
void test_states_that_differ(Checks &checks) {
  const StudyResult<2> found =
    solve("Boundary/Clamped = top\nBoundary/Contact = bottom\nContact/Gap = -0.02\n"
          "Contact/Friction = coulomb\nContact/Friction coefficient = 1000\n"
          "Contact/Foundation shift = 0.05*x\n",
          graded("1e-3"));
  checks.between("steps", found.levels.size(), 1., 6.);
  checks.between("KKT residual", found.levels.back().dual.kkt, 0., 1e-13);
  checks.that("the reason",
              found.verdict.reason.find("other patches stick and slip") != std::string::npos);
}

/** Load steps on the last mesh, whose smallest faces have 1e-10 of the length of the largest. */
void test_steps(Checks &checks) {
  const StudyResult<2> found = solve_scene("dragged_block", "1e-4");
  checks.that("accuracy estimated", found.verdict.outcome == Outcome::accuracy_estimated);
  checks.near("steps", found.levels.back().load_cases->n_cases, 53., 0.);
  checks.between("KKT residuals", found.levels.back().load_cases->max_kkt, 0., 1e-11);
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv,
                   {test_exponential, test_limit_of_levels, test_free_body,
                    test_stick_without_limit, test_states_that_differ, test_steps});
}
