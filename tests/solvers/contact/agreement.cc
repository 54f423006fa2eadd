// SPDX-License-Identifier: LGPL-2.1-or-later
// V-cycles with boundary problems find the solution of the factorisation and the active set method.

#include <signorini/solvers/contact/compliance.h>
#include <signorini/solvers/contact/dual_solver.h>

#include <algorithm>

#include "../../driver/box/box.h"
#include "iterated.h"
#include "one_level.h"
#include "tests.h"

using namespace Signorini;

namespace {
std::string with_gap(const std::string &body, const std::string &gap) {
  return body + "Load/Body force = 0; -0.2\nContact/Gap = " + gap + "\n";
}

template <typename First, typename Second>
double relative(const First &a, const Second &b) {
  return distance(a, b) / std::max(1e-30, b.linfty_norm());
}

/** @param max_cycles from zero to 1e-10. */
void compare(Checks &checks, const std::string &name, const std::string &text,
             const unsigned int level, const unsigned int max_cycles, const double scale = 0.,
             const bool stalls = false) {
  checks.about(name);
  const OneLevel problem(text, level);
  const Discretization<2> &d = problem.discretization;
  const LevelSolution<2> exact = problem.solve();
  const Iterated<2> iterated(d.space, problem.scene, d.multipliers, d.D, d.condensed_D, d.G);
  ContactIterationOptions options;
  options.scale = scale;
  const ContactIterationResult result = iterated.solve(options);
  checks.that("converged", result.converged);
  checks.that("by MINRES or not", result.stalled.has_value() == stalls);
  checks.near("U", relative(iterated.complete(result.U), exact.contact.U), 0., 1e-8);
  checks.near("P", relative(result.P, exact.contact.P.normal()), 0., 1e-8);
  checks.between("V-cycles", result.cycles, 0., max_cycles);
}

void in_the_plane(Checks &checks) {
  const std::string held = "Boundary/Clamped = top\nBoundary/Contact = bottom\n",
                    dent = "2*(x-0.4)^2-0.02";
  const std::string full = with_gap(held, "0"), partial = with_gap(held, dent);
  for (unsigned int level = 4; level < 7; ++level) {
    compare(checks, "full contact, level " + std::to_string(level), full, level, 18);
    compare(checks, "partial contact, level " + std::to_string(level), partial, level, 18);
  }
  compare(checks, "nothing touches", with_gap(held, "1"), 4, 16);
  compare(checks, "prescribed top, rollers",
          with_gap("Boundary/Rollers = left\nBoundary/Displacement = top: 0.01*x; -0.05\n"
                   "Boundary/Contact = bottom\n",
                   "0.1*x^2"),
          5, 18);
  compare(checks, "two sides",
          with_gap("Boundary/Clamped = top\nBoundary/Contact = bottom, right\n", "0.1*y^2-0.01*x"),
          5, 40);
  compare(checks, "distorted", partial + "Geometry/Distortion = 0.2\n", 5, 18);
  compare(checks, "half disc",
          with_gap("Geometry/Shape = half disc\nBoundary/Displacement = flat: 0; -0.1\n"
                   "Boundary/Contact = arc\n",
                   "1+y"),
          4, 25);
  compare(checks, "varying modulus", partial + "Material/Young's modulus = 1+9*x\n", 5, 18);
  compare(checks, "Poisson's ratio 0.45", partial + "Material/Poisson's ratio = 0.45\n", 5, 40);
  compare(checks, "t far too small", full, 5, 120, 0.05, true);
}

/** A box that a paraboloid presses. */
void in_space(Checks &checks) {
  const Scene<3> scene =
    make_box_scene(scalar([](const dealii::Point<3> &x) {
                     return 0.5 * ((x[0] - 0.4) * (x[0] - 0.4) + (x[1] - 0.5) * (x[1] - 0.5));
                   }),
                   field([](const auto &) {
                     return Vector3({0., 0., -0.05});
                   }));
  for (unsigned int level = 2; level < 5; ++level) {
    checks.about("box, level " + std::to_string(level));
    const Box box(scene, level, 2);
    const Iterated<3> iterated(box.space, scene, box.multipliers, box.D, box.condensed_D, box.G);
    const LinearSystem<3> system = assemble_linear_system(box.space, scene, 2);
    const auto inverse = factorise(system.matrix, system.unit, LinearSolver::condensed,
                                   contact_unknowns(box.condensed_D));
    const FreeState free = solve_free_state(*inverse, box.space, system.f, box.D, box.G);
    const auto C = make_compliance(*inverse, box.condensed_D);
    const QPResult exact =
      solve_dual_problem(C, free.F, AdmissibleSet::nonpositive(free.F.size()), {}, {});
    const ContactIterationResult result = iterated.solve();
    checks.that("partial contact",
                std::any_of(exact.P.begin(), exact.P.end(), [](double p) { return p == 0.; }) ||
                  level == 2);
    checks.near("P", relative(result.P, exact.P), 0., 1e-8);
    checks.near(
      "U",
      relative(iterated.complete(result.U),
               recover_displacement(*inverse, box.space, box.condensed_D, exact.P, system.f)),
      0., 1e-8);
    checks.between("V-cycles", result.cycles, 0., 16);
  }
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv, {in_the_plane, in_space});
}
