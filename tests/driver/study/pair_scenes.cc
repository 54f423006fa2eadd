// SPDX-License-Identifier: LGPL-2.1-or-later
// Scenes with two elastic bodies in prm/bodies, against closed forms.

#include <signorini/postprocessing/quantities/case_solver.h>

#include <deal.II/base/numbers.h>

#include <cmath>

#include "one_level.h"
#include "study_helpers.h"
#include "tests.h"

using namespace Signorini;
using dealii::numbers::PI;

namespace {
const std::string folder = SOURCE_DIR "/prm/bodies/";

/** Two cylinders on graded meshes: peak and half width. Hertz has the limit for a/R -> 0, a/R =
 * 0.04.
 */
void test_graded_hertz(Checks &checks) {
  const StudyResult<2> result = solve_file(
    folder + "hertz.prm", {"Discretization/Strategy=hp", "Discretization/Coarsest level=1"});
  const double N = result.levels.back().answer.contact_by_side[0].resultant.force[1], R = 2.4,
               E = 1. / (0.91 * 1.25), a = std::sqrt(4. * N * R / (PI * E));
  checks.near("peak", last(result, "peak_pressure"), 2. * N / (PI * a), 4e-3 * 2. * N / (PI * a));
  checks.near("half width", 0.5 * result.levels.back().answer.zones.front().length, a, 4e-3 * a);
}

/** On nested meshes: the pressure of the middle patch, the half width, and how far the normals
 * turn.
 */
void test_hertz(Checks &checks) {
  const StudyResult<2> result = solve_file(folder + "hertz.prm", {"Discretization/Finest level=4"});
  const Answer &answer = result.levels.back().answer;
  const double N = last(result, "contact_force_n"), R = 2.4, E = 1. / (0.91 * 1.25),
               a = std::sqrt(4. * N * R / (PI * E)), peak = 2. * N / (PI * a),
               H = result.levels.back().sizes.H;
  // The mean over the patch [0, H].
  const double mean = peak * 0.5 * (std::sqrt(1. - H * H / (a * a)) + a / H * std::asin(H / a));
  checks.near("mean of the patch of the peak", answer.peak_pressure->mean, mean, 0.01 * mean);
  checks.near("half width", 0.5 * answer.zones.front().length, a, 0.25 * H);
  checks.near("turn of the normals", answer.turn_of_normals, a / R, H / R);
}

/** The lower arc ends inside of faces of the upper one, and its faces are not equally long: all
 * patches hold nodes of both sides. */
void test_narrow_arc(Checks &checks) {
  for (const char *radius : {"R2=4.5", "R2=8"}) {
    const StudyResult<2> result =
      solve_file(folder + "hertz.prm", {"w=0.8", radius, "Discretization/Finest level=2"});
    checks.that("a narrow arc is stable", !result.levels.back().sizes.unstable);
  }
}

/** A pin that hardly yields is the rigid one of prm/plate_with_hole.prm, whose patches are half as
 * long. */
void test_rigid_pin(Checks &checks) {
  const auto force = [](const std::string &file, const std::vector<std::string> &overrides) {
    std::vector<std::string> all = {"Discretization/Coarsest level=2",
                                    "Discretization/Finest level=2"};
    all.insert(all.end(), overrides.begin(), overrides.end());
    const StudyResult<2> result = solve_file(file, all);
    return result.levels.back().answer.contact_force.resultant.force[0];
  };
  const double rigid = force(folder + "../plate_with_hole.prm", {});
  checks.near("a rigid pin", force(folder + "pin_in_lug.prm", {"k=1e6"}), rigid,
              5e-3 * std::abs(rigid));
}

/** A block that lies on another one, under a plate that turns; what holds the lower one is contact
 * and a roller. */
std::string under_a_plate(const LoadCase &factors) {
  const auto times = [](const double factor, const std::string &text) {
    return std::to_string(factor) + "*" + text;
  };
  return "Geometry/Bodies = a b\nGeometry/Lower left = a: 0, 0 | b: 0.3, 1\n"
         "Geometry/Upper right = a: 2, 1 | b: 1.1, 1.6\nGeometry/Cells = a: 10, 4 | b: 6, 4\n"
         "Boundary/Contact = a.bottom | b.bottom with a.top\nBoundary/Rollers = a.left\n"
         "Boundary/Plates = b.top: 0, -1 turning\n"
         "Contact/Gap = a.bottom: 0.0004*(x-0.8)^2 | b.bottom: 0.001*(x-0.6)^2\n"
         "Load/Plate force = b.top: " +
         times(factors.force, "0.01") +
         "\nLoad/Plate moment = b.top: " + times(factors.force, "0.0005") +
         "\nLoad/Body force = a: 0; " + times(factors.weight, "(-0.002)") + " | b: 0; " +
         times(factors.weight, "(-0.006)") + "\n";
}

/** Equilibrium by hand, and a load case against a run of its own. */
void test_plates_and_cases(Checks &checks) {
  LoadCase factors;
  factors.force = 0.5;
  factors.weight = 2.;
  OneLevel level(under_a_plate(LoadCase()), 2);
  level.scene.load_cases = {factors};
  const LevelSolution<2> solution = level.solve();
  // Weights: 0.004 of a, 0.00288 of b. The moments are those about the origin.
  const std::vector<ContactForce> &forces = solution.record.answer.contact_by_side;
  const auto total = [](const SideForce &force) {
    return std::vector<double>{force.resultant.force[1], force.resultant.moment[0]};
  };
  checks.near("forces and moments of the plate's body", total(forces.at(1)),
              {0.01288, 0.7 * 0.01288 - 0.0005}, 1e-10);
  checks.near("  and of the other one", total(forces.at(0))[0], 0.01688, 1e-10);
  CaseSolver<2> solver(level.discretization, level.scene, *solution.operators, {});
  const CaseResult found = solver.solve(factors);
  const LevelSolution<2> own = OneLevel(under_a_plate(factors), 2).solve();
  checks.near("load case: P", distance(solver.contact().P.normal(), own.contact.P.normal()), 0.,
              1e-11);
  const PlateRecord &plate = own.record.motions.plates.at(0);
  checks.near("load case: plate and force",
              {found.plates.at(0).travel, found.plates.at(0).rotation[0], found.contact.force[1]},
              {plate.travel, plate.rotation[0], own.record.answer.contact_force.resultant.force[1]},
              1e-10);
}

/** A block on a wider base, one named first or the other: contact is where both are. */
void test_overlap(Checks &checks) {
  const std::string text =
    "Geometry/Bodies = base block\nGeometry/Lower left = base: -2, -1 | block: -0.5, 0\n"
    "Geometry/Upper right = base: 2, 0 | block: 0.5, 1\nGeometry/Cells = base: 8, 2 | block: 4, 4\n"
    "Boundary/Clamped = base.bottom\nBoundary/Displacement = block.top: 0; -0.01\n";
  for (const char *contact : {"base.top with block.bottom", "block.bottom with base.top"}) {
    const OneLevel level(text + "Boundary/Contact = " + contact + "\n", 2);
    const LevelSolution<2> solution = level.solve();
    const ContactZone &zone = solution.record.answer.zones.at(0);
    checks.near(
      "zone of the overlap",
      {zone.start.at.point[0], zone.end.at.point[0], zone.length, solution.record.contact.length},
      {-0.5, 0.5, 1., 1.}, 1e-12);
  }
  // The start of the disc's side lies in the overlap.
  const std::string disc =
    "Geometry/Bodies = disc wall\nGeometry/Shape = disc: disc | wall: rectangle\n"
    "Geometry/Lower left = wall: -2, -0.75\nGeometry/Upper right = wall: -1, 0.75\n"
    "Geometry/Cells = wall: 4, 6\nBoundary/Clamped = wall.left\n"
    "Load/Body force = disc: -0.01; 0 | wall: 0; 0\n";
  for (const char *contact : {"wall.right with disc.arc", "disc.arc with wall.right"}) {
    const LevelSolution<2> solution =
      OneLevel(disc + "Boundary/Contact = " + contact + "\n", 3).solve();
    const SideForce &force = solution.record.answer.contact_force;
    checks.near("a disc at a wall: force through its middle", std::abs(force.resultant.force[0]),
                0.01 * PI, 1e-3 * PI);
    checks.near("  moment", force.resultant.moment[0], 0., 1e-10);
  }
}

/** Friction across a clearance: the tractions act at points that are a gap apart, and their couple
 * is T times the gap. Each body is in balance. */
void test_couple(Checks &checks) {
  const std::string law[] = {"coulomb\nContact/Friction coefficient = 0.3\n",
                             "tresca\nContact/Friction bound = 0.0002\n"};
  for (const double clearance : {0.01, -0.005})
    for (const std::string &friction : law) {
      const std::string y = std::to_string(1. + clearance), top = std::to_string(2. + clearance);
      const LevelSolution<2> solution =
        OneLevel("Geometry/Bodies = low up\nGeometry/Lower left = low: 0, 0 | up: 0, " + y +
                   "\nGeometry/Upper right = low: 1, 1 | up: 1, " + top +
                   "\nBoundary/Contact = up.bottom with low.top\nBoundary/Clamped = low.bottom\n"
                   "Boundary/Displacement = up.top: 0.005; -0.03\nContact/Friction = " +
                   friction,
                 2)
          .solve();
      const std::vector<ContactForce> &forces = solution.record.answer.contact_by_side;
      checks.near("balance of moments", solution.record.certificate.moment_balance, 0., 1e-12);
      checks.near("couple", forces.at(0).resultant.moment[0] + forces.at(1).resultant.moment[0],
                  -clearance * forces[0].resultant.force[0], 1e-14);
      checks.that("  of a force", std::abs(forces[0].resultant.force[0]) > 1e-4);
    }
}

/** Two leaves; the load that presses the longer one at its end moves it away from the shorter one,
 * which follows. The energy of the lift is that of bending, and the bound names the end. */
void test_leaves(Checks &checks) {
  const LevelSolution<2> solution =
    OneLevel("Geometry/Bodies = a b\nGeometry/Lower left = a: 0, 0 | b: 0, 5\n"
             "Geometry/Upper right = a: 50, 5 | b: 100, 10\nGeometry/Cells = a: 10, 1 | b: 20, 1\n"
             "Material/Young's modulus = 210000\nBoundary/Contact = a.top with b.bottom | b.top\n"
             "Boundary/Clamped = a.left b.left\nContact/Gap = a.top: 0\n"
             "Contact/Foundation = b.top: circle 97, 14.9 radius 5\n"
             "Discretization/Target error = 0.5\n",
             3)
      .solve();
  checks.that("leaves: the place", solution.record.bound->worst_face.rfind("b.top at (97", 0) == 0);
  checks.between("leaves: the bound", solution.record.bound->relative.value_or(0.), 0.2, 3.);
}

const std::string revolved = "Material/Plane state = axisymmetric\nGeometry/Bodies = a b\n";

/** Bodies of revolution: Lame's press fit between smooth planes, and Hertz' ball on a block. */
void test_revolution(Checks &checks) {
  std::vector<double> errors;
  for (const unsigned int level : {2, 3}) {
    const LevelSolution<2> fit =
      OneLevel(
        revolved +
          "Geometry/Lower left = a: 1, 0 | b: 0.5, 0\nGeometry/Upper right = a: 2, 1 | b: 1, 1\n"
          "Geometry/Cells = a: 4, 4 | b: 2, 3\nMaterial/Young's modulus = a: 1 | b: 5\n"
          "Boundary/Contact = a.left with b.right\n"
          "Boundary/Rollers = a.top a.bottom b.top b.bottom\nContact/Gap = -0.01\n",
        level)
        .solve();
    // Plane strain: u = (1 + nu) r p/E ((1 - 2 nu) r^2 + s^2)/|s^2 - r^2|, s the free radius.
    const double exact = 0.01 / (1.3 * (0.4 + 4.) / 3. + 1.3 / 5. * (0.4 + 0.25) / 0.75);
    for (const double p : fit.contact.P.normal())
      checks.near("press fit: uniform", p, fit.contact.P.normal()[0], 1e-11);
    errors.push_back(std::abs(fit.contact.P.normal()[0] + exact) / exact);
  }
  checks.between("press fit: order", std::log2(errors[0] / errors[1]), 1.8, 2.2);
  checks.between("press fit: error", errors[1], 0., 2e-4);
  const StudyResult<2> ball = solve(
    revolved + "Geometry/Shape = a: polygon | b: rectangle\n"
               "Geometry/Vertices = a: 0,0; arc 0,1 ccw; 1,1; 0,1\nGeometry/Mesh size = a: 0.25\n"
               "Geometry/Lower left = b: 0, -1\nGeometry/Upper right = b: 1, 0\n"
               "Geometry/Cells = b: 8, 8\nBoundary/Plates = a.side1: 0, -1\n"
               "Boundary/Contact = a.side0 with b.top\nBoundary/Clamped = b.bottom\n"
               "Load/Plate force = a.side1: 4/3/1.82*0.2^3\n",
    levels(2, 4));
  const double radius = last(ball, "contact_length"), H = ball.levels.back().sizes.H;
  checks.near("ball: radius of contact", radius, 0.2, 0.5 * H);
  const double peak = 2. * 0.2 / (1.82 * PI);
  checks.near("ball: peak", ball.levels.back().answer.peak_pressure->mean, peak, 0.03 * peak);
}

/** Two blocks that are moved apart by different translations: nothing touches, and rounding is all
 * that the bound has left. */
void test_moved_apart(Checks &checks) {
  for (const std::string travel : {"1e-3", "0.1"}) {
    const StudyResult<2> found =
      solve("Geometry/Bodies = a b\nGeometry/Lower left = a: 0, 0 | b: 0, 1\n"
            "Geometry/Upper right = a: 1, 1 | b: 1, 2\n"
            "Boundary/Contact = a.top with b.bottom\n"
            "Boundary/Displacement = a.left: 0; -" +
              travel + " | b.left: 0; " + travel + "\n",
            levels(2, 4));
    checks.about("blocks moved apart by " + travel);
    checks.that("certified", found.verdict.outcome == Outcome::certified);
    checks.between("bound", found.levels.back().bound->relative.value_or(1.), 0., 1e-8);
  }
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv,
                   {test_moved_apart, test_graded_hertz, test_hertz, test_narrow_arc,
                    test_rigid_pin, test_plates_and_cases, test_overlap, test_couple, test_leaves,
                    test_revolution});
}
