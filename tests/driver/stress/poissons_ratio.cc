// SPDX-License-Identifier: LGPL-2.1-or-later
// Poisson's ratio towards 1/2: bilinear elements lock and say so, B-bar keeps its orders and
// errors.

#include "stress.h"

using namespace Signorini;

namespace {
void bilinear(Checks &checks, StabilityTable &table) {
  for (const std::string &nu :
       checks.rows<std::string>({"0.3", "0.49", "0.499", "0.4999", "0.499999"}, 2)) {
    const Measured q1 = measure(text_of({nu}), levels(3, 5));
    table.add("Q1, ν = " + nu, q1);
    checks.that("Q1, nu = " + nu + ": certified, or locking is named",
                std::stod(nu) < 0.495 ? q1.is_certified() : q1.names("lock"));
  }
}

void b_bar(Checks &checks, StabilityTable &table) {
  double p_error_at_0_3 = 0.;
  for (const std::string &nu :
       checks.rows<std::string>({"0.3", "0.49", "0.499", "0.4999", "0.499999", "0.49999999"}, 2)) {
    const Measured bar = measure(text_of({nu}), levels(3, 5, {"Discretization/Element=Q1 B-bar"}));
    table.add("Q1 B-bar, ν = " + nu, bar);
    checks.about("B-bar, nu = " + nu);
    if (nu == "0.49999999") {
      checks.that("certified, or rounding is named", bar.is_certified() || bar.names("rounding"));
      continue;
    }
    checks.that("certified", bar.is_certified());
    check_orders(
      checks, bar.study.levels,
      {{"u_h1", 0.95, 1.2}, {"u_l2", 1.9, 2.2}, {"u_superclose_h1", 1.9, 2.6}, {"p_l2", 0.9, 1.1}});
    const double p_error = last(bar.study, "p_l2");
    p_error_at_0_3 = nu == "0.3" ? p_error : p_error_at_0_3;
    checks.near("p_l2 is that of nu = 0.3", p_error / p_error_at_0_3, 1., 0.01);
  }
}

void test(Checks &checks) {
  StabilityTable table("poissons_ratio", "Poisson's ratio");
  bilinear(checks, table);
  b_bar(checks, table);
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv, {test});
}
