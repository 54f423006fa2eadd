// SPDX-License-Identifier: LGPL-2.1-or-later
// Answers of graded meshes without an exact solution: they lie within the bounds of nested levels,
// are found where the first mesh misses the contact, and are not claimed where unknowns run out.

#include <deal.II/base/numbers.h>

#include <cmath>

#include "graded_steps.h"
#include "tests.h"

using namespace Signorini;

namespace {
void check_agreement(Checks &checks) {
  for (const std::string name : {"block_on_parabola", "pressed_plate"}) {
    checks.about(name);
    const auto study = [&](const std::vector<std::string> &overrides) {
      return solve_file(SOURCE_DIR "/prm/" + name + ".prm", overrides);
    };
    // Brackets belong to the finest level of a study.
    const StudyResult<2> coarse = study(levels(5, 5)), fine = study(levels(6, 6)),
                         found = study(graded("1e-5"));
    checks.that("both are certified", fine.verdict.outcome == Outcome::certified &&
                                        found.verdict.outcome == Outcome::certified);
    const LevelRecord &step = found.levels.back();
    const double J = step.certificate.energy;
    for (const StudyResult<2> *nested : {&coarse, &fine}) {
      const LevelRecord &level = nested->levels.back();
      // The brackets hold J(u); J(u_h) is as far away as the square of the error.
      const double slack = std::pow(*step.bound->absolute, 2);
      checks.between("energy in the brackets", J, *level.bound->energy_lower - slack,
                     *level.bound->energy_upper + slack);
      checks.near("contact force", level.contact.normal_force, step.contact.normal_force,
                  level.bound->force_error.value());
    }
    // Levels 5 and 6 differ by more than level 6 is wrong.
    const double peak = last(fine, "peak_pressure");
    checks.near("peak pressure", peak, last(found, "peak_pressure"),
                std::abs(peak - last(coarse, "peak_pressure")));
    checks.near("length of contact", step.contact.length, last(fine, "contact_length"),
                2. * fine.levels.back().sizes.H);
    // |J(u_h) - J(u)| <= (|||u - u_h|||^2 + contact part)/2: digits are twice those of the error.
    const LevelRecord &before = *(found.levels.end() - 2);
    checks.near(
      "energy of the last two steps", before.certificate.energy, J,
      std::pow(before.estimate->relative * step.estimate->energy / step.estimate->relative, 2));
  }
}

/** The tip of a parabola touches between the nodes of the first mesh: half of the zone is
 * (0.002/20)^{1/2} = 0.01 wide, if the body were rigid. */
void check_missed_contact(Checks &checks) {
  const std::string scene =
    "subsection Geometry\n set Upper right = 4, 1\n set Cells = 4, 1\n end\n"
    "subsection Boundary\n set Contact = bottom\n set Displacement = top: 0; -0.002\n end\n"
    "subsection Contact\n set Gap = 20*(x-1.23)^2\n end\n";
  double force = 0.;
  for (const std::string level : {"0", "1", "2"}) {
    checks.about("Tip, from level " + level);
    std::vector<std::string> overrides = graded("1e-4");
    overrides.push_back("Discretization/Coarsest level=" + level);
    const StudyResult<2> result = solve(scene, overrides);
    const LevelRecord &first = result.levels.front(), &step = result.levels.back();
    checks.that("missed at first, and no error is claimed",
                first.contact.normal_force == 0. && !first.estimate);
    checks.that("found and resolved", result.verdict.outcome == Outcome::certified);
    const std::vector<ContactZone> &zones = step.answer.zones;
    checks.near("one zone", zones.size(), 1, 0.);
    checks.near("its middle", 0.5 * (zones.at(0).start.at.point[0] + zones[0].end.at.point[0]),
                1.23, 1e-4);
    checks.between("its length", step.contact.length, 1e-3, 0.02);
    force = force == 0. ? step.contact.normal_force : force;
    checks.near("the same force", step.contact.normal_force / force, 1., 1e-4);
  }
}

/** Nothing deforms the body, and the foundation touches it in one point. */
void check_body_at_rest(Checks &checks) {
  const StudyResult<2> result =
    solve("subsection Boundary\n set Clamped = top\n set Contact = bottom\n end\n"
          "subsection Contact\n set Foundation = circle 0.5,-1 radius 1\n end\n",
          {"Discretization/Strategy=hp"});
  checks.about("A body at rest");
  checks.that("meshes that do not change end the run", result.levels.size() < 20);
  checks.near("no force", last(result, "contact_force_n"), 0., 1e-12);
}

/** A ring that its foundation presses by so little that the gap has few digits: the bound ends
 * above its target in seconds, and no step before the last has a smaller one. */
void check_best_step(Checks &checks) {
  checks.about("A gap of rounding");
  const double delta = 1e-12;
  const StudyResult<2> result =
    solve("Geometry/Shape = ring\nBoundary/Clamped = inner\nBoundary/Contact = outer\n"
          "Contact/Foundation = circle 0,0 radius 1-1e-12 inside\n",
          {"Discretization/Strategy=hp", "Discretization/Target error=1e-3",
           "Discretization/Maximum unknowns=4000"});
  const LevelRecord &best = result.levels.back();
  checks.that("the target is missed", result.verdict.outcome == Outcome::not_resolved);
  for (const LevelRecord &level : result.levels)
    checks.that("no smaller bound", bound_of(level).value_or(1.) >= *bound_of(best));
  // u_r = A r + B/r, u_r(a) = 0, u_r(1) = -delta, a = 1/2.
  const double a2 = 0.25, A = -delta / (1. - a2), B = -A * a2;
  const double lame = 0.3 / (1.3 * 0.4), mu = 0.5 / 1.3;
  const double pressure = -(2. * (lame + mu) * A - 2. * mu * B);
  checks.near("mean pressure", best.contact.normal_force / (2. * dealii::numbers::PI) / pressure,
              1., 0.01);
}

void check_too_few_unknowns(Checks &checks) {
  std::vector<std::string> overrides = graded("1e-6");
  overrides.emplace_back("Discretization/Maximum unknowns=3000");
  const StudyResult<2> result = solve(named_scene("B1"), overrides);
  checks.about("3000 unknowns");
  checks.that("not resolved, but solved",
              result.verdict.outcome == Outcome::not_resolved && result.verdict.equations_hold());
  checks.that("no step has more", result.levels.back().sizes.dofs <= 3000);
  const std::string &reason = result.verdict.reason;
  checks.that("one sentence names the parameter",
              reason.find("raise Maximum unknowns, ") != std::string::npos &&
                reason.find(". ") == std::string::npos && reason.find('\n') == std::string::npos);
}

/** Along a curve the misfit falls like the root of the cells' size: a run that cannot come to the
 * target ends when it has seen contact. */
void check_moduli_on_a_curve(Checks &checks) {
  const StudyResult<2> result =
    solve("subsection Boundary\n set Contact = bottom\n set Displacement = top: 0; -0.03\n end\n"
          "subsection Material\n set Young's modulus = (x-0.5)^2+(y-0.5)^2<0.01 ? 5 : 1\n end\n",
          {"Discretization/Strategy=hp", "Discretization/Target error=1e-3", "Output/VTU=none"});
  checks.about("Moduli that jump on a curve");
  checks.near("steps", result.levels.size(), 2, 0.);
  checks.that("not resolved, with a bound",
              result.verdict.outcome == Outcome::not_resolved && bound_of(result.levels.back()));
}

/** The graded mesh is that of the scene: a case that touches where the scene does not, with a
 * corner of the body, has a large error and says so. Nested meshes solve it, and so does the scene
 * that the remedy names. */
void check_load_cases(Checks &checks) {
  const auto with_cases = [](const std::string &y, const std::string &cases,
                             std::vector<std::string> overrides) {
    overrides.push_back("Load cases/Cases=" + cases);
    return solve("Boundary/Clamped = top\nBoundary/Contact = bottom\n"
                 "Contact/Foundation = circle 1.2,-0.5+" +
                   y + " radius 0.5\n",
                 overrides);
  };
  const std::string moved = "shift y 0 to 0.1 in 2 cases";
  const auto check = [&](const std::string &name, const StudyResult<2> &found, const double least,
                         const double most, const bool is_solved) {
    checks.about(name);
    checks.between("largest estimate", found.levels.back().load_cases->max_estimate, least, most);
    checks.that("verdict", is_solved ? found.verdict.is_certified()
                                     : found.verdict.outcome == Outcome::not_resolved);
  };
  const StudyResult<2> wrong = with_cases("0", moved, graded("1e-3"));
  check("A case that touches where the scene does not", wrong, 1e-2, 1., false);
  checks.that("the reason names it",
              wrong.verdict.reason.find("load case ") != std::string::npos &&
                wrong.verdict.reason.find("Strategy = nested") != std::string::npos);
  check("The same on nested meshes",
        with_cases("0", moved,
                   {"Discretization/Strategy=nested", "Discretization/Coarsest level=3",
                    "Discretization/Finest level=6", "Output/VTU=none"}),
        1e-3, 0.2, true);
  check("A case that touches as the scene does",
        with_cases("0.1", "shift y -0.002 to 0 in 2 cases", graded("1e-3")), 1e-6, 1e-2, true);
}

/** A half disc that turns about its centre on its rollers, until its flat side presses. Its pin is
 * a node that hanging nodes follow. Rollers have no moment about the centre, so that contact has
 * that of the load, -int y f_x = -0.01 int y^2 = -0.01 pi/8, turned round. */
void check_rollers_on_an_arc(Checks &checks) {
  const StudyResult<2> result = solve("Geometry/Shape = half disc\nBoundary/Rollers = arc\n"
                                      "Boundary/Contact = flat\nLoad/Body force = 0.01*y; -0.1\n",
                                      graded("1e-3"));
  checks.about("Rollers on an arc");
  checks.that("certified", result.verdict.is_certified());
  checks.near("moment of contact",
              result.levels.back().answer.contact_force.resultant.moment[0] /
                (0.01 * dealii::numbers::PI / 8.),
              1., 1e-6);
}

/** A force presses a plate towards the foundation of the contact side beside it: no displacement of
 * finite energy has u_n <= 0 on one side of the corner and u_n = travel on the other. The run says
 * so on a mesh whose equations are solved. */
void check_plate_into_the_foundation(Checks &checks) {
  const StudyResult<2> result = solve("Boundary/Contact = bottom\nBoundary/Plates = right: 0, -1\n"
                                      "Load/Plate force = right: 0.02\nContact/Friction = coulomb\n"
                                      "Contact/Friction coefficient = 0.2\n",
                                      graded("0.01"));
  checks.about("Plate into the foundation");
  checks.that("not resolved", result.verdict.outcome == Outcome::not_resolved);
  checks.that("few steps", result.levels.size() <= 4);
  checks.that("reason",
              result.verdict.reason.find("no displacement of finite energy") != std::string::npos);
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv,
                   {check_agreement, check_missed_contact, check_body_at_rest, check_best_step,
                    check_too_few_unknowns, check_moduli_on_a_curve, check_load_cases,
                    check_rollers_on_an_arc, check_plate_into_the_foundation});
}
