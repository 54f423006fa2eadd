// SPDX-License-Identifier: LGPL-2.1-or-later
// Benchmarks with closed forms on rectangles: own weight, a wavy foundation (Westergaard), a flat
// punch (Sadowsky). doc/benchmarks.md gives the sources.

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

#include "../../study_helpers.h"
#include "benchmarks.h"
#include "tests.h"

using namespace Signorini;
using dealii::numbers::PI;

namespace
{
const std::vector<std::string> hp = {"Discretization/Strategy=hp",
                                     "Discretization/Coarsest level=2",
                                     "Load cases/Cases="};

std::vector<std::string> operator+(std::vector<std::string> a, const std::vector<std::string> &b)
{
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

void test_own_weight(Checks &checks)
{
  const StudyResult<2> result = run_benchmark("own_weight");
  checks.that("own weight, certified", result.verdict.outcome == Outcome::certified);
  const LevelRecord &last = result.levels.back();
  checks.near("own weight, pressure", value(last, "p_l2").value(), 0., 1e-9);
  checks.near("own weight, nodes", value(last, "u_superclose_h1").value(), 0., 1e-9);
  checks.near("own weight, order in H1", slope(result.levels, "u_h1"), 1., 0.02);
  checks.near("own weight, order in L2", slope(result.levels, "u_l2"), 2., 0.02);
}

/** p* = pi E* delta/L of prm/benchmarks/westergaard.prm. */
const double full = PI * 0.01 / 0.91;

/** Half of the zone: sin(pi a/L) = share^{1/2}. */
double half_width(const double share)
{
  return share < 1. ? std::asin(std::sqrt(share)) / PI : 0.5;
}

double peak(const double share)
{
  return full * (share < 1. ? 2. * std::sqrt(share) : share + 1.);
}

void test_waves_nested(Checks &checks)
{
  const StudyResult<2> result =
    run_benchmark("westergaard", {"Discretization/Finest level=6"}, "out");
  checks.that("waves, certified", result.verdict.outcome == Outcome::certified);
  const std::vector<LevelRecord> finest(result.levels.begin() + 1, result.levels.end());
  checks.near("waves, order of the pressure in L2", slope(finest, "p_l2"), 1., 0.15);
  checks.near(
    "waves, order of the pressure in the dual norm", slope(result.levels, "p_dual"), 1.5, 0.2);
  // Load cases: force 0.2 to 6, on a quarter of p*.
  const double H = result.levels.back().sizes.H;
  double force = 0., zone = 0., largest = 0.;
  const auto cases = table_of("out/cases.csv");
  checks.that("waves, cases", cases.size() == 30);
  for (const auto &row : cases)
  {
    const double share = 0.25 * std::stod(row.at("force")), a = half_width(share);
    force =
      std::max(force, std::abs(std::stod(row.at("contact_force_y")) / (share * full / 2) - 1.));
    zone = std::max(zone, std::abs(std::stod(row.at("zone_length")) - a) / H);
    largest =
      std::max(largest, std::abs(std::stod(row.at("peak_pressure")) / peak(share) - 1.) * a / H);
  }
  checks.near("waves, forces of all cases", force, 0., 1e-10);
  checks.near("waves, zones of all cases over H", zone, 0., 1.);
  checks.near("waves, peaks of all cases, relative, over H/a", largest, 0., 0.25);
}

/** No difference but that of the discretisation: the finite depth changes p* by 1e-8. */
void test_waves_graded(Checks &checks, const double share)
{
  const std::string name = "waves, share " + std::to_string(share);
  const StudyResult<2> result =
    run_benchmark("westergaard",
                  hp + std::vector<std::string>{"Constants/share=" + std::to_string(share),
                                                "Discretization/Target error=1e-5"});
  const LevelRecord &last = result.levels.back();
  checks.that(name + ", the accuracy is reached",
              result.verdict.outcome == Outcome::accuracy_estimated);
  const ContactZone &zone = last.answer.zones.at(0);
  checks.that(name + ", one zone", last.answer.zones.size() == 1);
  checks.near(name + ", zone",
              zone.length,
              half_width(share),
              2. * (zone.start.uncertainty + zone.end.uncertainty) + 1e-12);
  checks.near(name + ", peak", last.answer.peak_pressure->value / peak(share), 1., 1e-5);
  checks.near(name + ", pressure", value(last, "p_l2").value() / full, 0., 1e-3);
}

/** The right half of a punch of the half width 1 under a block of the half width and the height w:
 * the difference from a half plane is that of a finite body, (a/w)^2. */
double test_punch(Checks &checks, const double w)
{
  const std::string name = "punch, width " + std::to_string(std::lround(w));
  const std::string size = std::to_string(w);
  const StudyResult<2> result = run_benchmark(
    "flat_punch",
    {"Geometry/Upper right=" + size + ", " + size, "Constants/width=" + size, "Output/VTU=none"},
    "punch");
  const LevelRecord &last = result.levels.back();
  checks.that(name + ", the accuracy is reached",
              result.verdict.outcome == Outcome::accuracy_estimated);
  checks.near(name + ", zone", last.answer.zones.at(0).length, 1., 1e-6);
  checks.that(name + ", the edge has no bounded pressure",
              last.answer.peak_pressure->value > 100. * 10. / PI);
  double difference = 0.;
  for (const auto &row : contact_table("punch", last))
    if (const double x = std::stod(row.at("x")); x < 0.95)
      difference = std::max(
        difference, std::abs(-std::stod(row.at("p_H")) * PI * std::sqrt(1. - x * x) / 10. - 1.));
  // 0.3 (a/w)^2 of the body, and the discretisation beside the edge.
  checks.near(name + ", pressure over that of a half plane", difference, 0., 0.005 + 0.6 / (w * w));
  const auto &[F, moment] = last.answer.contact_force.resultant;
  checks.near(name + ", force", F[1], 5., 1e-9);
  return moment[0] / F[1] - 2. / PI;
}
} // namespace

int main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  dealii::deal_II_exceptions::disable_abort_on_exception();
  Checks checks;
  test_own_weight(checks);
  test_waves_nested(checks);
  test_waves_graded(checks, 0.25);
  test_waves_graded(checks, 1.5);
  const double large = test_punch(checks, 32.), small = test_punch(checks, 8.);
  checks.near(
    "punch, lever arm, order of the finite body", std::log(small / large) / std::log(4.), 2., 0.05);
  checks.near("punch, lever arm", large, 0., 0.32 / (32. * 32.));
  return checks.exit_code();
}
