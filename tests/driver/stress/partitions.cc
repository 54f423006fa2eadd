// SPDX-License-Identifier: LGPL-2.1-or-later
// H/h from 1 to 64, partitions that are aligned with nothing, and the relaxation near 0 and 2.

#include "stress.h"

using namespace Signorini;

namespace {
/** Measures the family on one level with a setting, and adds a row. */
Measured measure_with(Checks &checks, StabilityTable &table, const std::string &name,
                      const unsigned int level, const std::vector<std::string> &overrides) {
  checks.about(name);
  const Measured measured = measure(text_of({}), levels(level, level, overrides));
  table.add(name, measured);
  return measured;
}

void ratios(Checks &checks, StabilityTable &table) {
  for (const unsigned int ratio : checks.rows<unsigned int>({1, 2, 3, 4, 8, 16, 32, 64}, 2)) {
    const std::string k = std::to_string(ratio);
    const Measured measured =
      measure_with(checks, table, "H/h = " + k, 6, {"Discretization/Patch ratio=" + k});
    checks.that("certified", measured.is_certified());
    checks.that("stable if and only if H > h", (*measured.finest().inf_sup > 0.1) == (ratio > 1));
  }
}

/** 32 faces: more patches than nodes cannot be told apart. */
void unaligned(Checks &checks, StabilityTable &table) {
  for (const unsigned int n : checks.rows<unsigned int>({1, 3, 7, 13, 21, 31, 33, 64, 100}, 3)) {
    const std::string k = std::to_string(n);
    const Measured measured = measure_with(checks, table, k + " equal patches on 32 faces", 5,
                                           {"Discretization/Patches=" + k});
    checks.that("certified, or not unique",
                (n <= 33 && measured.is_certified()) || (n >= 31 && measured.names("not unique")));
  }
}

void relaxations(Checks &checks, StabilityTable &table) {
  double force = 0.;
  for (const std::string &omega : checks.rows<std::string>(
         {"1.1", "0.02", "0.1", "1", "1.5", "1.95", "1.99", "1e-6", "1.9999999"}, 2)) {
    const Measured measured =
      measure_with(checks, table, "omega = " + omega, 5,
                   {"Solver/Contact solver=psor", "Solver/Relaxation=" + omega});
    if (std::min(std::stod(omega), 2. - std::stod(omega)) < 1e-3) {
      checks.that("too many sweeps, and it is said", measured.names("Maximum iterations"));
      continue;
    }
    checks.that("certified", measured.is_certified());
    force = force == 0. ? last(measured.study, "contact_force_n") : force;
    checks.near("the same force", last(measured.study, "contact_force_n") / force, 1., 1e-8);
  }
}

void test(Checks &checks) {
  StabilityTable table("partitions", "partition, or relaxation");
  ratios(checks, table);
  unaligned(checks, table);
  relaxations(checks, table);
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv, {test});
}
