// SPDX-License-Identifier: LGPL-2.1-or-later
// Scenes with two elastic bodies in prm/bodies, against closed forms.

#include <deal.II/base/numbers.h>

#include <cmath>

#include "one_level.h"
#include "study_helpers.h"
#include "tests.h"

using namespace Signorini;
using dealii::numbers::PI;

namespace {
const std::string folder = SOURCE_DIR "/../../../prm/bodies/";

/** Two cylinders: the pressure of the middle patch, the half width, and how far the normals turn.
 */
void test_hertz(Checks &checks) {
  const StudyResult<2> result = solve_file(folder + "hertz.prm");
  const Answer &answer = result.levels.back().answer;
  const double N = last(result, "contact_force_n"), R = 2.4, E = 1. / (0.91 * 1.25),
               a = std::sqrt(4. * N * R / (PI * E)), peak = 2. * N / (PI * a),
               H = result.levels.back().sizes.H;
  // The mean over the patch [0, H].
  const double mean = peak * 0.5 * (std::sqrt(1. - H * H / (a * a)) + a / H * std::asin(H / a));
  checks.near("mean of the patch of the peak", answer.peak_pressure->mean, mean, 0.01 * mean);
  checks.near("half width", 0.5 * answer.zones.front().length, a, 0.25 * H);
  checks.near("turn of the normals", answer.turn_of_normals, a / R, H / R);
}
/** A pin that hardly yields is the rigid one of prm/plate_with_hole.prm, whose patches are half as
 * long. */
void test_rigid_pin(Checks &checks) {
  const auto force = [](const std::string &file, const std::vector<std::string> &overrides) {
    std::vector<std::string> all = {"Discretization/Coarsest level=2",
                                    "Discretization/Finest level=2"};
    all.insert(all.end(), overrides.begin(), overrides.end());
    const StudyResult<2> result = solve_file(file, all);
    return result.levels.back().answer.contact_force.resultant.force[0];
  };
  const double rigid = force(folder + "../plate_with_hole.prm", {});
  checks.near("a rigid pin", force(folder + "pin_in_lug.prm", {"k=1e6"}), rigid,
              5e-3 * std::abs(rigid));
}

} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv, {test_hertz, test_rigid_pin});
}
