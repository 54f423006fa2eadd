// SPDX-License-Identifier: LGPL-2.1-or-later
// The bound with friction: brackets of the energy on all levels contain the same number, the error
// of the contact force is not larger than its bound, and Coulomb's law has a conditional bound
// only. Bounds of scenes with a known solution are compared with their errors in true_error.cc.

#include <cmath>

#include "bounded.h"
#include "study_helpers.h"
#include "tests.h"

using namespace Signorini;

namespace {
const std::string tresca = "Boundary/Contact = bottom\nContact/Friction = tresca\n";

/** Scenes without a known solution: supports and loads of all kinds, bounds of friction that jump
 * or vanish, foundations that move. */
struct Described {
  std::string name, text;
};

const std::vector<Described> scenes = {
  {"pressed and dragged", tresca + "Boundary/Displacement = top: 0.03*(1+x); -0.05\n"
                                   "Contact/Friction bound = 0.05\n"},
  {"the bound of friction vanishes in a point",
   tresca + "Boundary/Rollers = left\nBoundary/Traction = top: 0.02; -0.02*(1+x)\n"
            "Contact/Friction bound = 0.02*(1+sin(5*x))\n"},
  {"the bound of friction jumps",
   tresca + "Boundary/Displacement = top: 0.03; -0.05\nDiscretization/Kinks at x = 0.4\n"
            "Contact/Friction bound = x < 0.4 ? 0.02 : 0.06\n"},
  {"held by friction far below its bound",
   tresca + "Boundary/Rollers = left\nBoundary/Traction = top: -0.02; -0.05*(1+x)\n"
            "Contact/Gap = 0.01*sin(4*x)\nContact/Foundation shift = -0.05*x^2\n"
            "Contact/Friction bound = 20\n"},
  {"held by nothing but contact and friction",
   tresca + "Boundary/Traction = top: 0.02; -0.1\nContact/Friction bound = 0.05\n"},
  {"a roller that is oblique, and an inclined foundation",
   "Geometry/Shape = polygon\nGeometry/Vertices = 0,0; 1,0; 1.2,1.1; 0.5,1.6; -0.1,1\n"
   "Material/Young's modulus = exp(x)\nBoundary/Contact = side0\nBoundary/Rollers = side1\n"
   "Boundary/Traction = side3: 0.005; -0.027*(1+x)\nContact/Friction = tresca\n"
   "Contact/Friction bound = 0.03+0.02*x\n"},
  {"two contact sides that meet",
   "Contact/Friction = tresca\nBoundary/Contact = bottom, right\n"
   "Boundary/Displacement = top: 0; -0.03\n"
   "Contact/Friction bound = bottom: 0.02 | right: 0.01\nContact/Gap = 0\n"}};

void brackets(Checks &checks) {
  for (const Described &given : scenes) {
    double lower = -1e300, upper = 1e300, coarser = 0.;
    for (const unsigned int number : {2U, 3U, 4U}) {
      checks.about(given.name + ", level " + std::to_string(number));
      const Bounded level(given.text, number);
      checks.that("guaranteed", level.bound.absolute && level.bound.is_guaranteed());
      if (!level.bound.absolute)
        continue;
      lower = std::max(lower, *level.bound.energy_lower);
      upper = std::min(upper, *level.bound.energy_upper);
      checks.that("falls", coarser == 0. || *level.bound.absolute < 0.8 * coarser);
      coarser = *level.bound.absolute;
      checks.between("bound / estimate", coarser / level.solution.record.estimate->energy, 0.9,
                     number == 4 ? 1.8 : 1e10);
    }
    checks.about(given.name);
    checks.that("energies", lower <= upper);
  }
}

/** T1: int p = -5/8. */
void contact_force(Checks &checks) {
  for (const unsigned int number : {3U, 4U}) {
    const Bounded level(named_scene("T1"), number);
    checks.about("force of T1, level " + std::to_string(number));
    const double error = std::abs(level.solution.record.contact.normal_force - 0.625);
    checks.between("error / bound", error / *level.bound.force_error, 0., 1.);
  }
}

void coulomb(Checks &checks) {
  const Bounded level(named_scene("K1"), 4);
  checks.that("K1: the bound is conditional",
              level.bound.absolute && !level.bound.is_guaranteed() && level.bound.is_conditional &&
                !level.bound.energy_lower && !level.bound.force_error);
  checks.that("K1: not certified", solve(named_scene("K1"), levels(2, 4)).verdict.outcome ==
                                     Outcome::equations_certified);
  checks.that("T1: certified",
              solve(named_scene("T1"), levels(2, 4)).verdict.outcome == Outcome::certified);
}

/** Constant stresses: sticking at q = 0.05 < s, and slipping at q = s. */
void patch_test(Checks &checks) {
  for (const std::string bound : {"0.1", "0.05"}) {
    const Bounded level(
      tresca +
        "Material/Young's modulus = 2.5\nMaterial/Poisson's ratio = 0.25\n"
        "Boundary/Displacement = top: 0; 0 | left: 0.05*(1-y); 0.125*(1-y) | "
        "right: 0.05*(1-y); 0.125*(1-y)\nContact/Gap = -0.125\nContact/Friction bound = " +
        bound + "\nContact/Foundation shift = " + (bound == "0.1" ? "0.05" : "0.07") + "\n",
      3);
    checks.about("constant stress, s = " + bound);
    checks.between("bound", *level.bound.relative, 0., 1e-6);
  }
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv, {brackets, contact_force, coulomb, patch_test});
}
