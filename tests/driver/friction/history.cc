// SPDX-License-Identifier: LGPL-2.1-or-later
// Load steps: friction remembers the slip since the beginning.

#include <signorini/verification/catalogue/catalogue.h>
#include <signorini/verification/verify.h>

#include "one_level.h"
#include "study_helpers.h"
#include "tests.h"

using namespace Signorini;

namespace {
/** Solves scene CM or its unloading on 64 x 64 cells. @param slip of the steps before is added to
 * G_t; @return the slip after it, too. */
std::pair<LevelRecord, dealii::Vector<double>> mindlin(const bool unloaded,
                                                       const dealii::Vector<double> &slip) {
  OneLevel level(named_scene("CM"), 6);
  level.scene = cattaneo_mindlin(unloaded).make();
  dealii::Vector<double> &G = level.discretization.G;
  G = level.discretization.assemble_gap_of(level.scene);
  const unsigned int m = G.size() / 2;
  for (unsigned int k = 0; k < slip.size(); ++k)
    G[m + k] += slip[k];
  LevelSolution<2> solution = level.solve();
  add_errors<2>(level.parameters, level.discretization, nullptr, solution);
  dealii::Vector<double> W = level.discretization.D.transpose_product(solution.contact.U), after(m);
  W -= G;
  for (unsigned int k = 0; k < m; ++k)
    after[k] = W[m + k] + (slip.size() > 0 ? slip[k] : 0.);
  return {solution.record, after};
}

/** Loading and unloading of Mindlin and Deresiewicz, against their tractions and another program.
 */
void test_unloading(Checks &checks) {
  const auto [loaded, slip] = mindlin(false, {});
  const LevelRecord unloaded = mindlin(true, slip).first, forgetful = mindlin(true, {}).first;
  for (const auto &[column, exact] : {std::pair("contact_force_n", 1.0381300419e-01),
                                      {"tangential_force", 3.5589403056e-03},
                                      {"dissipation", 2.6944933779e-06}})
    checks.near(std::string("unloading: ") + column, *value(unloaded, column), exact, 1e-6 * exact);
  checks.near("unloading: |q-qH|0", *value(unloaded, "q_l2"), 0.0131, 6e-5);
  checks.near("without the slip of the first step", *value(forgetful, "q_l2"), 0.0237, 6e-4);
}

CaseSolver<2> make_solver(const OneLevel &level, const LevelSolution<2> &solution,
                          const bool steps) {
  return CaseSolver<2>(level.discretization, level.scene, *solution.operators, {}, steps);
}

/** A block that a moving foundation drags to and fro. */
const std::string dragged = "Geometry/Upper right = 2, 1\nGeometry/Cells = 2, 1\n"
                            "Boundary/Clamped = top\nBoundary/Contact = bottom\n"
                            "Contact/Foundation = plane 0,-0.02 normal 0,1\n"
                            "Contact/Foundation position = 0, 0.05\nContact/Friction = coulomb\n"
                            "Contact/Friction coefficient = 0.3\nContact/Foundation shift = 0.01\n"
                            "Boundary/Traction = right: 0.002; 0\n"
                            "Load cases/Cases = force 1\n";

LoadCase step(const double slide, const double force = 1.) {
  LoadCase load_case;
  load_case.slide = slide;
  load_case.force = force;
  return load_case;
}

void test_steps(Checks &checks) {
  const OneLevel level(dragged, 4);
  const LevelSolution<2> solution = level.solve();
  CaseSolver<2> steps = make_solver(level, solution, true),
                cases = make_solver(level, solution, false);
  const CaseResult first = steps.solve(step(1.)), alone = cases.solve(step(1.));
  checks.near("the first step is a case", first.tangential->tangential_force,
              alone.tangential->tangential_force, 1e-13);
  checks.near("and that of the level", first.tangential->tangential_force,
              solution.record.tangential->tangential_force, 1e-12);
  const CaseResult again = steps.solve(step(1.));
  checks.near("the same loads again: no slip",
              {again.tangential->tangential_force, again.tangential->dissipation},
              {first.tangential->tangential_force, first.tangential->dissipation}, 1e-13);
  const CaseResult far = steps.solve(step(20.));
  checks.near("far away all slips", far.tangential->slip_length + far.tangential->open_length, 2.,
              1e-12);
  checks.near("T = f N", far.tangential->tangential_force, 0.3 * far.contact.force[1], 1e-12);
  const CaseResult back = steps.solve(step(-20.));
  checks.near("and back", back.tangential->tangential_force, -0.3 * back.contact.force[1], 1e-12);
  checks.that("dissipation grows", back.tangential->dissipation > far.tangential->dissipation &&
                                     far.tangential->dissipation > first.tangential->dissipation);
  const CaseResult home = steps.solve(step(0.)), rest = cases.solve(step(0.));
  checks.that("the way matters", std::abs(home.tangential->tangential_force -
                                          rest.tangential->tangential_force) > 1e-4);
  // The obstacle, moved by 0.01 along the side, acts like a shift of 0.01.
  LoadCase moved = step(0.);
  moved.shift_x = 0.01;
  checks.near("a moved obstacle drags", cases.solve(moved).tangential->tangential_force,
              alone.tangential->tangential_force, 1e-12);
}

/** Cattaneo and Mindlin by force: under Q the part sqrt(1 - Q/(f N)) of the zone sticks, every
 * force is carried, and a closed cycle ends where it began. */
void test_fretting_by_force(Checks &checks) {
  const OneLevel level("Geometry/Lower left = -1, 0\nGeometry/Upper right = 1, 1\n"
                       "Geometry/Cells = 2, 1\nMaterial/Poisson's ratio = 0.45\n"
                       "Boundary/Contact = bottom\nBoundary/Plates = top: 0, -1\n"
                       "Load/Plate force = top: 0.01\nLoad/Plate cross force = top: 0.003\n"
                       "Contact/Gap = x^2/2\nContact/Friction = coulomb\n"
                       "Contact/Friction coefficient = 0.5\nLoad cases/Cases = cross 0 | cross 1\n",
                       6);
  const LevelSolution<2> solution = level.solve();
  CaseSolver<2> solver = make_solver(level, solution, true);
  const auto solve_at = [&](const double cross) {
    LoadCase load_case;
    load_case.cross = cross;
    CaseResult result = solver.solve(load_case);
    checks.near("fretting: forces", {result.contact.force[0], result.contact.force[1]},
                {-0.003 * cross, 0.01}, 1e-14);
    return result;
  };
  solve_at(0.);
  const CaseResult first = solve_at(1.);
  // A patch is 1/32 long, and each end of a zone is known within one.
  checks.near("fretting: stick", first.tangential->stick_length, first.zone_length * std::sqrt(0.4),
              1. / 32);
  solve_at(-1.);
  const CaseResult last = solve_at(1.);
  checks.near("fretting: the cycle closes", last.plates[0].drift[0] / first.plates[0].drift[0], 1.,
              0.02);
  checks.that("fretting: each cycle costs work",
              last.tangential->dissipation > 2. * first.tangential->dissipation);
}

/** Steps that only stick are one step; small steps in one direction are one step in plain slip. */
void test_sequence(Checks &checks) {
  const StudyResult<2> found = solve(
    dragged,
    levels(3, 4,
           {"Load cases/Cases=slide 0 to 1 in 5 cases | slide 0", "Load cases/Sequence=steps"}));
  checks.that("certified", found.verdict.is_certified());
  for (const LevelRecord &level : found.levels) {
    checks.near("cases of every level", level.load_cases->n_cases, 6, 0.);
    checks.between("KKT residuals", level.load_cases->max_kkt, 0., 1e-12);
  }
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv, {test_unloading, test_steps, test_fretting_by_force, test_sequence});
}
