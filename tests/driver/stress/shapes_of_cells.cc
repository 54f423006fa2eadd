// SPDX-License-Identifier: LGPL-2.1-or-later
// Flat and tall cells, distorted cells, a single cell.

#include "stress.h"

using namespace Signorini;

namespace {
void aspect(Checks &checks) {
  StabilityTable table("aspect_ratio", "height / width of cells");
  for (const std::string &height : checks.rows<std::string>(
         {"1e-4", "1e-3", "1e-2", "0.1", "1", "10", "100", "1e3", "1e4"}, 3)) {
    Family family;
    family.height = height;
    const Measured measured = measure(text_of(family), levels(3, 4));
    table.add(height, measured);
    checks.that("aspect ratio " + height + ": certified, or rounding is named",
                measured.is_certified() || measured.names("rounding"));
  }
}

void distortion(Checks &checks) {
  StabilityTable table("distortion", "distortion of the coarsest level");
  for (const std::string &share :
       checks.rows<std::string>({"0", "0.1", "0.2", "0.3", "0.4", "0.45"}, 2)) {
    checks.about("distortion " + share);
    const Measured measured = measure(text_of({}), levels(2, 5, {"Geometry/Distortion=" + share}));
    table.add(share, measured);
    checks.that("certified", measured.is_certified());
    check_orders(checks, measured.study.levels, {{"u_h1", 0.95, 1.2}, {"p_l2", 0.85, 1.1}});
  }
}

/** A cantilever of 100 x 1 under a load at its end, not touching. */
void bending(Checks &checks) {
  const std::string cantilever = "subsection Boundary\nset Clamped = left\nset Contact = bottom\n"
                                 "set Traction = right: 0; -1e-6\nend\n" +
                                 entry("Contact", "Gap", "10") +
                                 entry("Geometry", "Upper right", "100, 1");
  checks.that("bending of long cells: not certified",
              measure(cantilever, levels(2, 4)).names("long cells are too stiff"));
  const Measured square = measure(cantilever, levels(1, 3, {"Geometry/Cells=100, 1"}));
  checks.that("bending of square cells: certified", square.is_certified());
  // Beam in plane strain, E' = E/(1 - nu^2), I = 1/12: the energy is -F^2 L^3/(6 E' I), and shear
  // and the square cells' own stiffness change it by less than five per cent.
  checks.near("bending of square cells: the beam's energy",
              last(square.study, "energy") / (-1e-12 * 1e6 * 2. * (1. - 0.09)), 1., 0.05);
}

void smallest(Checks &checks) {
  StabilityTable table("smallest", "smallest meshes");
  const std::string block = "subsection Boundary\nset Clamped = top\nset Contact = bottom\nend\n" +
                            entry("Contact", "Gap", "-0.01");
  const Measured one_cell = measure(block, levels(0, 0));
  table.add("one cell, one patch", one_cell);
  checks.that("one cell: certified", one_cell.is_certified());
  // Plane strain, E = 1, nu = 0.3, sides free: the bottom moves up by 0.01 as a whole, P = -F/C.
  checks.that("one cell: it presses", one_cell.finest().contact.max_pressure > 0.01);
  const Measured one_patch = measure(block, {"Discretization/Patch ratio=100"});
  table.add("one patch, 64 x 64 cells", one_patch);
  checks.that("one patch: certified", one_patch.is_certified());
  checks.that("one patch: it is one", one_patch.finest().sizes.multipliers == 1);
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv, {aspect, distortion, bending, smallest});
}
