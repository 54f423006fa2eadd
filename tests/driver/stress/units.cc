// SPDX-License-Identifier: LGPL-2.1-or-later
// Units of length and stress: the same iterations, and the same numbers after conversion.

#include "stress.h"

using namespace Signorini;

namespace {
void test_units(Checks &checks) {
  const Measured reference = measure(text_of({}), levels(2, 6));
  for (const auto &[length, stress] :
       checks.rows<std::pair<std::string, std::string>>({{"1", "1e9"},
                                                         {"1", "1e-9"},
                                                         {"1e6", "1"},
                                                         {"1e-6", "1e9"},
                                                         {"1e-6", "1"},
                                                         {"1e6", "1e-9"}},
                                                        2)) {
    checks.about("lengths times " + length + ", stresses times " + stress);
    Family family;
    family.length = length;
    family.stress = stress;
    const Measured found = measure(text_of(family), levels(2, 6));
    checks.that("certified", found.is_certified());
    checks.that("the same iterations from scratch",
                found.psor == reference.psor && found.active_set == reference.active_set);
    const double L = std::stod(length), S = std::stod(stress);
    for (std::size_t k = 0; k < reference.study.levels.size(); ++k)
      for (const auto &[column, unit] :
           {std::pair("qp_iterations", 1.), std::pair("u_l2", L * L),
            std::pair("p_l2", S * std::sqrt(L)), std::pair("energy", S * L * L),
            std::pair("contact_force_n", S * L), std::pair("max_pressure", S),
            std::pair("estimated_relative", 1.)}) {
        const double expected = *value(reference.study.levels[k], column);
        checks.near(column, *value(found.study.levels.at(k), column) / unit, expected,
                    1e-9 * std::abs(expected));
      }
  }
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv, {test_units});
}
