// SPDX-License-Identifier: LGPL-2.1-or-later
// Penetration that the nodes of the multipliers cannot see.

#include <signorini/base/errors.h>
#include <signorini/error_control/hp/contact_misfit.h>

#include <cmath>

#include "graded.h"
#include "tests.h"

using namespace Signorini;
using dealii::Point;

namespace {
/** Four faces of degree two between 0 and 1: one multiplier in the middle of each, that of one face
 * may press. @return the x-coordinates of the middles of the cells that are found. */
std::vector<double> found(const std::string &gap, const unsigned int pressing = 4,
                          const double bend = 0.) {
  const GradedLevel level("Boundary/Clamped = top\nBoundary/Contact = bottom\nContact/Gap = " + gap,
                          uniform_plan(2, 2));
  const Displacement U = nodal_values(
    level.space(), [bend](const Point<2> &x) { return Point<2>(0., -bend * x[0] * x[0]); });
  Pressure P(level.multipliers().n_multipliers());
  if (pressing < P.size())
    P[pressing] = -1.;
  std::vector<double> middles;
  for (const unsigned int index : missed_contact_cells(level.body(U, P)))
    for (const auto &cell : level.mesh().triangulation().active_cell_iterators())
      if (cell->active_cell_index() == index && cell->at_boundary())
        middles.push_back(cell->center()[0]);
  return middles;
}

/** A foundation with a bump at 5/16, a quarter of the second face. Nothing presses: the multipliers
 * have seen nothing. Where the face or one next to it presses, the contact is known. */
void bumps(Checks &checks) {
  const std::string bump = "0.1 - 0.15*exp(-((x - 0.3125)/0.03)^2)";
  checks.near("a bump between the nodes", found(bump), {0.375}, 1e-12);
  checks.near("no bump", found("0.1"), {}, 1e-12);
  // 0.3125 + 1/256 is in the middle between two of 33 points of the face.
  checks.near("a bump that is narrower than the samples of a face are apart",
              found("0.1 - 0.05*max(0, 1 - abs(x - 0.31640625)) - "
                    "0.06*max(0, 1 - 500*abs(x - 0.31640625))"),
              {0.375}, 1e-12);
  checks.near("two bumps", found(bump + " - 0.2*exp(-((x - 0.9375)/0.03)^2)"), {0.375, 0.875},
              1e-12);
  for (const unsigned int k : {0U, 1U, 2U})
    checks.near("a bump beside a pressing face", found(bump, k), {}, 1e-12);
  checks.near("a bump away from a pressing face", found(bump, 3), {0.375}, 1e-12);
}

/** Where something presses far away, penetrations below a thousandth of the largest |u_n - g| are
 * what polynomials leave next to contact. */
void depths(Checks &checks) {
  const auto gap = [](const std::string &height) {
    return "0.1 - " + height + "*exp(-((x - 0.0625)/0.03)^2)";
  };
  checks.near("deep, pressed elsewhere", found(gap("0.1005"), 3), {0.125}, 1e-12);
  checks.near("shallow, pressed elsewhere", found(gap("0.10005"), 3), {}, 1e-12);
  checks.near("shallow, nothing presses", found(gap("0.10005")), {0.125}, 1e-12);
  // The displacement counts, too: u_n = 0.2 x².
  checks.near("a displacement into the foundation", found("0.19", 4, 0.2), {0.875}, 1e-12);
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv, {bumps, depths});
}
