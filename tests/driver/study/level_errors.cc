// SPDX-License-Identifier: LGPL-2.1-or-later
// The errors of all nested levels from the stress of one graded run, against known solutions: the
// interval contains the error of every level, and is three digits wide at most. Writes
// level_errors.csv into the working directory.

#include <fstream>
#include <iomanip>

#include "study_helpers.h"
#include "tests.h"

using namespace Signorini;

namespace {
struct KnownScene {
  std::string file;
  unsigned int coarsest, finest;
  std::vector<std::string> settings = {};
  /** The largest difference between the error of u_h on its mesh and on the body, relative. */
  double of_mesh = 0.;
};

void check(Checks &checks, std::ostream &table, const KnownScene &given) {
  constexpr double widest = 1e-3, quadrature = 1e-6;
  const StudyResult<2> result = solve_file(SOURCE_DIR "/prm/" + given.file + ".prm",
                                           levels(given.coarsest, given.finest, given.settings));
  double lower = -1e300, upper = 1e300;
  for (const LevelRecord &level : result.levels) {
    checks.about(given.file + (given.settings.empty() ? "" : " " + given.settings[0]) + ", level " +
                 std::to_string(level.sizes.level));
    const bool is_known = level.bound && level.bound->distance && level.displacement_errors;
    checks.that("the error is known", is_known);
    if (!is_known)
      continue;
    const ErrorBound &bound = *level.bound;
    const double error = level.displacement_errors->energy, distance = *bound.distance,
                 margin = *bound.margin;
    // The error against the exact solution has a quadrature of its own.
    checks.near("distance", distance, error, margin + (quadrature + given.of_mesh) * error);
    checks.between("width", 2. * margin / distance, 0., widest);
    checks.near("bound", *bound.absolute, distance + margin, 1e-14 * distance);
    if (bound.energy_lower) {
      lower = std::max(lower, *bound.energy_lower);
      upper = std::min(upper, *bound.energy_upper);
    }
    table << '"' << given.file << "\"," << level.sizes.level << ',' << std::setprecision(8)
          << distance << ',' << std::setprecision(2) << margin / distance << ','
          << distance / error - 1. << '\n';
  }
  checks.about(given.file);
  checks.that("one bracket of the energy", lower <= upper);
}

void distances_of_levels(Checks &checks) {
  std::ofstream table("level_errors.csv");
  const std::vector<KnownScene> scenes = {
    {"a1", 2, 6},
    {"b3", 3, 6},
    {"described_a1", 2, 5, {"Geometry/Distortion=0.2"}},
    {"friction/t1", 2, 5},
    {"bodies/a1", 2, 5},
    {"e1", 1, 4, {}, 1e-3},
    {"b1", 3, 6},
    {"v1", 3, 6},
    {"a1", 2, 5, {"Discretization/Element=Q2"}},
    {"nearly_incompressible", 2, 6},
    {"friction/k1", 2, 6},
    {"c3", 2, 6},
  };
  for (const KnownScene &scene : checks.rows(scenes, 6))
    check(checks, table, scene);
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv, {distances_of_levels});
}
