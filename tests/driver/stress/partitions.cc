// SPDX-License-Identifier: LGPL-2.1-or-later
// H/h from 1 to 64, partitions that are aligned with nothing, and the relaxation near 0 and 2.

#include "stress.h"

using namespace Signorini;

namespace
{
void ratios(Checks &checks, StabilityTable &table)
{
  for (const unsigned int ratio : {1, 2, 3, 4, 8, 16, 32, 64})
  {
    const std::string name = "H/h = " + std::to_string(ratio);
    std::vector<std::string> overrides = levels(6, 6);
    overrides.push_back("Discretization/Patch ratio=" + std::to_string(ratio));
    const Measured measured = measure(text_of({}), overrides);
    table.add(name, measured);
    checks.that(name + ": certified", measured.is_certified());
    checks.that(name + ": stable if and only if H > h",
                (*measured.finest().inf_sup > 0.1) == (ratio > 1));
  }
}

/** 32 faces. */
void unaligned(Checks &checks, StabilityTable &table)
{
  for (const unsigned int n : {1, 3, 7, 13, 21, 31, 33, 64, 100})
  {
    const std::string name = std::to_string(n) + " equal patches on 32 faces";
    std::vector<std::string> overrides = levels(5, 5);
    overrides.push_back("Discretization/Patches=" + std::to_string(n));
    const Measured measured = measure(text_of({}), overrides);
    table.add(name, measured);
    if (n < 31)
      checks.that(name + ": certified", measured.is_certified());
    else
      checks.that(name + ": certified, or not unique",
                  measured.is_certified() || measured.names("not unique"));
    // More patches than nodes cannot be told apart.
    if (n > 33)
      checks.that(name + ": not unique", measured.names("not unique"));
  }
}

void relaxations(Checks &checks, StabilityTable &table)
{
  double force = 0.;
  for (const char *omega : {"1.1", "0.02", "0.1", "1", "1.5", "1.95", "1.99", "1e-6", "1.9999999"})
  {
    const std::string name = std::string("omega = ") + omega;
    std::vector<std::string> overrides = levels(5, 5);
    overrides.insert(overrides.end(),
                     {"Solver/Contact solver=psor", std::string("Solver/Relaxation=") + omega});
    const Measured measured = measure(text_of({}), overrides);
    table.add(name, measured);
    const double distance_to_limits = std::min(std::stod(omega), 2. - std::stod(omega));
    if (distance_to_limits < 1e-3)
    {
      checks.that(name + ": too many sweeps, and it is said", measured.names("Maximum iterations"));
      continue;
    }
    checks.that(name + ": certified", measured.is_certified());
    force = force == 0. ? measured.finest().contact.normal_force : force;
    checks.near(
      name + ": the same force", measured.finest().contact.normal_force / force, 1., 1e-8);
  }
}
} // namespace

int main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  dealii::deal_II_exceptions::disable_abort_on_exception();
  Checks checks;
  StabilityTable table("partitions", "partition, or relaxation");
  ratios(checks, table);
  unaligned(checks, table);
  relaxations(checks, table);
  return checks.exit_code();
}
