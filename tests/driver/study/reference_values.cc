// SPDX-License-Identifier: LGPL-2.1-or-later
// Whole studies against numbers of an independent implementation in another language (double
// precision, integrals to rounding), on one, two and three processes.

#include "study_helpers.h"
#include "tests.h"

using namespace Signorini;

namespace {
struct Reference {
  std::string name, patches;
  unsigned int level, active;
  double contact_force, energy, max_pressure;
};

const std::vector<Reference> references = {
  {"quadrilateral", "0", 3, 3, 0.13858240027660498, -0.005890348458949236, 0.2282780518280852},
  {"quadrilateral", "0", 4, 6, 0.13839192367425984, -0.005925781477892526, 0.20266948649475497},
  {"pentagon", "0", 3, 3, 0.04003223301365762, -0.0057536690077261395, 0.12753890606349427},
  {"pentagon", "0", 4, 7, 0.04017614509343021, -0.005770977766959463, 0.12432245043818371},
  {"prescribed", "0", 3, 3, 0.19337692547438123, 0.00127128827705591, 0.21051853341817103},
  {"prescribed", "0", 4, 5, 0.19375090829099711, 0.0013847422957592973, 0.19149293342669613},
  {"a1", "0", 4, 5, 0.624997097728132, -0.3288733998864932, 2.876448375675366},
  {"a1", "7", 4, 4, 0.6251670745768318, -0.3290949291164004, 2.7803898504688527},
  {"two_sides", "0", 4, 9, 2.23083963816478, -2.9371927226528616, 5.83514119178593}};

StudyResult<2> solve_run(const std::string &name, const std::vector<std::string> &overrides) {
  return solve_file(SOURCE_DIR "/tests/driver/runs/" + name + ".prm", overrides);
}

void compare(Checks &checks) {
  for (const Reference &reference : references) {
    checks.about(reference.name + " level " + std::to_string(reference.level));
    const StudyResult<2> result = solve_run(
      reference.name, levels(3, reference.level, {"Discretization/Patches=" + reference.patches}));
    checks.that("certified", result.verdict.equations_hold());
    for (const auto &[column, expected] :
         {std::pair("active", double(reference.active)),
          std::pair("contact_force_n", reference.contact_force),
          std::pair("energy", reference.energy), std::pair("max_pressure", reference.max_pressure)})
      checks.near(column, last(result, column) / expected, 1., 2e-10);
  }
}

/** A1 on level 4. */
void compare_errors(Checks &checks) {
  const StudyResult<2> result = solve_run("a1", {"Discretization/Finest level=4"});
  for (const auto &[column, expected] :
       {std::pair("u_h1", 0.047825368086956775), std::pair("u_l2", 0.0014764668602787931),
        std::pair("u_superclose_h1", 0.020410892243168884),
        std::pair("u_post_h1", 0.02148986853828931), std::pair("p_l2", 0.21496795974362748)})
    checks.near(column, last(result, column) / expected, 1., 1e-9);
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv, {compare, compare_errors});
}
