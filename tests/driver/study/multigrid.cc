// SPDX-License-Identifier: LGPL-2.1-or-later
// Linear solver = multigrid: the pressure and the displacement that the factorisation gives, with
// every condition.

#include <signorini/base/errors.h>

#include "one_level.h"
#include "study_helpers.h"
#include "tests.h"

using namespace Signorini;

namespace
{
/** Relative to the larger one of the two; zero if both are. */
template <typename Vector>
double relative_distance(const Vector &a, const Vector &b)
{
  const double size = a.linfty_norm();
  return size > 0. ? distance(a, b) / size : b.linfty_norm();
}

void compare(Checks &checks, const std::string &name, const std::string &text)
{
  const OneLevel by_factors(text + entry("Solver", "Linear solver", "condensed"), 4);
  const OneLevel by_cycles(text + entry("Solver", "Linear solver", "multigrid"), 4);
  const LevelSolution<2> expected = by_factors.solve(), found = by_cycles.solve();
  checks.near(name + ": P", relative_distance(expected.P, found.P), 0., 1e-8);
  checks.near(name + ": U", relative_distance(expected.U, found.U), 0., 1e-8);
  checks.that(name + ": the active set",
              expected.record.contact.active == found.record.contact.active);
  checks.near(name + ": the estimate",
              found.record.estimate->energy / expected.record.estimate->energy,
              1.,
              1e-6);
}

const std::string sides = "subsection Boundary\nset Contact = bottom\n";

void scenes(Checks &checks)
{
  for (const char *const name : {"C4", "E3", "O1", "V1"})
    compare(checks, name, named_scene(name));
  compare(
    checks, "prescribed", sides + "set Rollers = left\nset Displacement = top: 0.1*x; -0.1\nend\n");
  compare(checks,
          "B-bar",
          sides + "set Displacement = top: 0; -0.1\nend\n" +
            entry("Material", "Poisson's ratio", "0.49") +
            entry("Discretization", "Element", "Q1 B-bar") +
            entry("Contact", "Gap", "0.2*(x-0.5)^2"));
  compare(checks,
          "held by contact alone",
          sides + "end\n" + entry("Load", "Body force", "0; -1") +
            entry("Contact", "Gap", "0.1*(x-0.5)^2"));
  compare(checks,
          "plate",
          sides + "set Rollers = left\nset Plates = top: 0, -1\nend\n" +
            entry("Load", "Plate force", "top: 0.1") + entry("Contact", "Gap", "0.1*x^2"));
}

/** What multigrid cannot do is said before the first level. */
void refusals(Checks &checks)
{
  const std::string text = sides + "set Clamped = top\nend\n";
  const std::vector<std::string> multigrid = {"Solver/Linear solver=multigrid"};
  const auto with = [&](const std::string &other) {
    std::vector<std::string> overrides = multigrid;
    overrides.push_back(other);
    return overrides;
  };
  checks.throws<InputError>("graded meshes",
                            "--set: Solver/Linear solver: found 'multigrid' with Strategy 'hp', "
                            "allowed with it: automatic, condensed.",
                            [&]() { solve(text, with("Discretization/Strategy=hp")); });
  checks.throws<InputError>(
    "matrices as files",
    "--set: Output/Compliance: found 'true' with Linear solver 'multigrid', "
    "which assembles no matrix, allowed with it: false.",
    [&]() { solve(text, with("Output/Compliance=true")); });
}

} // namespace

int main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  dealii::deal_II_exceptions::disable_abort_on_exception();
  Checks checks;
  scenes(checks);
  refusals(checks);
  return checks.exit_code();
}
