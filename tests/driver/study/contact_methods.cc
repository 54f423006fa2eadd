// SPDX-License-Identifier: LGPL-2.1-or-later
// All contact solvers give the same answer; V-cycles need no more of them on finer levels.

#include <signorini/base/errors.h>
#include <signorini/discretization/elasticity/integration.h>
#include <signorini/results/record/level_record.h>

#include <algorithm>

#include "one_level.h"
#include "study_helpers.h"
#include "tests.h"

using namespace Signorini;

namespace
{
struct SceneText
{
  std::string name, text;
  unsigned int level;
};

std::string described(const std::string &geometry,
                      const std::string &boundary,
                      const std::string &gap,
                      const std::string &more = "")
{
  return "subsection Geometry\n" + geometry + "\nend\nsubsection Boundary\n" + boundary +
         "\nend\nsubsection Load\n set Body force = 0.05; -0.2\nend\n" +
         entry("Contact", "Gap", gap) + more;
}

std::vector<SceneText> scenes()
{
  const std::string square = " set Upper right = 1, 1";
  const std::string held = " set Clamped = top\n set Contact = bottom";
  return {
    {"block", described(square, held, "2*(x-0.4)^2-0.02"), 5},
    {"nothing touches", described(square, held, "1"), 4},
    {"prescribed, rollers",
     described(square,
               " set Rollers = left\n set Displacement = top: 0.01*x; -0.05\n set Contact = bottom",
               "0.1*x^2"),
     5},
    {"traction, two sides",
     described(square,
               " set Clamped = top\n set Contact = bottom, right\n set Traction = left: 0.3; 0",
               "0.02"),
     4},
    {"polygon",
     described(" set Shape = polygon\n set Vertices = 0,0; 2,0; 2.5,1; 1,2; -0.5,1",
               " set Clamped = side2\n set Contact = side0",
               "0.1*(x-1)^2-0.01"),
     3},
    {"varying modulus",
     described(square, held, "2*(x-0.4)^2-0.02", entry("Material", "Young's modulus", "1+9*y")),
     4},
    {"E1", named_scene("E1"), 4}};
}

template <typename Vector>
double relative_error(const Vector &a, const Vector &b)
{
  return distance(a, b) / std::max(1e-300, b.linfty_norm());
}

void compare(Checks &checks, const SceneText &scene)
{
  const std::string precise = entry("Solver", "Tolerance", "1e-12");
  const LevelSolution<2> exact = OneLevel(scene.text + precise, scene.level).solve();
  const auto check = [&](const std::string &name, const std::string &settings) {
    const LevelSolution<2> found = OneLevel(scene.text + precise + settings, scene.level).solve();
    const std::string prefix = scene.name + ", " + name + ": ";
    checks.that(prefix + "converged", found.record.dual.converged);
    checks.near(prefix + "U", relative_error(found.U, exact.U), 0., 1e-8);
    checks.near(
      prefix + "P", distance(found.P, exact.P) / (1e-12 + exact.P.linfty_norm()), 0., 1e-8);
    checks.near(prefix + "energy",
                found.record.certificate.energy,
                exact.record.certificate.energy,
                1e-10 * (1e-12 + std::abs(exact.record.certificate.energy)));
    checks.near(prefix + "duality gap", found.record.certificate.duality_gap, 0., 1e-10);
    checks.near(
      prefix + "balances",
      std::max(found.record.certificate.force_balance, found.record.certificate.stationarity),
      0.,
      1e-9);
  };
  check("projected SOR", entry("Solver", "Contact solver", "psor"));
  check("MPRGP", entry("Solver", "Contact solver", "mprgp"));
  check("MPRGP by products",
        entry("Solver", "Contact solver", "mprgp") + entry("Solver", "Linear solver", "multigrid"));
  check("V-cycles", entry("Solver", "Contact solver", "multigrid"));
}

/** A solver that stops at 1 % says how far it is from the discrete solution (energy norm). */
void stop_early(Checks &checks)
{
  const SceneText scene = {"block", scenes()[0].text, 4};
  const OneLevel level(scene.text + entry("Solver", "Tolerance", "1e-12"), scene.level);
  const LevelSolution<2> exact = level.solve();
  checks.between("exact: algebraic error",
                 *exact.record.estimate->algebra / exact.record.estimate->energy,
                 0.,
                 1e-8);
  for (const char *method : {"psor", "mprgp", "multigrid"})
  {
    const LevelSolution<2> found = OneLevel(scene.text + entry("Solver", "Tolerance", "1e-2") +
                                              entry("Solver", "Contact solver", method),
                                            scene.level)
                                     .solve();
    Displacement difference(found.U);
    difference -= exact.U;
    const double error = energy_norm(level.space(), level.scene, difference);
    checks.that(std::string(method) + ": stops early", error > 1e-8 * exact.U.linfty_norm());
    checks.between(std::string(method) + ": algebraic error over the true one",
                   *found.record.estimate->algebra / error,
                   1.,
                   30.);
  }
}

/** Studies on nested levels: certified, and as many V-cycles on every level. */
void nested(Checks &checks)
{
  const std::string text = scenes()[0].text + entry("Solver", "Contact solver", "multigrid");
  const StudyResult exact = solve(scenes()[0].text, levels(3, 7));
  const StudyResult found = solve(text, levels(3, 7));
  const LevelRecord &a = found.levels.back(), &b = exact.levels.back();
  checks.that("nested: certified", found.verdict.outcome == exact.verdict.outcome);
  // The estimate is solved for loosely, and the bound takes another lift.
  const std::vector<std::pair<const char *, double>> columns = {{"energy", 1e-9},
                                                                {"contact_force_n", 1e-7},
                                                                {"estimated_relative", 1e-4},
                                                                {"bound_relative", 0.1}};
  for (const auto &[column, tolerance] : columns)
  {
    const double expected = value(b, column).value();
    checks.near(std::string("nested: ") + column,
                value(a, column).value(),
                expected,
                tolerance * std::abs(expected));
  }
  for (const LevelRecord &level : found.levels)
    checks.between("nested: V-cycles on level " + std::to_string(level.sizes.level),
                   level.dual.iterations,
                   5.,
                   20.);
  // Ends ten times as early, with an error that nobody sees beside that of the mesh.
  std::vector<std::string> early = levels(3, 7);
  early.push_back("Solver/Stop at=discretisation error");
  const StudyResult stopped = solve(text, early);
  const LevelRecord &c = stopped.levels.back();
  checks.between("stop at the error of the mesh: V-cycles", c.dual.iterations, 1., 7.);
  const double energy_error =
    std::abs(c.certificate.energy - b.certificate.energy) / std::abs(b.certificate.energy);
  checks.near("stop at the error of the mesh: energy",
              energy_error,
              0.,
              0.02 * std::pow(b.estimate->relative, 2));
  checks.that("stop at the error of the mesh: certified",
              stopped.verdict.outcome == Outcome::certified);
  checks.near("stop at the error of the mesh: bound",
              value(c, "bound_relative").value(),
              value(b, "bound_relative").value(),
              0.06 * value(b, "bound_relative").value());
}
/** The same in space. */
void in_space(Checks &checks)
{
  const auto solve_by = [](const std::string &solver, const std::vector<std::string> &more = {}) {
    std::vector<std::string> overrides = levels(2, 4);
    overrides.push_back("Solver/Contact solver=" + solver);
    overrides.insert(overrides.end(), more.begin(), more.end());
    return solve<3>("set Dimension = 3\n" + named_scene("D3"), overrides);
  };
  const StudyResult<3> exact = solve_by("active set");
  for (const char *solver : {"multigrid", "mprgp"})
  {
    const std::string name = "in space, " + std::string(solver) + ": ";
    const StudyResult<3> found = solve_by(solver);
    checks.near(name + "P", relative_error(found.pressure.P, exact.pressure.P), 0., 1e-8);
    for (const char *column : {"energy", "u_h1", "u_post_h1", "p_l2"})
      checks.near(name + column,
                  value(found.levels.back(), column).value() /
                    value(exact.levels.back(), column).value(),
                  1.,
                  1e-8);
    checks.that(name + "equations hold", found.verdict.equations_hold());
    if (solver == std::string("multigrid"))
      for (const LevelRecord &level : found.levels)
        checks.between(name + "V-cycles on level " + std::to_string(level.sizes.level),
                       level.dual.iterations,
                       5.,
                       20.);
  }
  const StudyResult<3> early = solve_by("multigrid", {"Solver/Stop at=discretisation error"});
  checks.between("in space, early: V-cycles", early.levels.back().dual.iterations, 1., 6.);
  checks.near("in space, early: error of pi^{2h}",
              value(early.levels.back(), "u_post_h1").value() /
                value(exact.levels.back(), "u_post_h1").value(),
              1.,
              0.02);
}

/** What V-cycles do not know is refused. */
void refusals(Checks &checks)
{
  const std::string block = scenes()[0].text + entry("Solver", "Contact solver", "multigrid");
  checks.throws<InputError>("linear solver", "allowed with it: automatic, multigrid.", [&]() {
    solve(block, {"Solver/Linear solver=condensed"});
  });
  checks.throws<InputError>(
    "graded meshes", "with Strategy 'hp'", [&]() { solve(block, {"Discretization/Strategy=hp"}); });
  checks.throws<InputError>(
    "load cases", "with load cases", [&]() { solve(block, {"Load cases/Cases=weight 2"}); });
  checks.throws<InputError>(
    "free motions", "moves freely", [&]() { solve(block, {"Boundary/Clamped="}); });
}
} // namespace

int main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  Checks checks;
  for (const SceneText &scene : scenes())
    compare(checks, scene);
  stop_early(checks);
  nested(checks);
  in_space(checks);
  refusals(checks);
  return checks.exit_code();
}
