// SPDX-License-Identifier: LGPL-2.1-or-later
// Penetration that the nodes of the multipliers cannot see.

#include <signorini/base/errors.h>
#include <signorini/error_control/hp/indicators.h>

#include <cmath>

#include "graded.h"
#include "tests.h"

using namespace Signorini;
using dealii::Point;

namespace
{
/** Four faces of degree two between 0 and 1: one multiplier in the middle of each. */
struct Level : public GradedLevel
{
  explicit Level(const std::string &gap)
    : GradedLevel("subsection Boundary\nset Clamped = top\nset Contact = bottom\nend\n" +
                    entry("Contact", "Gap", gap),
                  uniform_plan(2, 2))
    , U(space().zero())
    , P(multipliers().n_multipliers())
  {
  }
  /** The x-coordinates of the middles of the cells that are found. */
  std::vector<double> found() const
  {
    std::vector<double> middles;
    for (const unsigned int index : missed_contact_cells(space(), multipliers(), U, P))
      for (const auto &cell : mesh().triangulation().active_cell_iterators())
        if (cell->active_cell_index() == index && cell->at_boundary())
          middles.push_back(cell->center()[0]);
    return middles;
  }

  Displacement U;
  Pressure P;
};

bool is(const std::vector<double> &found, const std::vector<double> &expected)
{
  bool same = found.size() == expected.size();
  for (std::size_t i = 0; i < found.size() && same; ++i)
    same = std::abs(found[i] - expected[i]) < 1e-12;
  return same;
}

/** A foundation with a bump at 5/16, a quarter of the second face. Nothing presses: the multipliers
 * have seen nothing. */
void bumps(Checks &checks)
{
  const std::string bump = "0.1 - 0.15*exp(-((x - 0.3125)/0.03)^2)";
  Level level(bump);
  checks.that("a bump between the nodes", is(level.found(), {0.375}));
  checks.that("no bump", is(Level("0.1").found(), {}));
  // 0.3125 + 1/256 is in the middle between two of 33 points of the face.
  checks.that(
    "a bump that is narrower than the samples of a face are apart",
    is(
      Level("0.1 - 0.05*max(0, 1 - abs(x - 0.31640625)) - 0.06*max(0, 1 - 500*abs(x - 0.31640625))")
        .found(),
      {0.375}));
  checks.that("two bumps",
              is(Level(bump + " - 0.2*exp(-((x - 0.9375)/0.03)^2)").found(), {0.375, 0.875}));
  // Where the face or one next to it presses, the contact is known.
  for (unsigned int k = 0; k < 4; ++k)
  {
    Level pressed(bump);
    pressed.P[k] = -1.;
    checks.that("a bump, face " + std::to_string(k) + " presses",
                is(pressed.found(), k < 3 ? std::vector<double>() : std::vector<double>({0.375})));
  }
}

/** Where something presses far away, penetrations below a thousandth of the largest |u_n - g| are
 * what polynomials leave next to contact. */
void depths(Checks &checks)
{
  for (const auto &[height, is_found] :
       std::vector<std::pair<std::string, bool>>{{"0.1005", true}, {"0.10005", false}})
  {
    const std::string gap = "0.1 - " + height + "*exp(-((x - 0.0625)/0.03)^2)";
    Level pressed(gap);
    pressed.P[3] = -1.;
    checks.that(
      "depth " + height + ", pressed elsewhere",
      is(pressed.found(), is_found ? std::vector<double>({0.125}) : std::vector<double>()));
    checks.that("depth " + height + ", nothing presses", is(Level(gap).found(), {0.125}));
  }
}

/** The displacement counts, too: u_n = 0.2 x² against the gap 0.19. */
void displacements(Checks &checks)
{
  Level level("0.19");
  level.U =
    nodal_values(level.space(), [](const Point<2> &x) { return Point<2>(0., -0.2 * x[0] * x[0]); });
  checks.that("a displacement into the foundation", is(level.found(), {0.875}));
}
} // namespace

int main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  dealii::deal_II_exceptions::disable_abort_on_exception();
  Checks checks;
  bumps(checks);
  depths(checks);
  displacements(checks);
  return checks.exit_code();
}
