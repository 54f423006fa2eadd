// SPDX-License-Identifier: LGPL-2.1-or-later
// Contact on a side with a corner is contact on the two sides that it consists of.

#include <signorini/base/errors.h>

#include "study_helpers.h"
#include "tests.h"

using namespace Signorini;

namespace
{
using Point = dealii::Point<2>;

const std::string text = R"(
subsection Boundary
  set Contact      = left bottom
  set Displacement = top: -0.02; -0.03
end
subsection Contact
  set Gap = 0.02*x^2 + 0.03*y^2 + 0.001
end
)";

/** A distance along the normal: it jumps where the normal does. */
class GapByNormal : public dealii::Function<2>
{
public:
  explicit GapByNormal(const Curve &curve)
    : curve_(curve)
  {
  }
  double value(const Point &x, const unsigned int /*component*/ = 0) const override
  {
    return curve_.normal(curve_.arc_length(x))[0] < -0.5 ? 0.002 : 0.005;
  }

private:
  Curve curve_;
};

/** The sides left and bottom as one, in the place of the first. */
Scene<2> with_one_side(const Scene<2> &two, const bool gap_jumps)
{
  Scene<2> one = two;
  const Curve around = Curve::chain({Curve(Point(0., 1.), Point(0., 0.), Point(-1., 0.)),
                                     Curve(Point(0., 0.), Point(1., 0.), Point(0., -1.))});
  one.geometry.sides = {{"around", around}, two.geometry.sides[1], two.geometry.sides[3]};
  one.boundary = {two.boundary[0], two.boundary[1], two.boundary[3]};
  if (gap_jumps)
    one.boundary[0].data = std::make_shared<GapByNormal>(around);
  const auto number = [sides = one.geometry.sides](dealii::Triangulation<2> &triangulation) {
    number_boundary(sides, triangulation);
  };
  one.geometry.number_after_refinement = number;
  return one;
}

StudyResult<2> run(const Parameters &parameters, const Scene<2> &scene)
{
  std::ostream silence(nullptr);
  return run_study(parameters, scene, MPI_COMM_WORLD, {silence, "", [](const std::string &) {}});
}

void compare(Checks &checks,
             const std::string &name,
             const std::vector<std::string> &overrides,
             const bool gap_jumps = false)
{
  const Parameters parameters = parse_parameters(text, "test", overrides);
  const Scene<2> two = make_scene<2>(parameters);
  const StudyResult<2> of_two = run(parameters, two),
                       of_one = run(parameters, with_one_side(two, gap_jumps));
  checks.near(name + ": levels", of_one.levels.size(), of_two.levels.size(), 0);
  const LevelRecord &a = of_two.levels.back(), &b = of_one.levels.back();
  for (const char *column : {"energy",
                             "contact_force_n",
                             "max_pressure",
                             "contact_length",
                             "active",
                             "estimated_energy"})
  {
    const double expected = value(a, column).value();
    checks.near(
      name + ": " + column, value(b, column).value(), expected, 1e-8 * std::abs(expected));
  }
  // Below a straight side the bound knows a better displacement.
  if (const auto bound = value(a, "bound_energy"))
    checks.between(name + ": bound", value(b, "bound_energy").value(), *bound, 1.2 * *bound);
  checks.that(name + ": the same verdict", of_one.verdict.outcome == of_two.verdict.outcome);
}
} // namespace

int main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  Checks checks;
  compare(checks, "nested", {"Discretization/Coarsest level=3", "Discretization/Finest level=5"});
  compare(checks,
          "H=4h",
          {"Discretization/Patch ratio=4",
           "Discretization/Coarsest level=4",
           "Discretization/Finest level=4"});
  compare(checks,
          "jump",
          {"Contact/Gap=left: 0.002 | bottom: 0.005",
           "Discretization/Coarsest level=3",
           "Discretization/Finest level=5"},
          true);
  compare(checks,
          "graded",
          {"Discretization/Strategy=hp",
           "Discretization/Coarsest level=2",
           "Discretization/Target error=0.01"});
  return checks.exit_code();
}
