// SPDX-License-Identifier: LGPL-2.1-or-later
// Bodies between loops of segments and arcs: constant strain, orders, and the re-entrant corner of
// an L.

#include <signorini/error_control/hp/next_plan.h>
#include <signorini/problem/geometry/outline.h>

#include <deal.II/base/numbers.h>

#include <algorithm>

#include "study_helpers.h"
#include "tests.h"

using namespace Signorini;
using dealii::numbers::PI;

namespace
{
const std::string l_shape = R"(
subsection Geometry
  set Shape     = polygon
  set Vertices  = 0,0; 2,0; 2,1; 1,1; 1,2; 0,2
end
)";

/** lambda = mu = 1. */
const std::string material = R"(
subsection Material
  set Young's modulus = 2.5
  set Poisson's ratio = 0.25
end
)";

void check_errors(Checks &checks, const std::string &name, const std::string &text)
{
  const StudyResult<2> result = solve(text, levels(1, 3));
  double largest = 0.;
  for (const LevelRecord &level : result.levels)
    for (const char *column : {"u_h1", "u_l2", "p_l2"})
      largest = std::max(largest, value(level, column).value());
  checks.near(name + ": constant strain", largest, 0., 1e-12);
  checks.that(name + ": equations", result.verdict.equations_hold());
}

void check_patch_tests(Checks &checks)
{
  check_errors(checks, "L", l_shape + material + R"(
subsection Boundary
  set Rollers      = side5
  set Contact      = side0
  set Displacement = side4: 0.01*x; -0.02*y
  set Traction     = side1: 0.01; 0 | side2: 0; -0.05 | side3: 0.01; 0
end
subsection Exact solution
  set Displacement = 0.01*x; -0.02*y
  set Pressure     = -0.05
end
)");
  // It shrinks onto a square punch that fills its hole.
  check_errors(checks, "plate with a square hole", material + R"(
subsection Geometry
  set Shape     = polygon
  set Vertices  = 0,0; 2,0; 2,2; 0,2
  set Holes     = 0.8,0.8; 1.2,0.8; 1.2,1.2; 0.8,1.2
end
subsection Boundary
  set Contact      = hole0
  set Displacement = side0: -0.01*x; -0.01*y | side1: -0.01*x; -0.01*y | \
                     side2: -0.01*x; -0.01*y | side3: -0.01*x; -0.01*y
end
subsection Contact
  set Gap = x < 0.800001 || y < 0.800001 ? -0.008 : 0.012
end
subsection Exact solution
  set Displacement = -0.01*x; -0.01*y
  set Pressure     = -0.04
end
)");
}

/** Scene E3 on a half disc of triangles: the orders are those of the other mesh. */
void check_orders(Checks &checks)
{
  const Parameters parameters = parse_parameters(named_scene("E3"), "test", levels(2, 5));
  Scene<2> scene = make_scene<2>(parameters);
  using Point = dealii::Point<2>;
  scene.geometry =
    make_outlined_body({{"flat", Curve(Point(1., 0.), Point(-1., 0.), Point(0., 1.))},
                        {"arc", Curve::arc(Point(), 1., -PI, 0., Body::inside)}},
                       0.5,
                       "test");
  std::ostream silence(nullptr);
  const StudyResult<2> result =
    run_study(parameters, scene, MPI_COMM_WORLD, {silence, "", [](const std::string &) {}});
  const auto order = [&](const char *column) {
    return slope({result.levels.end() - 3, result.levels.end()}, column);
  };
  checks.between("E3, order of u_h1", order("u_h1"), 0.95, 1.1);
  checks.between("E3, order of u_l2", order("u_l2"), 1.9, 2.2);
  checks.between("E3, order of p_l2", order("p_l2"), 0.9, 1.1);
  checks.between("E3, order of u_post_h1", order("u_post_h1"), 1.6, 2.4);
  checks.that("E3, equations", result.verdict.equations_hold());
}

void check_corner(Checks &checks)
{
  const Parameters parameters = parse_parameters(l_shape + material,
                                                 "test",
                                                 {"Boundary/Clamped=side4",
                                                  "Boundary/Contact=side0",
                                                  "Contact/Gap=0.001*x^2",
                                                  "Load/Body force=0; -0.01",
                                                  "Discretization/Strategy=hp",
                                                  "Discretization/Target error=0.005",
                                                  "Discretization/Coarsest level=0"});
  const Scene<2> scene = make_scene<2>(parameters);
  const MeshPlan plan = first_plan(scene, 0, 9);
  unsigned int n = 0;
  for (const Singularity &place : plan.singularities)
    if (place.point.distance(dealii::Point<2>(1., 1.)) < 1e-12)
    {
      ++n;
      checks.near("L, re-entrant corner: exponent", place.exponent, 0.544483737, 1e-6);
      checks.that("L, re-entrant corner: certain", place.is_certain);
    }
  checks.near("L, re-entrant corner: found once", n, 1, 0);
  std::ostream silence(nullptr);
  const StudyResult<2> result =
    run_study(parameters, scene, MPI_COMM_WORLD, {silence, "", [](const std::string &) {}});
  checks.that("L, hp: the target is reached",
              value(result.levels.back(), "estimated_relative").value() < 0.005 &&
                result.verdict.is_certified());
}
} // namespace

int main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  Checks checks;
  check_patch_tests(checks);
  check_orders(checks);
  check_corner(checks);
  return checks.exit_code();
}
