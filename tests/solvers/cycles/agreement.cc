// SPDX-License-Identifier: LGPL-2.1-or-later
// V-cycles with boundary problems find what the factorisation and the active set method find.

#include <signorini/solvers/contact/compliance.h>
#include <signorini/solvers/contact/dual_solver.h>

#include <algorithm>

#include "../../driver/box/box.h"
#include "iterated.h"
#include "one_level.h"
#include "tests.h"

using namespace Signorini;

namespace {
std::string body(const std::string &geometry, const std::string &boundary, const std::string &gap) {
  return "subsection Geometry\n" + geometry + "\nend\nsubsection Boundary\n" + boundary +
         "\nend\nsubsection Load\n set Body force = 0; -0.2\nend\nsubsection Contact\n set Gap = " +
         gap + "\nend\n";
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
  checks.near("U", relative(iterated.complete(result.U), exact.U), 0., 1e-8);
  checks.near("P", relative(result.P, exact.P), 0., 1e-8);
  checks.between("V-cycles", result.cycles, 0., max_cycles);
}

void in_the_plane(Checks &checks) {
  const std::string square = " set Upper right = 1, 1";
  const std::string held = " set Clamped = top\n set Contact = bottom";
  const std::string full = body(square, held, "0");
  const std::string partial = body(square, held, "2*(x-0.4)^2-0.02");
  for (unsigned int level = 4; level < 7; ++level) {
    compare(checks, "full contact, level " + std::to_string(level), full, level, 18);
    compare(checks, "partial contact, level " + std::to_string(level), partial, level, 18);
  }
  compare(checks, "nothing touches", body(square, held, "1"), 4, 16);
  compare(checks, "prescribed top, rollers",
          body(square,
               " set Rollers = left\n set Displacement = top: 0.01*x; -0.05\n set Contact = bottom",
               "0.1*x^2"),
          5, 18);
  compare(checks, "two sides",
          body(square, " set Clamped = top\n set Contact = bottom, right", "0.1*y^2-0.01*x"), 5,
          40);
  compare(checks, "distorted", body(" set Distortion = 0.2", held, "2*(x-0.4)^2-0.02"), 5, 18);
  compare(
    checks, "half disc",
    body(" set Shape = half disc", " set Displacement = flat: 0; -0.1\n set Contact = arc", "1+y"),
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
    double seconds = 0.;
    const auto C = make_compliance(*inverse, box.condensed_D, seconds);
    const QPResult exact = solve_dual_problem(C, free.F, {}, {});
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
