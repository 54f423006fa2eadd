// SPDX-License-Identifier: LGPL-2.1-or-later
// Bodies between loops of segments and arcs: constant strain, and the re-entrant corner of an L.

#include <signorini/error_control/hp/next_plan.h>

#include "study_helpers.h"
#include "tests.h"

using namespace Signorini;

namespace {
const std::string l_shape = "subsection Geometry\n set Shape = polygon\n"
                            " set Vertices = 0,0; 2,0; 2,1; 1,1; 1,2; 0,2\nend\n";

/** lambda = mu = 1. */
const std::string material = "subsection Material\nset Young's modulus = 2.5\n"
                             "set Poisson's ratio = 0.25\nend\n";

void check_patch_tests(Checks &checks) {
  const std::string of_l = "subsection Boundary\n set Rollers = side5\n set Contact = side0\n"
                           " set Displacement = side4: 0.01*x; -0.02*y\n"
                           " set Traction = side1: 0.01; 0 | side2: 0; -0.05 | side3: 0.01; 0\n"
                           "end\nsubsection Exact solution\n"
                           " set Displacement = 0.01*x; -0.02*y\n set Pressure = -0.05\nend\n";
  // It shrinks onto a square punch that fills its hole.
  const std::string plate_with_square_hole =
    "subsection Geometry\n set Shape = polygon\n"
    " set Vertices = 0,0; 2,0; 2,2; 0,2\n"
    " set Holes = 0.8,0.8; 1.2,0.8; 1.2,1.2; 0.8,1.2\nend\n"
    "subsection Boundary\n set Contact = hole0\n"
    " set Displacement = side0: -0.01*x; -0.01*y | side1: -0.01*x; -0.01*y | "
    "side2: -0.01*x; "
    "-0.01*y | side3: -0.01*x; -0.01*y\nend\nsubsection Contact\n"
    " set Gap = x + y < 2 ? -0.008 : 0.012\nend\n"
    "subsection Exact solution\n set Displacement = -0.01*x; -0.01*y\n"
    " set Pressure = -0.04\nend\n";
  for (const std::string &text : {l_shape + of_l, plate_with_square_hole}) {
    const StudyResult<2> result = solve(material + text, levels(1, 3));
    for (const LevelRecord &level : result.levels)
      for (const char *column : {"u_h1", "u_l2", "p_l2"})
        checks.near("constant strain", value(level, column).value(), 0., 1e-12);
    checks.that("equations", result.verdict.equations_hold());
  }
}

void check_corner(Checks &checks) {
  const Parameters parameters =
    parse_parameters(l_shape + material, "test",
                     {"Boundary/Clamped=side4", "Boundary/Contact=side0", "Contact/Gap=0.001*x^2",
                      "Load/Body force=0; -0.01", "Discretization/Strategy=hp",
                      "Discretization/Target error=0.005", "Discretization/Coarsest level=0"});
  const Scene<2> scene = make_scene<2>(parameters);
  std::vector<double> exponents;
  for (const Singularity &singularity : first_plan(scene, 0, 9).singularities)
    if (singularity.point.distance(dealii::Point<2>(1., 1.)) < 1e-12) {
      exponents.push_back(singularity.exponent);
      checks.that("L, re-entrant corner: certain", singularity.is_certain);
    }
  checks.near("L, re-entrant corner: exponent", exponents, {0.544483737}, 1e-6);
  const StudyResult<2> result = run(parameters, scene);
  checks.that("L, hp: the target is reached",
              last(result, "estimated_relative") < 0.005 && result.verdict.is_certified());
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv, {check_patch_tests, check_corner});
}
