// SPDX-License-Identifier: LGPL-2.1-or-later
// A body and its obstacle, both moved by S: the answer does not depend on S, or it is refused.

#include <signorini/results/verdict/judge.h>

#include <cmath>
#include <sstream>

#include "one_level.h"
#include "tests.h"

using namespace Signorini;

namespace {
LevelSolution<2> solve(const double S) {
  std::ostringstream number;
  number << std::fixed << S;
  return OneLevel("", 4,
                  {"Material/Young's modulus=1000", "Boundary/Contact=bottom",
                   "Boundary/Displacement=top: 0; " + number.str() + " - 0.01",
                   "Contact/Gap=0.02*x - 0.005 - " + number.str(), "Discretization/Finest level=4",
                   "Output/Inf-sup constant=false"})
    .solve();
}

void test_translations(Checks &checks) {
  const Judge judge({1e-10, 0.2, 0.});
  const LevelSolution<2> unmoved = solve(0.);
  const LevelRecord &still = unmoved.record;
  checks.that("S = 0 is accepted", judge.accepts(still));
  for (const double S : {1., 1e4, 1e8, 1e14}) {
    checks.about("S = " + std::to_string(S));
    const LevelSolution<2> moved = solve(S);
    const LevelRecord &record = moved.record;
    if (!judge.accepts(record)) {
      checks.that("refused only if it is large", S > 1e4);
      checks.that("the translation is named",
                  judge.doubt(record).find("moved as a whole") != std::string::npos);
      continue;
    }
    // The statement of the certificate for forces.
    const double allowed = judge.residual_bound(record);
    for (const char *column :
         {"energy", "bound_energy", "bound_relative", "energy_lower", "energy_upper"})
      checks.near(column, *value(record, column) / *value(still, column), 1., allowed);
    checks.near("pressure",
                distance(moved.contact.P.normal(), unmoved.contact.P.normal()) /
                  unmoved.contact.P.normal().linfty_norm(),
                0., allowed);
    checks.near("displacement on the support", record.certificate.support, 0., 1e-15);
  }
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv, {test_translations});
}
