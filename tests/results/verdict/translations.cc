// SPDX-License-Identifier: LGPL-2.1-or-later
// A body and what it touches, both moved by S: the answer does not depend on S, or it is refused.

#include <signorini/results/verdict/judge.h>

#include <cmath>
#include <sstream>

#include "one_level.h"
#include "tests.h"

using namespace Signorini;

namespace
{
LevelSolution<2> solve(const double S)
{
  std::ostringstream number;
  number << std::fixed << S;
  return OneLevel("subsection Scene\nset Name = described\nend\n" +
                    entry("Material", "Young's modulus", "1000") +
                    "subsection Boundary\nset Contact = bottom\nset Displacement = top: 0; " +
                    number.str() + " - 0.01\nend\n" +
                    entry("Contact", "Gap", "0.02*x - 0.005 - " + number.str()) +
                    entry("Discretization", "Finest level", "4") +
                    entry("Output", "Inf-sup constant", "false"),
                  4)
    .solve();
}

void check(Checks &checks, const double S, const LevelSolution<2> &unmoved)
{
  std::ostringstream name;
  name << "S = " << S << ": ";
  const LevelSolution<2> moved = solve(S);
  const Judge judge({1e-10, 0.2, 0.});
  const auto &record = moved.record, &still = unmoved.record;
  if (!judge.accepts(record))
  {
    checks.that(name.str() + "refused only if it is large", S > 1e4);
    checks.that(name.str() + "the translation is named",
                judge.doubt(record).find("moved as a whole") != std::string::npos);
    return;
  }
  // What the certificate states for forces.
  const double allowed = judge.residual_bound(record);
  const auto same = [&](const std::string &what, const double a, const double b) {
    checks.near(name.str() + what, a / b, 1., allowed);
  };
  same("energy", record.certificate.energy, still.certificate.energy);
  dealii::Vector<double> change(moved.P);
  change -= unmoved.P;
  checks.between(
    name.str() + "pressure", change.linfty_norm() / unmoved.P.linfty_norm(), 0., allowed);
  same("bound", *record.bound->absolute, *still.bound->absolute);
  same("relative bound", *record.bound->relative, *still.bound->relative);
  same("energy from below", *record.bound->energy_lower, *still.bound->energy_lower);
  same("energy from above", *record.bound->energy_upper, *still.bound->energy_upper);
  checks.between(name.str() + "displacement on the support", record.certificate.support, 0., 1e-15);
}
} // namespace

int main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  Checks checks;
  const LevelSolution<2> unmoved = solve(0.);
  checks.that("S = 0 is accepted", Judge({1e-10, 0.2, 0.}).accepts(unmoved.record));
  for (const double S : {1., 1e4, 1e8, 1e14})
    check(checks, S, unmoved);
  return checks.exit_code();
}
