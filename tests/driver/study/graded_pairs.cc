// SPDX-License-Identifier: LGPL-2.1-or-later
// Two elastic bodies on graded meshes against an independent program, closed forms, and themselves
// with exchanged roles.

#include <cmath>

#include "graded_steps.h"
#include "study_helpers.h"
#include "tests.h"

using namespace Signorini;

namespace {
/** Two bodies with nu = 0.3, their right halves. */
struct Pair {
  std::string name, shapes, E, boundary, gap;
  /** The vertical force and the energy of another program, in plane strain, to 1e-9: elements of
   * degree 12 at most, with the mean normals on curved sides. */
  double force, energy;
  /** The exponent of both wedges at a corner of a punch, as another program has it; 1: no corner.
   */
  double exponent = 1.;
};

const std::string block = "Geometry/Lower left = a: 0, 0 | b: 0, -1\n",
                  lowered = "a.left a.top b.left b.bottom",
                  ring = "Geometry/Shape = a: polygon | b: rectangle\n"
                         "Geometry/Vertices = a: 0,0; arc 0,1 ccw; 1,1; 0.4,1; arc 0,1 cw; 0,0.6\n"
                         "Geometry/Lower left = b: 0, -1\nGeometry/Upper right = b: 1.2, 0\n",
                  // The gap of a ring that is lowered by 0.02, along the mean normal.
  on_block = "-0.02*cos(0.5*atan2(x,1-y))";

const std::vector<Pair> pairs = {
  {"punch", block + "Geometry/Upper right = a: 0.5, 0.5 | b: 1.5, 0\n", "a: 1 | b: 1",
   "Contact = a.bottom with b.top\nBoundary/Rollers = " + lowered, "-0.02", 8.6309907219e-3,
   8.6309907219e-5, 0.7740},
  {"punch on a stiffer block", block + "Geometry/Upper right = a: 0.5, 0.5 | b: 1.5, 0\n",
   "a: 1 | b: 10", "Contact = a.bottom with b.top\nBoundary/Rollers = " + lowered, "-0.02",
   1.8983576180e-2, 1.8983576180e-4, 0.9622},
  {"receding strip", block + "Geometry/Upper right = a: 2, 0.5 | b: 3, 0\n", "a: 1 | b: 1",
   "Contact = a.bottom with b.top\nBoundary/Rollers = a.left b.left b.bottom\n"
   "Boundary/Traction = a.top: 0; -0.01*exp(-4*x^2)",
   "0", 4.4311345590e-3, -1.8162172825e-5},
  {"roller on a block", ring, "a: 1 | b: 1",
   "Contact = a.side0 with b.top\nBoundary/Rollers = a.side3 a.side1 b.left b.bottom", on_block,
   1.951302496e-3, 1.839253299e-5},
  {"roller on a softer block", ring, "a: 1 | b: 0.1",
   "Contact = a.side0 with b.top\nBoundary/Rollers = a.side3 a.side1 b.left b.bottom", on_block,
   4.776735882e-4, 4.410398417e-6}};

StudyResult<2> solve_to(const std::string &text, const std::string &target) {
  return solve("Geometry/Bodies = a b\n" + text,
               {"Discretization/Strategy=hp", "Discretization/Coarsest level=1",
                "Discretization/Target error=" + target, "Output/VTU=none"});
}

double force_of(const StudyResult<2> &result) {
  return std::abs(result.levels.back().answer.contact_by_side[0].resultant.force[1]);
}

/** Forces and energies to 1e-8; where both sides are straight, the bound is guaranteed. */
void test_references(Checks &checks) {
  for (const Pair &pair : pairs) {
    checks.about(pair.name);
    const StudyResult<2> result = solve_to(pair.shapes + "Material/Young's modulus = " + pair.E +
                                             "\nMaterial/Poisson's ratio = 0.3\n" + "Boundary/" +
                                             pair.boundary + "\nContact/Gap = " + pair.gap + "\n",
                                           "1e-5");
    checks.that("certified", result.verdict.is_certified());
    checks.near("vertical force", force_of(result) / pair.force, 1., 1e-8);
    checks.near("energy", last(result, "energy") / pair.energy, 1., 1e-8);
    const auto &growth = result.levels.back().answer.peak_pressure->grows_at;
    checks.near("growth of the pressure", growth ? growth->exponent : 1., pair.exponent, 2e-4);
    if (pair.shapes == ring)
      continue;
    checks.that("the bound is guaranteed", is_guaranteed(result.levels.back()));
    checks.that("the energy lies in its interval",
                last(result, "energy_lower") <= pair.energy + 1e-9 * std::abs(pair.energy) &&
                  pair.energy - 1e-9 * std::abs(pair.energy) <= last(result, "energy_upper"));
  }
}

/** Friction changes the exponent at the corner of a punch: those of another program where it
 * sticks, and where it slides with q = 0.3 p. */
void test_growth_with_friction(Checks &checks) {
  for (const auto &[friction, exponent] :
       {std::pair("tresca\nContact/Friction bound = 1000", 0.5445),
        {"coulomb\nContact/Friction coefficient = 0.3", 0.6380}}) {
    const Pair &punch = pairs[0];
    const StudyResult<2> result =
      solve_to(punch.shapes + "Material/Young's modulus = " + punch.E +
                 "\nMaterial/Poisson's ratio = 0.3\nBoundary/" + punch.boundary +
                 "\nContact/Gap = " + punch.gap + "\nContact/Friction = " + friction + "\n",
               "1e-2");
    const auto &growth = result.levels.back().answer.peak_pressure->grows_at;
    checks.near("growth with " + std::string(friction), growth ? growth->exponent : 1., exponent,
                2e-4);
  }
}

/** The pressure of a press fit is uniform: p = d / (b (u_1 + u_2)) by Lame's formulas. */
void test_press_fit(Checks &checks) {
  const double a = 0.5, b = 1., c = 1.5, E = 3., nu = 0.25, interference = 1e-3;
  const auto radial = [&](const double modulus, const double ratio, const double sign) {
    return b / (modulus / (1. - nu * nu)) * (ratio + sign * nu / (1. - nu));
  };
  const double p = interference / (radial(1., (b * b + a * a) / (b * b - a * a), -1.) +
                                   radial(E, (c * c + b * b) / (c * c - b * b), 1.));
  const StudyResult<2> result =
    solve_to("Geometry/Shape = a: ring | b: ring\nGeometry/Radius = a: 1 | b: 1.5\n"
             "Geometry/Inner radius = a: 0.5 | b: 1\nMaterial/Young's modulus = a: 1 | b: 3\n"
             "Material/Poisson's ratio = 0.25\nBoundary/Contact = a.outer with b.inner\n"
             "Contact/Gap = -0.001\n",
             "1e-6");
  checks.near("press fit", last(result, "peak_pressure") / p, 1., 1e-6);
}

/** Both sides may be named first. Where a formula belongs to the first one, it stays the first:
 * then forces differ by the square of a/R = 0.06. The normals of one side would cost six
 * thousandths here, where moduli differ by ten. */
void test_exchanged_roles(Checks &checks) {
  const auto force = [](const std::string &contact) {
    return force_of(solve_to(
      "Geometry/Shape = a: half disc | b: rectangle\nGeometry/Centre = a: 0, 1\n"
      "Geometry/Radius = a: 1\nGeometry/Lower left = b: -1, -1\nGeometry/Upper right = b: 1, 0\n"
      "Geometry/Cells = b: 2, 1\nMaterial/Young's modulus = a: 1 | b: 10\nBoundary/Contact = " +
        contact + "\nBoundary/Clamped = b.bottom\nBoundary/Displacement = a.flat: 0; -0.005\n",
      "1e-4"));
  };
  const double first = force("a.arc with b.top");
  checks.near("exchanged roles", force("b.top with a.arc") / first, 1., 1e-12);
  checks.near("exchanged roles with a formula",
              force("b.top with a.arc\nContact/Gap = 0*x") / first, 1., 3e-4);
}

/** A roller between two plates: one side in two pairs. Its lower half is the whole by symmetry. */
void test_side_in_two_pairs(Checks &checks) {
  const StudyResult<2> whole =
    solve("Geometry/Bodies = u r l\nGeometry/Shape = u: rectangle | r: disc | l: rectangle\n"
          "Geometry/Lower left = u: -1.5, 1 | l: -1.5, -2\nGeometry/Radius = r: 1\n"
          "Geometry/Upper right = u: 1.5, 2 | l: 1.5, -1\nGeometry/Cells = u: 3, 1 | l: 3, 1\n"
          "Material/Young's modulus = u: 10 | r: 1 | l: 10\n"
          "Boundary/Contact = r.arc with u.bottom l.top\nBoundary/Clamped = l.bottom\n"
          "Boundary/Displacement = u.top: 0; -0.05\n",
          graded("1e-3"));
  const StudyResult<2> half = solve_to(
    "Geometry/Shape = a: half disc | b: rectangle\nGeometry/Centre = a: 0, 0\n"
    "Geometry/Radius = a: 1\nGeometry/Lower left = b: -1.5, -2\nGeometry/Upper right = b: 1.5, "
    "-1\nGeometry/Cells = b: 3, 1\nMaterial/Young's modulus = a: 1 | b: 10\n"
    "Boundary/Contact = a.arc with b.top\nBoundary/Rollers = a.flat\n"
    "Boundary/Displacement = b.bottom: 0; 0.025\n",
    "1e-4");
  const std::vector<ContactForce> &forces = whole.levels.back().answer.contact_by_side;
  checks.that("two pairs", forces.size() == 4);
  checks.near("the roller is in balance",
              forces[0].resultant.force[1] + forces[2].resultant.force[1], 0., 1e-12);
  checks.near("as much as its half", std::abs(forces[0].resultant.force[1]) / force_of(half), 1.,
              1e-3);
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv,
                   {test_references, test_growth_with_friction, test_press_fit,
                    test_exchanged_roles, test_side_in_two_pairs});
}
