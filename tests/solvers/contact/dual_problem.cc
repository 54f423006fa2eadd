// SPDX-License-Identifier: LGPL-2.1-or-later
// C = D^T A^{-1} D, F = G - D^T A^{-1} f and U = A^{-1}(D P + f): their definitions, and bars under
// uniform compression, whose compliance is known.

#include <signorini/discretization/space/internal_forces.h>
#include <signorini/solvers/contact/compliance.h>

#include <cmath>

#include "one_level.h"
#include "tests.h"

using namespace Signorini;
using dealii::Point;

namespace {
/** lambda = mu = 1 in plane strain. */
const std::string elastic = "subsection Material\nset Young's modulus = 2.5\n"
                            "set Poisson's ratio = 0.25\nend\n";

struct DualProblem {
  DualProblem(const std::string &text, const unsigned int number)
    : level(text + elastic, number)
    , system(assemble_linear_system(level.space(), level.scene, 3))
    , inverse(factorise(system.matrix, system.unit, LinearSolver::automatic))
    , C(make_compliance(*inverse, level.discretization.condensed_D,
                        [&](const unsigned int done) { n_columns_done = done; })
          ->dense())
    , free(solve_free_state(*inverse, level.space(), system.f, level.discretization.D,
                            level.discretization.G)) {}

  Displacement recover(const dealii::Vector<double> &P, const DualVector &f) const {
    return recover_displacement(*inverse, level.space(), level.discretization.condensed_D, P, f);
  }
  dealii::Vector<double> transpose_product(const Displacement &U) const {
    return level.discretization.D.transpose_product(U);
  }

  OneLevel level;
  LinearSystem<2> system;
  std::unique_ptr<StiffnessInverse> inverse;
  unsigned int n_columns_done = 0;
  dealii::FullMatrix<double> C;
  FreeState free;
};

/** a(u_h, v) = f(v) + [p, Bv] for all admissible v, also with prescribed displacements. */
void equilibrium(Checks &checks, const std::string &name, const DualProblem &problem) {
  checks.about(name);
  const auto &space = problem.level.space();
  const auto P = RandomNumbers(8).vector(problem.C.m());
  const Displacement U = problem.recover(P, problem.system.f);
  DualVector residual = internal_forces(DisplacedBody(space, problem.level.scene, U)).forces;
  const double scale = residual.l2_norm();
  residual -= problem.system.loads;
  for (unsigned int tau = 0; tau < P.size(); ++tau)
    for (const auto &entry : problem.level.discretization.D.column(tau))
      residual[entry.first] -= entry.second * P[tau];
  for (const auto &line : space.constraints().get_lines()) {
    for (const auto &entry : line.entries)
      residual[entry.first] += entry.second * residual[line.index];
    residual[line.index] = 0.;
  }
  checks.near("A U = D P + f", residual.l2_norm(), 0., 1e-13 * scale);
  // W = C P - F = D^T U - G.
  dealii::Vector<double> W(P.size());
  problem.C.vmult(W, P);
  W -= problem.free.F;
  checks.that("C is positive", P * W + P * problem.free.F > 0.);
  dealii::Vector<double> opening = problem.transpose_product(U);
  opening -= problem.level.discretization.G;
  checks.near("C P - F = D^T U - G", distance(W, opening), 0., 1e-12);
}

std::string square(const std::string &boundary, const std::string &more) {
  return "subsection Boundary\nset Contact = bottom\n" + boundary + "end\n" + more;
}

void general(Checks &checks) {
  const std::string load = "Load/Body force = 1; x - 2*y\n"
                           "Contact/Gap = 0.1*x^2\n";
  for (const auto &[name, text] : std::vector<std::pair<std::string, std::string>>{
         {"clamped", square("set Clamped = top\n", load)},
         {"patches aligned with nothing",
          square("set Clamped = top\nset Traction = left: 1; x + y\n",
                 load + "Discretization/Patches = 5\nGeometry/Distortion = 0.25\n")},
         {"prescribed displacement",
          square("set Displacement = top: 0.1*x; -0.2 | left: 0; -0.2*y\n", load)},
         {"oblique roller",
          "Geometry/Shape = polygon\nGeometry/Vertices = 0,0; 2,0; 2.5,1.5; 1,2.5; -0.5,1\n"
          "Boundary/Contact = side0 side2\nBoundary/Rollers = side1\nBoundary/Clamped = side3\n" +
            load}}) {
    const DualProblem problem(text, 3);
    equilibrium(checks, name, problem);
    checks.that(name + ": progress up to the last column",
                problem.n_columns_done == problem.level.multipliers().n_multipliers());
  }
}

/** Bars between rollers: u_n = p h/(lambda + 2 mu) under a uniform pressure p. */
void bars(Checks &checks) {
  const std::string between_rollers = "set Rollers = left right\nset Clamped = top\n";
  const std::string one = "Discretization/Patches = 1\n";
  for (const unsigned int number : {1U, 3U})
    checks.near("bar, one patch, level " + std::to_string(number),
                DualProblem(square(between_rollers, one), number).C(0, 0), 1. / 3., 1e-14);
  checks.near("bar, distorted mesh",
              DualProblem(square(between_rollers, one + "Geometry/Distortion = 0.3\n"), 3).C(0, 0),
              1. / 3., 1e-14);
  // The sides have the length sqrt(5): C = 5/(lambda + 2 mu).
  const DualProblem rotated(
    "subsection Geometry\nset Shape = polygon\n"
    "set Vertices = 0,0; 2,1; 1,3; -1,2\nend\nsubsection Boundary\n"
    "set Contact = side0\nset Clamped = side2\nset Rollers = side1 side3\nend\n" +
      one,
    3);
  checks.near("rotated bar", rotated.C(0, 0), 5. / 3., 1e-13);

  // Pressure one on all patches: (C e)_tau = |tau| h/(lambda + 2 mu).
  for (const std::string partition : {"Patch ratio = 3", "Patches = 5"}) {
    const DualProblem bar(
      square(between_rollers, "subsection Discretization\nset " + partition + "\nend\n"), 3);
    const unsigned int m = bar.C.m();
    dealii::Vector<double> ones(m), Ce(m), expected = bar.level.multipliers().integrals();
    ones = 1.;
    bar.C.vmult(Ce, ones);
    expected *= 1. / 3.;
    checks.near("bar, " + partition, distance(Ce, expected), 0., 1e-14);
  }

  // Its weight 0.6 lengthens the bar by 0.6 h^2/(2 (lambda + 2 mu)) = 0.1, the top comes down by
  // 0.05.
  const DualProblem hanging(square("set Rollers = left right\nset Displacement = top: 0; -0.05\n",
                                   one + "Load/Body force = 0; -0.6\n"
                                         "Contact/Gap = 0.08 + 0.04*x\n"),
                            3);
  checks.near("hanging bar: free opening", hanging.free.F[0], 0.1 - 0.15, 1e-14);
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv, {general, bars});
}
