// SPDX-License-Identifier: LGPL-2.1-or-later
// Poisson's ratio towards 1/2: bilinear elements lock and say so, B-bar keeps its orders and
// errors.

#include "stress.h"

using namespace Signorini;

namespace
{
void bilinear(Checks &checks, StabilityTable &table)
{
  for (const char *nu : {"0.3", "0.49", "0.499", "0.4999", "0.499999"})
  {
    const Measured q1 = measure(text_of({nu}), levels(3, 5));
    table.add(std::string("Q1, ν = ") + nu, q1);
    const std::string name = std::string("Q1, nu = ") + nu;
    if (std::stod(nu) < 0.495)
      checks.that(name + ": certified", q1.is_certified());
    else
      checks.that(name + ": not certified, locking is named", q1.names("lock"));
  }
}

void b_bar(Checks &checks, StabilityTable &table)
{
  double p_error_at_0_3 = 0.;
  for (const char *nu : {"0.3", "0.49", "0.499", "0.4999", "0.499999", "0.49999999"})
  {
    std::vector<std::string> overrides = levels(3, 5);
    overrides.emplace_back("Discretization/Element=Q1 B-bar");
    const Measured bar = measure(text_of({nu}), overrides);
    table.add(std::string("Q1 B-bar, ν = ") + nu, bar);
    const std::string name = std::string("B-bar, nu = ") + nu;
    if (std::string(nu) == "0.49999999")
    {
      checks.that(name + ": certified, or rounding is named",
                  bar.is_certified() || bar.names("rounding"));
      continue;
    }
    checks.that(name + ": certified", bar.is_certified());
    checks.between(name + ": order of |u-uh|_1", slope(bar.study.levels, "u_h1"), 0.95, 1.2);
    checks.between(name + ": order of |u-uh|_0", slope(bar.study.levels, "u_l2"), 1.9, 2.2);
    checks.between(
      name + ": order of |Iu-uh|_1", slope(bar.study.levels, "u_superclose_h1"), 1.9, 2.6);
    checks.between(name + ": order of |p-pH|_0", slope(bar.study.levels, "p_l2"), 0.9, 1.1);
    if (p_error_at_0_3 == 0.)
      p_error_at_0_3 = *value(bar.finest(), "p_l2");
    checks.near(name + ": |p-pH|_0 is that of nu = 0.3",
                *value(bar.finest(), "p_l2") / p_error_at_0_3,
                1.,
                0.01);
  }
}
} // namespace

int main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  dealii::deal_II_exceptions::disable_abort_on_exception();
  Checks checks;
  StabilityTable table("poissons_ratio", "Poisson's ratio");
  bilinear(checks, table);
  b_bar(checks, table);
  return checks.exit_code();
}
