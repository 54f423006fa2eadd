// SPDX-License-Identifier: LGPL-2.1-or-later
// u_n - g where the body presses, against its integral by hand.

#include <signorini/error_control/hp/contact_misfit.h>

#include <cmath>

#include "graded.h"
#include "tests.h"

using namespace Signorini;

namespace {
/** Four faces of degree two between 0 and 1, modulus one; u_h = 0 and g = x. */
void distances(Checks &checks) {
  const GradedLevel level("subsection Boundary\nset Clamped = top\nset Contact = bottom\nend\n"
                          "Contact/Gap = x\n"
                          "Material/Poisson's ratio = 0\n",
                          uniform_plan(2, 2));
  const Displacement U = level.space().zero();
  Pressure P(level.multipliers().n_multipliers());
  P.add(-1.);
  const unsigned int open = 2;
  P[open] = 0.;
  std::vector<CellIndicator> indicators(level.mesh().triangulation().n_active_cells(), {0.5, 0.1});
  add_contact_misfit(level.body(U, P), Component::normal, indicators);
  double largest_difference = 0.;
  for (const auto &cell : level.mesh().triangulation().active_cell_iterators()) {
    double expected = 0.25;
    const double from = cell->vertex(0)[0], to = cell->vertex(1)[0];
    const bool at_contact = cell->vertex(0)[1] == 0.;
    if (at_contact && std::lround(4. * from) != open)
      // modulus pi/2 p/h times the integral of x^2.
      expected += 0.5 * M_PI * 2. / 0.25 * (to * to * to - from * from * from) / 3.;
    const double error = indicators[cell->active_cell_index()].error;
    largest_difference = std::max(largest_difference, std::abs(error * error - expected));
  }
  checks.near("where all multipliers press, and nowhere else", largest_difference, 0., 1e-13);
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv, {distances});
}
