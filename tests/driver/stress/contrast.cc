// SPDX-License-Identifier: LGPL-2.1-or-later
// Moduli of very different size: smooth along and across the contact side, and in two layers.

#include <signorini/base/text.h>

#include <algorithm>

#include "stress.h"

using namespace Signorini;

namespace {
void smooth(Checks &checks, StabilityTable &table) {
  for (const bool along : {true, false})
    for (const std::string &exponent : checks.rows<std::string>({"2", "4", "6", "8", "-8"}, 2)) {
      Family family;
      (along ? family.contrast_x : family.contrast_y) = exponent;
      const Measured measured = measure(text_of(family), levels(3, 5));
      const std::string name = std::string(along ? "along" : "across") + ", 1e" + exponent;
      table.add(name, measured);
      checks.that(name + ": certified", measured.is_certified());
    }
}

/** nu = 0, E = M for y < 1/4 and 1 above, pressed down by 0.01: p = -0.01/(1/(4 M) + 3/4), u linear
 * in each layer. */
void layers(Checks &checks, StabilityTable &table) {
  for (const double modulus : checks.rows<double>({1e-8, 1e-4, 1e2, 1e4, 1e6, 1e8, 1e10}, 2)) {
    const std::string M = number_text(modulus);
    const Measured measured = measure(
      "", levels(3, 5,
                 {"Material/Young's modulus=y < 0.25 ? " + M + " : 1", "Material/Poisson's ratio=0",
                  "Boundary/Contact=bottom", "Boundary/Displacement=top: 0; -0.01",
                  "Exact solution/Pressure=-0.01/(0.25/" + M + " + 0.75)"}));
    table.add("layer of " + M, measured);
    checks.about("layer of " + M);
    checks.that("certified, or rounding is named",
                measured.is_certified() || measured.names("rounding"));
    if (!measured.is_certified())
      continue;
    const double exact = 0.01 / (0.25 / modulus + 0.75);
    // Forces in a stiff layer are rounded by the unit roundoff times the contrast, and the
    // processor decides in which direction.
    const double of_contrast = 1e-14 * modulus;
    checks.near("the pressure, as far as rounding lets it", last(measured.study, "p_l2") / exact,
                0., std::max({1e-10, of_contrast, 10. * measured.finest().linear.rounding_error}));
  }
}

void test(Checks &checks) {
  StabilityTable table("contrast", "contrast of E");
  smooth(checks, table);
  layers(checks, table);
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv, {test});
}
