// SPDX-License-Identifier: LGPL-2.1-or-later
// Contact on a side with a corner is contact on the two sides that it consists of.

#include "study_helpers.h"
#include "tests.h"

using namespace Signorini;

namespace {
using Point = dealii::Point<2>;

const std::string text = "subsection Boundary\n set Contact = left bottom\n"
                         " set Displacement = top: -0.02; -0.03\nend\nsubsection Contact\n"
                         " set Gap = 0.02*x^2 + 0.03*y^2 + 0.001\nend\n";

/** The sides left and bottom as one, instead of the first. */
Scene<2> with_one_side(const Scene<2> &two, const bool gap_jumps) {
  Scene<2> one = two;
  const Curve around = Curve::chain({Curve(Point(0., 1.), Point(0., 0.), Point(-1., 0.)),
                                     Curve(Point(0., 0.), Point(1., 0.), Point(0., -1.))});
  one.geometry.sides = {{"around", around}, two.geometry.sides[1], two.geometry.sides[3]};
  one.boundary = {two.boundary[0], two.boundary[1], two.boundary[3]};
  // A distance along the normal: it jumps where the normal does.
  one.contacts.resize(1);
  if (gap_jumps)
    one.contacts[0].gap =
      std::make_shared<dealii::ScalarFunctionFromFunctionObject<2>>([around](const Point &x) {
        return around.normal(around.arc_length(x))[0] < -0.5 ? 0.02 : 0.005;
      });
  const auto number = [sides = one.geometry.sides](dealii::Triangulation<2> &triangulation) {
    number_boundary(sides, triangulation);
  };
  one.geometry.number_after_refinement = number;
  return one;
}

void compare(Checks &checks, const std::string &name, const std::vector<std::string> &overrides,
             const bool gap_jumps = false) {
  checks.about(name);
  const Parameters parameters = parse_parameters(text, "test", overrides);
  const Scene<2> two = make_scene<2>(parameters);
  const StudyResult<2> of_two = run(parameters, two),
                       of_one = run(parameters, with_one_side(two, gap_jumps));
  checks.near("levels", of_one.levels.size(), of_two.levels.size(), 0);
  for (const char *column : {"energy", "contact_force_n", "max_pressure", "contact_length",
                             "active", "estimated_energy"})
    checks.near(column, last(of_one, column) / last(of_two, column), 1., 1e-8);
  if (value(of_two.levels.back(), "bound_energy"))
    checks.near("bound", last(of_one, "bound_energy") / last(of_two, "bound_energy"), 1., 1e-8);
  checks.that("the same verdict", of_one.verdict.outcome == of_two.verdict.outcome);
}

void test_chains(Checks &checks) {
  compare(checks, "nested", levels(3, 5));
  compare(checks, "jump", levels(3, 5, {"Contact/Gap=left: 0.02 | bottom: 0.005"}), true);
  compare(checks, "graded",
          {"Discretization/Strategy=hp", "Discretization/Coarsest level=2",
           "Discretization/Target error=0.01"});
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv, {test_chains});
}
