// SPDX-License-Identifier: LGPL-2.1-or-later
// The numbers of the lemmas where they are known: they vanish for linear displacements and constant
// pressures, also where the displacement that holds the body is not zero.

#include <signorini/verification/norms/lemma_numbers.h>

#include "one_level.h"
#include "tests.h"

using namespace Signorini;

namespace {
/** u = (0, -0.125 y): the top of D1 moved down by 0.125 onto a foundation at rest. */
const std::string pressed_patch_test = "Constants/Values = E=2.5, nu=0.25, e=0.125\n"
                                       "subsection Material\nset Young's modulus = E\n"
                                       "set Poisson's ratio = nu\nend\n"
                                       "subsection Boundary\nset Displacement = top: 0; -e\n"
                                       "set Contact = bottom\n"
                                       "set Traction = left: e; 0 | right: -e; 0\nend\n"
                                       "subsection Exact solution\nset Displacement = 0; -e*y\n"
                                       "set Displacement gradient = 0; 0; 0; -e\n"
                                       "set Pressure = -3*e\nend\n";

LemmaNumbers numbers(const OneLevel &level) {
  const ExactPressure pressure(level.scene);
  return compute_lemma_numbers(level.discretization, level.scene, pressure,
                               LinearSolver::automatic);
}

void patch_test(Checks &checks) {
  const OneLevel level(pressed_patch_test, 3);
  const LevelSolution<2> solution = level.solve();
  checks.near("the scene has this pressure", solution.contact.P.normal().linfty_norm() - 0.375, 0.,
              1e-12);
  const LemmaNumbers found = numbers(level);
  checks.near("all numbers vanish",
              {found.projection_l2, found.projection_dual, found.interpolation_h1,
               found.interpolation_trace, found.consistency, found.bound_26, found.bound_27,
               found.bound_30.value_or(1.)},
              std::vector<double>(8, 0.), 1e-12);
}

/**
 * u = (y², x²): on n faces of length h on each of two unit sides x² - I^h x² = -h² t (1 - t), whose
 * cosine series has the modes 2 n j with the amplitudes (h/(pi j))².
 */
void parabola(Checks &checks) {
  const OneLevel level("subsection Boundary\nset Displacement = top: y^2; x^2\n"
                       "set Contact = bottom left\nend\nsubsection Contact\nset Gap = 9\nend\n"
                       "subsection Exact solution\nset Displacement = y^2; x^2\n"
                       "set Displacement gradient = 0; 2*y; 2*x; 0\nset Pressure = -1\nend\n",
                       3);
  const double n = 8., h = 1. / n;
  double square = std::pow(h, 4) / 36.;
  for (double j = 100000.; j >= 1.; j -= 1.)
    square += 0.5 * std::hypot(1., 2. * n * j * dealii::numbers::PI) *
              std::pow(h / (dealii::numbers::PI * j), 4);
  const double exact = std::sqrt(2. * square);
  checks.near("parabola: u - I^h u on Gamma_c", numbers(level).interpolation_trace, exact,
              1e-6 * exact);
}

/** T^T r against its definition: (T^T r).v = r.(T v) for v in V^h. */
void restriction(Checks &checks) {
  const OneLevel level("subsection Geometry\nset Shape = polygon\n"
                       "set Vertices = 0,0; 2,0; 2.5,1.5; 1,2.5; -0.5,1\nend\n"
                       "subsection Boundary\nset Contact = side0\nset Rollers = side1\n"
                       "set Displacement = side3: 0.01; -0.02\nend\n",
                       2);
  const auto &space = level.space();
  RandomNumbers random(3);
  const DualVector r = random_rows(space, random), condensed = space.condense(r);
  // T v - k is linear in v.
  const Displacement v = space.complete(random_rows(space, random)),
                     k = space.complete(space.zero());
  Displacement Tv = v;
  Tv -= k;
  checks.that("something is prescribed", k.linfty_norm() > 0.01);
  checks.near("(T^T r).v = r.(T v)", condensed * v, r * Tv, 1e-12);
  double largest = 0.;
  for (const auto &line : space.constraints().get_lines())
    largest = std::max(largest, std::abs(condensed[line.index]));
  checks.near("zero where displacements are held", largest, 0., 0.);
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv, {patch_test, parabola, restriction});
}
