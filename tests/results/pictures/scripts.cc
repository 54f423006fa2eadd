// SPDX-License-Identifier: LGPL-2.1-or-later
// What gnuplot is told, for data that is known.

#include <signorini/results/pictures/convergence_picture.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "tests.h"

using namespace Signorini;

namespace
{
bool contains(const Picture &picture, const std::string &text)
{
  return picture.script.find(text) != std::string::npos;
}

/** A level whose estimated error is h. */
LevelRecord level_of_order_one(const unsigned int level)
{
  LevelRecord record;
  record.sizes.level = level;
  record.sizes.h = std::pow(0.5, level);
  record.sizes.dofs = 1ULL << (2 * level);
  record.estimate.emplace();
  record.estimate->relative = record.sizes.h;
  record.estimate->energy = 3. * record.sizes.h;
  return record;
}

void test_convergence(Checks &checks)
{
  std::vector<LevelRecord> levels = {
    level_of_order_one(2), level_of_order_one(3), level_of_order_one(4)};
  const std::optional<Picture> picture = convergence_picture(levels);
  checks.that("convergence: drawn", picture.has_value());
  checks.that("  the estimate over unknowns",
              contains(*picture, "16 0.25\n64 0.125\n256 0.0625\n"));
  checks.that("  with its order", contains(*picture, "'estimated, order 1.00 in h'"));
  checks.that("  with a triangle", contains(*picture, "$triangle with lines"));
  checks.that("  without an error that is not known", !contains(*picture, "'error"));

  // |||u - u_h||| = 6 h is two times the estimate.
  for (LevelRecord &level : levels)
    level.displacement_errors = DisplacementErrors{0., 0., 0., {}, {}, 6. * level.sizes.h};
  const std::optional<Picture> with_errors = convergence_picture(levels);
  checks.that("  with the error relative to the same norm",
              contains(*with_errors, "16 0.5\n64 0.25\n256 0.125\n"));

  levels.back().sizes.strategy = Strategy::hp;
  const std::optional<Picture> graded = convergence_picture(levels);
  checks.that("  graded meshes have no order in h", !contains(*graded, "in h"));

  for (LevelRecord &level : levels)
  {
    level.estimate->relative = 1e-15;
    level.displacement_errors.reset();
  }
  checks.that("  nothing for errors that are rounding", !convergence_picture(levels));
  checks.that("  nothing without levels", !convergence_picture({}));
}

void test_travel(Checks &checks)
{
  TravelCurve cases = {{0.1, 0.2, 0.3}, {3., 6., 0.}, {4., 8., -1.}, {2., 4., 5.}, {0.5, 0.75, 1.}};
  const std::optional<Picture> picture = travel_picture(cases);
  checks.that("travel: |F|, peak and zone over travel",
              contains(*picture, "0.1 5 2 0.5\n0.2 10 4 0.75\n0.3 1 5 1\n"));
  // Travel from 0.1 to 0.3 and forces from 1 to 10.
  checks.that("  tics leave room",
              contains(*picture, "set xtics 0.05\n") && contains(*picture, "set xtics 2\n"));
  cases.peak[1] = std::numeric_limits<double>::quiet_NaN();
  checks.that("  an unknown number is a hole",
              contains(*travel_picture(cases), "0.2 10 NaN 0.75\n"));
  checks.throws<std::invalid_argument>("  columns of one size", "different sizes", [&]() {
    TravelCurve wrong = cases;
    wrong.peak.pop_back();
    travel_picture(wrong);
  });
  checks.that("  nothing for one case", !travel_picture({{1.}, {1.}, {1.}, {1.}, {1.}}));
}
} // namespace

int main()
{
  Checks checks;
  test_convergence(checks);
  test_travel(checks);
  return checks.exit_code();
}
