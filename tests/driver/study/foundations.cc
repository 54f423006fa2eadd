// SPDX-License-Identifier: LGPL-2.1-or-later
// Whole studies with rigid things: the digits of the gap by an expression, and the line contact of
// Hertz.

#include <signorini/problem/scene/foundation.h>

#include <deal.II/base/numbers.h>

#include "graded_steps.h"
#include "tests.h"

using namespace Signorini;
using dealii::numbers::PI;

namespace {
const std::string block = "subsection Geometry\nset Lower left = -1, 0\nset Cells = 2, 1\nend\n"
                          "subsection Boundary\nset Contact = bottom\n"
                          "set Displacement = top: 0; -0.05\nend\n";

/** The block on things, or on a gap. */
StudyResult<2> solve_on(const std::string &name, const std::string &value,
                        std::vector<std::string> overrides) {
  overrides.insert(overrides.begin(), "Contact/" + name + "=" + value);
  return solve(block, overrides);
}

void test_digits(Checks &checks) {
  struct Pair {
    std::string expression, obstacle;
  };
  for (const Pair &pair : std::vector<Pair>{
         {"x^2/4", "parabola 0,0 normal 0,2 curvature -0.5"},
         {"-0.0625", "plane -7,0.0625 normal 0,1"},
         {"min(0.125, 0.25)", "plane 0,-0.25 normal 0,1 | plane 0,-0.125 normal 0,3"}})
    for (const auto &overrides : {levels(2, 4), graded("1e-3")}) {
      const StudyResult<2> a = solve_on("Gap", pair.expression, overrides),
                           b = solve_on("Foundation", pair.obstacle, overrides);
      checks.near(pair.obstacle + ": levels", a.levels.size(), b.levels.size(), 0.);
      for (std::size_t i = 0; i < a.levels.size(); ++i)
        for (const char *column :
             {"energy", "kkt", "contact_force_n", "peak_pressure", "estimated_energy"})
          checks.that(pair.obstacle + ": the same digits",
                      value(a.levels[i], column) == value(b.levels.at(i), column));
    }
}

/** A disc of a hundredth of the block's size beside a large one, without kinks: graded meshes find
 * it, although gaps beside it are much larger than it. */
void test_small_disc(Checks &checks) {
  const std::string things = "circle 0.53,-0.03 radius 0.02 | circle -0.5,-1 radius 1";
  const StudyResult<2> result = solve_on("Foundation", things, graded("1e-3"));
  checks.that("a small disc, the accuracy is reached",
              result.verdict.outcome == Outcome::certified);
  checks.near("a small disc is found", result.levels.back().answer.zones.size(), 2, 0.);
  // H is a third of the small zone.
  checks.near("force with a small disc, against a nested level",
              last(result, "contact_force_n") /
                last(solve_on("Foundation", things, levels(7, 7)), "contact_force_n"),
              1., 0.01);
}

/** A square on its tip, held by nothing but a groove of two planes: each side of the groove carries
 * (∓W/2, W/2) of the weight W = 2. */
void test_groove(Checks &checks) {
  const StudyResult<2> result =
    solve("subsection Geometry\nset Shape = polygon\nset Vertices = 0,-1; 1,0; 0,1; -1,0\nend\n"
          "subsection Boundary\nset Contact = side0 side3\nend\n"
          "subsection Load\nset Body force = 0; -1\nend\n",
          levels(2, 4, {"Contact/Foundation=plane 0,-1 normal -1,1 | plane 0,-1 normal 3,3"}));
  checks.that("certified in a groove", result.verdict.outcome == Outcome::certified);
  for (unsigned int i = 0; i < 2; ++i)
    checks.near("forces in a groove",
                result.levels.back().answer.contact_by_side.at(i).resultant.force,
                dealii::Point<2>(i == 0 ? -1. : 1., 1.), 1e-9);
}

/** A roller in a groove of twice its radius, by Hertz: half the zone is b with b² = 4 F R_* /(pi
 * E*), the peak 2 F/(pi b); here E* = 8/3, 1/R_* = 1 - 1/2. The law holds up to (b/R)² = 0.014;
 * rollers on planes are in tests/driver/benchmarks. */
void test_hertz(Checks &checks) {
  const Parameters parameters = parse_parameters(named_scene("E3"), "test", graded("1e-3"));
  Scene<2> scene = make_scene<2>(parameters);
  scene.exact_displacement = scene.body_force = nullptr;
  scene.kinks = Kinks<2>();
  const std::size_t arc = scene.geometry.find_side("arc");
  BoundaryCondition<2> &condition = scene.boundary[arc];
  condition.exact_pressure = nullptr;
  condition.foundation = std::make_shared<Foundation>(
    std::vector<Obstacle>{Obstacle::circle({0., 1.}, 2., Body::inside)}, 20.);
  condition.data =
    foundation_gap(scene.geometry.sides[arc], condition.foundation, dealii::Point<2>(0., 0.01));
  const StudyResult<2> result = run(parameters, scene);
  const double F = last(result, "contact_force_n"), b = std::sqrt(4. * F * 2. / (PI * 8. / 3.));
  checks.between("Hertz, half width", b, 0.11, 0.12);
  checks.near("Hertz, zone", last(result, "contact_length") / (2. * b), 1., 0.01);
  checks.near("Hertz, peak", last(result, "peak_pressure") / (2. * F / (PI * b)), 1., 0.014);
  checks.that("Hertz, resolved", result.verdict.outcome == Outcome::certified);
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv, {test_digits, test_small_disc, test_groove, test_hertz});
}
