// SPDX-License-Identifier: LGPL-2.1-or-later
// Graded meshes on every scene with a known solution: the estimate is nowhere below half of the
// error, the error falls exponentially with the cubic root of the unknowns, and what it costs to
// come below 1e-6.

#include <deal.II/base/mpi.h>

#include <optional>

#include "graded_steps.h"
#include "tests.h"

using namespace Signorini;

namespace
{
/** What a line through log(error) over N^{1/3} shall be, and the cost of an error of 1e-6. */
struct Convergence
{
  /** At least this |r|. */
  double correlation;
  /** At most so many unknowns. */
  double unknowns;
};

struct Expectation
{
  const char *name;
  std::optional<Convergence> convergence;
};

// Singular solutions, which the theory is about. C4 has no singularity; once all its ends of
// contact are found, the error falls faster than on a line.
const std::vector<Expectation> expectations = {{"A1", {}},
                                               {"A2", {}},
                                               {"A3", Convergence{0.97, 11000.}},
                                               {"B1", Convergence{0.97, 10000.}},
                                               {"B1q", {}},
                                               {"B2", Convergence{0.97, 17000.}},
                                               {"B3", Convergence{0.97, 25000.}},
                                               {"B4", Convergence{0.97, 10000.}},
                                               {"C1", {}},
                                               {"C2", {}},
                                               {"C3", {}},
                                               {"C4", Convergence{0.9, 25000.}},
                                               {"D1", {}},
                                               {"E1", {}},
                                               {"E2", Convergence{0.97, 40000.}},
                                               {"E3", {}},
                                               {"O1", {}},
                                               {"V1", {}}};

/** The smallest ratio of estimate and error, where these are not rounding. */
double smallest_effectivity(const std::vector<GradedStep> &steps)
{
  constexpr double rounding = 1e-11;
  double smallest = INFINITY;
  for (const GradedStep &step : steps)
    if (step.estimate > rounding || step.error > rounding)
      smallest = std::min(smallest, step.estimate / step.error);
  return smallest;
}

std::vector<GradedStep> check_estimate(Checks &checks,
                                       const std::string &name,
                                       const StudyResult<2> &result)
{
  const std::vector<GradedStep> steps = steps_of(result.levels);
  checks.that(name + ", the target is reached",
              result.verdict.outcome == Outcome::accuracy_estimated);
  checks.between(
    name + ", estimate over error, smallest", smallest_effectivity(steps), 0.5, INFINITY);
  checks.between(name + ", error of the last step", steps.back().error, 0., 2e-6);
  return steps;
}

void check_scene(Checks &checks, const Expectation &expected)
{
  const std::string name = expected.name;
  const std::vector<GradedStep> steps =
    check_estimate(checks, name, solve(named_scene(name), graded("1e-6")));
  if (!expected.convergence)
    return;
  const ExponentialFit fit = fit_exponential(steps);
  checks.between(name + ", slope of log(error) over N^{1/3}", fit.slope, -2., -0.3);
  checks.between(name + ", correlation", fit.correlation, -1., -expected.convergence->correlation);
  checks.between(name + ", unknowns for an error of 1e-6",
                 unknowns_for(steps, 1e-6),
                 0.,
                 expected.convergence->unknowns);
}

/** Scenes by expressions. */
void check_file(Checks &checks, const std::string &name)
{
  std::ostream silence(nullptr);
  const Parameters parameters =
    read_parameters(SOURCE_DIR "/../../../prm/" + name + ".prm", graded("1e-6"));
  check_estimate(checks,
                 name,
                 run_study(parameters,
                           make_scene<2>(parameters),
                           MPI_COMM_WORLD,
                           {silence, "", [](const std::string &) {}}));
}
} // namespace

int main(int argc, char **argv)
{
  dealii::deal_II_exceptions::disable_abort_on_exception();
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  Checks checks;
  for (const Expectation &expected : expectations)
    check_scene(checks, expected);
  for (const char *name : {"nearly_incompressible", "two_contact_sides"})
    check_file(checks, name);
  return checks.exit_code();
}
