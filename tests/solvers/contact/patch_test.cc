// SPDX-License-Identifier: LGPL-2.1-or-later
// Constant stress under full contact: U and P are exact on every mesh and every partition.

#include <signorini/results/verdict/judge.h>

#include "one_level.h"
#include "tests.h"

using namespace Signorini;
using dealii::Point;

namespace {
void check(Checks &checks, const std::string &name, const OneLevel &level, const double pressure,
           const Field &displacement) {
  checks.about(name);
  const LevelSolution<2> solution = level.solve();
  dealii::Vector<double> P(level.multipliers().n_multipliers());
  P = pressure;
  checks.near("P", distance(solution.contact.P.normal(), P), 0., 1e-12);
  checks.near("U", distance(solution.contact.U, nodal_values(level.space(), displacement)), 0.,
              1e-12);
  checks.that("certified", Judge({1e-10, 0.2, 0.}).accepts(solution.record));
}

std::string discretization(const std::string &entries) {
  return "subsection Discretization\n" + entries + "\nend\n";
}

/** lambda = mu = 1, u = (0, 0.125 (1 - y)), p = -0.125 (lambda + 2 mu). */
void catalogue_scene(Checks &checks) {
  const Field exact = [](const Point<2> &x) { return Point<2>(0., 0.125 * (1. - x[1])); };
  const std::string scene = "Scene/Name = D1\n";
  for (const char *partition : {"set Patch ratio = 2", "set Patch ratio = 3", "set Patch ratio = 4",
                                "set Patch ratio = 8", "set Patches = 3", "set Patches = 5"})
    check(checks, "D1, " + std::string(partition).substr(4),
          OneLevel(scene + discretization(partition), 3), -0.375, exact);
  check(checks, "D1, one cell, psor", OneLevel(scene + "Solver/Contact solver = psor\n", 0), -0.375,
        exact);
}

void distorted_meshes(Checks &checks) {
  const std::string geometry = "subsection Geometry\nset Distortion = 0.35\nend\n";
  const std::string isotropic =
    geometry + "subsection Material\nset Young's modulus = 2.5\nset Poisson's ratio = 0.25\nend\n"
               "subsection Boundary\nset Clamped = top\nset Contact = bottom\n"
               "set Traction = left: 0.125; 0 | right: -0.125; 0\nend\n"
               "Contact/Gap = -0.125\n";
  const Field exact = [](const Point<2> &x) { return Point<2>(0., 0.125 * (1. - x[1])); };
  check(checks, "distorted mesh", OneLevel(isotropic, 3), -0.375, exact);
  check(checks, "distorted mesh, Patches = 5",
        OneLevel(isotropic + discretization("set Patches = 5"), 3), -0.375, exact);

  // u = (gamma, eps)(1 - y), s12 = -C23 eps - C33 gamma = 0: eps = 0.1, gamma = -0.04,
  // p = -C22 eps - C23 gamma = -0.184, s11 = -C12 eps - C13 gamma = -0.08.
  const std::string anisotropic = geometry +
                                  "subsection Material\nset Law = general\n"
                                  "set Hooke tensor = 4; 1; 0.5; 2; 0.4; 1\nend\n"
                                  "subsection Boundary\nset Clamped = top\nset Contact = bottom\n"
                                  "set Traction = left: 0.08; 0 | right: -0.08; 0\nend\n"
                                  "Contact/Gap = -0.1\n";
  check(checks, "anisotropic, distorted mesh", OneLevel(anisotropic, 3), -0.184,
        [](const Point<2> &x) { return Point<2>(-0.04 * (1. - x[1]), 0.1 * (1. - x[1])); });
}

/** Rotated bar between rollers, lowered by 0.3 along the normal (1, -2)/sqrt(5) of side0. */
void oblique_sides(Checks &checks) {
  const std::string text =
    "subsection Geometry\nset Shape = polygon\n"
    "set Vertices = 0,0; 2,1; 1,3; -1,2\nend\n"
    "subsection Material\nset Young's modulus = 2.5\nset Poisson's ratio = 0.25\nend\n"
    "subsection Constants\nset Values = d = 0.3/sqrt(5)\nend\n"
    "subsection Boundary\nset Contact = side0\nset Rollers = side1 side3\n"
    "set Displacement = side2: d; -2*d\nend\n";
  // The height is sqrt(5): eps = 0.3/sqrt(5), p = -3 eps; u.n grows linearly from 0 on side0.
  const dealii::Tensor<1, 2> n = Point<2>(1., -2.) / std::sqrt(5.);
  check(checks, "oblique sides", OneLevel(text, 3), -0.9 / std::sqrt(5.),
        [&](const Point<2> &x) { return -0.3 / std::sqrt(5.) * (x * n) * n; });
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv, {catalogue_scene, distorted_meshes, oblique_sides});
}
