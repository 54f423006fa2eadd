// SPDX-License-Identifier: LGPL-2.1-or-later
// Benchmarks with closed forms on rectangles: own weight, a wavy foundation (Westergaard), a flat
// punch (Sadowsky). The heads of prm/benchmarks give the sources.

#include <deal.II/base/numbers.h>

#include <cmath>

#include "benchmarks.h"
#include "tests.h"

using namespace Signorini;
using dealii::numbers::PI;

namespace {
void test_own_weight(Checks &checks) {
  const StudyResult<2> result = run_benchmark("own_weight");
  checks.that("own weight, certified", result.verdict.outcome == Outcome::certified);
  checks.near("own weight, pressure", last(result, "p_l2"), 0., 1e-9);
  checks.near("own weight, nodes", last(result, "u_superclose_h1"), 0., 1e-9);
  check_orders(checks, result.levels, {{"u_h1", 0.98, 1.02}, {"u_l2", 1.98, 2.02}});
}

/** p* = pi E* delta/L of prm/benchmarks/westergaard.prm. */
const double full = PI * 0.01 / 0.91;

/** Half of the zone: sin(pi a/L) = share^{1/2}. */
double half_width(const double share) {
  return share < 1. ? std::asin(std::sqrt(share)) / PI : 0.5;
}

double peak(const double share) {
  return full * (share < 1. ? 2. * std::sqrt(share) : share + 1.);
}

void test_waves_nested(Checks &checks) {
  const StudyResult<2> result =
    run_benchmark("westergaard", {"Discretization/Finest level=6"}, "out");
  checks.that("waves, certified", result.verdict.outcome == Outcome::certified);
  check_orders(checks, {result.levels.begin() + 1, result.levels.end()}, {{"p_l2", 0.85, 1.15}});
  check_orders(checks, result.levels, {{"p_dual", 1.3, 1.7}});
  // Load cases: force 0.2 to 6, on a quarter of p*.
  const double H = result.levels.back().sizes.H;
  const auto cases = read_csv(file_text("out/cases.csv"));
  checks.near("waves, cases", cases.size(), 30, 0.);
  for (const auto &row : cases) {
    const auto number = [&](const char *name) { return std::stod(row.at(name)); };
    const double share = 0.25 * number("force"), a = half_width(share);
    checks.near("waves, forces of all cases", number("contact_force_y") / (share * full / 2), 1.,
                1e-10);
    checks.near("waves, zones of all cases", number("zone_length"), a, H);
    checks.near("waves, peaks of all cases", number("peak_pressure") / peak(share), 1.,
                0.25 * H / a);
  }
}

/** No difference but that of the discretisation: the finite depth changes p* by 1e-8. */
void test_waves_graded(Checks &checks, const double share) {
  const std::string name = "waves, share " + std::to_string(share);
  const StudyResult<2> result =
    run_benchmark("westergaard", {"Constants/share=" + std::to_string(share),
                                  "Discretization/Strategy=hp", "Discretization/Coarsest level=2",
                                  "Discretization/Target error=1e-6", "Load cases/Cases="});
  const LevelRecord &last = result.levels.back();
  checks.that(name + ", the accuracy is reached", result.verdict.outcome == Outcome::certified);
  const ContactZone &zone = last.answer.zones.at(0);
  checks.that(name + ", one zone", last.answer.zones.size() == 1);
  checks.near(name + ", zone", zone.length, half_width(share),
              2. * (zone.start.uncertainty + zone.end.uncertainty) + 1e-12);
  checks.near(name + ", peak", last.answer.peak_pressure->value / peak(share), 1., 1e-5);
  checks.near(name + ", pressure", value(last, "p_l2").value() / full, 0., 1e-3);
}

/** The right half of a punch of the half width 1 under a block of the half width and the height w:
 * the difference from a half plane is that of a finite body, (a/w)^2. */
double test_punch(Checks &checks, const double w) {
  const std::string name = "punch, width " + std::to_string(std::lround(w));
  const std::string size = std::to_string(w);
  const StudyResult<2> result =
    run_benchmark("flat_punch",
                  {"Geometry/Upper right=" + size + ", " + size, "Constants/width=" + size,
                   "Output/VTU=none", "Discretization/Target error=3e-4"},
                  "punch");
  const LevelRecord &last = result.levels.back();
  checks.that(name + ", the accuracy is reached", result.verdict.outcome == Outcome::certified);
  checks.near(name + ", zone", last.answer.zones.at(0).length, 1., 1e-6);
  checks.that(name + ", the edge has no bounded pressure",
              last.answer.peak_pressure->value > 100. * 10. / PI);
  // 0.3 (a/w)^2 of the body, and the discretisation beside the edge.
  const std::string number = std::to_string(last.sizes.level);
  for (const auto &row : read_csv(
         file_text("punch/contact-" + std::string(number.size() < 2 ? "0" : "") + number + ".csv")))
    if (const double x = std::stod(row.at("x")); x < 0.95)
      checks.near(name + ", pressure over that of a half plane",
                  -std::stod(row.at("p_H")) * PI * std::sqrt(1. - x * x) / 10., 1.,
                  0.005 + 0.6 / (w * w));
  const auto &[F, moment] = last.answer.contact_force.resultant;
  checks.near(name + ", force", F[1], 5., 1e-9);
  return moment[0] / F[1] - 2. / PI;
}

void test_waves(Checks &checks) {
  test_waves_nested(checks);
  test_waves_graded(checks, 0.25);
  test_waves_graded(checks, 1.5);
}

void test_punches(Checks &checks) {
  const double large = test_punch(checks, 32.), small = test_punch(checks, 8.);
  checks.near("punch, lever arm, order of the finite body", std::log(small / large) / std::log(4.),
              2., 0.05);
  checks.near("punch, lever arm", large, 0., 0.32 / (32. * 32.));
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv, {test_own_weight, test_waves, test_punches});
}
