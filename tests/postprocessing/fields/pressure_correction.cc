// SPDX-License-Identifier: LGPL-2.1-or-later
// z_h, by which the estimate sees that p_H is constant on patches: loads in closed form, the energy
// of z_h, and where z_h vanishes.

#include <signorini/discretization/space/internal_forces.h>
#include <signorini/error_control/estimate/error_estimate.h>
#include <signorini/error_control/estimate/pressure_correction.h>
#include <signorini/solvers/contact/compliance.h>

#include "one_level.h"
#include "solved_level.h"
#include "study_helpers.h"
#include "tests.h"

using namespace Signorini;
using dealii::Point;
using Vector = dealii::Vector<double>;

namespace {
std::string with_ratio(const std::string &text, const unsigned int ratio) {
  return text + entry("Discretization", "Patch ratio", std::to_string(ratio));
}

PressureCorrection correct(const SolvedLevel &given, const Pressure &P) {
  const ContactSolution contact = given.contact(given.U, P);
  return correct_by_finer_patches(Solved<2>(given.discretization, given.scene, contact),
                                  given.operators());
}

/** b.v for a function of V^h that is zero on the supports. */
double work(const Coupling &load, const Displacement &v) {
  return load.transpose_product(v)[0];
}

/** p = -1 - x from its means: int p v_n for v = (0, 1) and v = (0, x), where v_n = -v_2. */
void linear_pressure(Checks &checks) {
  const std::string sides = "subsection Boundary\nset Clamped = top\nset Contact = bottom\nend\n";
  for (const unsigned int ratio : {2U, 4U}) {
    const OneLevel level(with_ratio(sides, ratio), 3);
    const auto &patches = level.multipliers().surface().patches();
    Pressure P(patches.size());
    for (std::size_t k = 0; k < patches.size(); ++k)
      P[k] = -1. - patches[k].centre()[0];
    const Coupling load = recovered_load(level.space(), level.multipliers(), P);
    const auto up = [&](const auto &f) {
      return nodal_values(level.space(), [&](const Point<2> &x) {
        return x[1] < 1e-12 ? Point<2>(0., f(x[0])) : Point<2>();
      });
    };
    const std::string name = "H = " + std::to_string(ratio) + " h, linear pressure: ";
    checks.near(name + "force", work(load, up([](double) { return 1.; })), 1.5, 1e-13);
    checks.near(name + "moment", work(load, up([](double x) { return x; })), 5. / 6., 1e-13);
    checks.near(name + "no shear",
                work(load, nodal_values(level.space(),
                                        [](const Point<2> &x) { return Point<2>(1. - x[1], 0.); })),
                0., 1e-14);
    // The same means with the other sign would pull: the recovered pressure does not.
    P *= -1.;
    checks.near(
      name + "nothing pulls",
      work(recovered_load(level.space(), level.multipliers(), P), up([](double) { return 1.; })),
      0., 0.);
  }
}

/** b.z = a(z, z): the solve against the sum over cells. */
void energy_of_correction(Checks &checks) {
  for (const char *scene : {"A1", "C4", "E2"})
    for (const unsigned int ratio : {2U, 8U}) {
      // A ring has four times as many contact faces.
      const SolvedLevel level(with_ratio(named_scene(scene), ratio),
                              std::string(scene) == "E2" ? 3 : 4);
      const PressureCorrection found = correct(level, level.P);
      const std::string name = std::string(scene) + ", H = " + std::to_string(ratio) + " h: ";
      checks.that(name + "not zero", found.energy_norm > 0.);
      checks.near(name + "load times solution = energy",
                  internal_forces(DisplacedBody(level.space(), level.scene, found.z)).energy_norm /
                    found.energy_norm,
                  1., 1e-9);
    }
}

/** Where the recovered pressure is p_H. */
void nothing_to_correct(Checks &checks) {
  // Constant pressure: D1 everywhere, E1 on the whole circle.
  for (const char *scene : {"D1", "E1"}) {
    const SolvedLevel level(named_scene(scene), 3);
    Pressure constant(level.P.size());
    constant.add(-0.25);
    const PressureCorrection found = correct(level, constant);
    checks.near(std::string(scene) + ", a constant pressure",
                found.energy_norm /
                  internal_forces(DisplacedBody(level.space(), level.scene, level.U)).energy_norm,
                0., 1e-12);
  }
  const SolvedLevel open(named_scene("C2"), 4);
  const PressureCorrection none = correct(open, open.P);
  checks.that("C2, nothing touches: no solve", none.z.size() == 0 && none.energy_norm == 0.);
  const SolvedLevel unstable(with_ratio(named_scene("A1"), 1), 4);
  checks.that("H = h: no correction", correct(unstable, unstable.P).z.size() == 0);
}

/** Patches longer than two faces are corrected from those of two faces: u_h + z_h is the same. */
void long_patches(Checks &checks) {
  for (const char *scene : {"A1", "C4"}) {
    const auto corrected = [&](const std::string &text) {
      const SolvedLevel level(text, 4);
      Displacement v = level.U;
      v += correct(level, level.P).z;
      return v;
    };
    const Displacement expected = corrected(with_ratio(named_scene(scene), 2));
    for (const unsigned int ratio : {4U, 8U})
      checks.near(std::string(scene) + ", H = " + std::to_string(ratio) + " h, u_h + z_h",
                  distance(corrected(with_ratio(named_scene(scene), ratio)), expected) /
                    expected.linfty_norm(),
                  0., 1e-8);
  }
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv,
                   {linear_pressure, energy_of_correction, nothing_to_correct, long_patches});
}
