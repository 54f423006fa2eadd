// SPDX-License-Identifier: LGPL-2.1-or-later
// Where a pressure with given signs begins and ends.

#include <signorini/postprocessing/quantities/contact_zones.h>

#include <cmath>

#include "graded.h"
#include "tests.h"

using namespace Signorini;
using dealii::Point;

namespace {
/** P = -1 at the nodes for which @p presses (side, s). */
Pressure pressure(const MultiplierSpace<2> &space,
                  const std::function<bool(unsigned int, double)> &presses) {
  Pressure P(space.n_multipliers());
  for (unsigned int k = 0; k < P.size(); ++k)
    if (presses(space.surface().patches()[space.patch_of(k)].side, space.node(k)[0]))
      P[k] = -1.;
  return P;
}

void check(Checks &checks, const std::string &name, const MultiplierSpace<2> &space,
           const Pressure &P, const std::vector<ZoneBracket> &expected) {
  std::vector<double> found, wanted;
  for (const ZoneBracket &bracket : zone_brackets(space, Multiplier(P).states()))
    found.insert(found.end(), {double(bracket.side), bracket.from, bracket.to});
  for (const ZoneBracket &bracket : expected)
    wanted.insert(wanted.end(), {double(bracket.side), bracket.from, bracket.to});
  checks.near(name, found, wanted, 1e-13);
}

/** Four faces with two nodes each, a = (3 - 3^{1/2})/24 away from the ends: a, 1/4 - a, 1/4 + a,
 * ... The sides are left (0) and bottom (2). */
void two_sides(Checks &checks) {
  const GradedLevel level(
    "subsection Boundary\nset Clamped = top\nset Contact = left bottom\nend\n", uniform_plan(2, 3));
  const MultiplierSpace<2> &space = level.multipliers();
  const double a = (3. - std::sqrt(3.)) / 24.;
  checks.near("the first node", space.node(0)[0], a, 1e-15);
  const auto on = [&](const unsigned int side, const double from, const double to) {
    return pressure(space, [=](const unsigned int other, const double s) {
      return other == side && s > from && s < to;
    });
  };
  check(checks, "nothing presses", space, on(0, 2., 3.), {});
  check(checks, "a whole side", space, on(2, -1., 2.), {});
  check(checks, "inside", space, on(2, 0.25, 0.75),
        {{2, 0.25 - a, 0.25 + a}, {2, 0.75 - a, 0.75 + a}});
  check(checks, "up to the end of the side", space, on(0, 0.5, 2.), {{0, 0.5 - a, 0.5 + a}});
  // The last two nodes of the first side and the first two of the second.
  auto both = on(0, 0.75, 1.);
  both.add(1., on(2, 0., 0.25));
  check(checks, "two sides", space, both, {{0, 0.75 - a, 0.75 + a}, {2, 0.25 - a, 0.25 + a}});
  // Two gaps in contact: one node that does not press, and two.
  auto gaps = on(2, 0., 1.);
  gaps[space.first_of(4 + 1)] = 0.;
  gaps[space.first_of(4 + 2) + 1] = gaps[space.first_of(4 + 3)] = 0.;
  check(checks, "gaps", space, gaps,
        {{2, 0.25 - a, 0.5 - a}, {2, 0.5 + a, 0.75 - a}, {2, 0.75 + a, 1. - a}});
  // Slip, a node that sticks, and open: one bracket; slip both ways: another.
  std::vector<NodeState> states(space.n_multipliers(), {true, State::lower});
  const unsigned int first = space.first_of(4);
  states[first + 2] = {true, State::inside};
  std::fill(states.begin() + first + 3, states.begin() + first + 6, NodeState());
  std::fill(states.begin() + first + 6, states.end(), NodeState{true, State::upper});
  checks.that("three states", [&]() {
    const std::vector<ZoneBracket> found = zone_brackets(space, states);
    return found.size() == 2 && std::abs(found[0].from - 0.25 + a) < 1e-13 &&
           std::abs(found[0].to - 0.5 + a) < 1e-13 && std::abs(found[1].from - 0.75 + a) < 1e-13 &&
           std::abs(found[1].to - 0.75 - a) < 1e-13;
  }());
  // A zero up to the tolerance of a solver does not press.
  auto rounding = on(2, 0.25, 0.75);
  for (double &p : rounding)
    p = p == 0. ? -1e-14 : p;
  check(checks, "rounding", space, rounding, {{2, 0.25 - a, 0.25 + a}, {2, 0.75 - a, 0.75 + a}});
}

/** The outer circle of scene E1 has the radius 2 and 16 faces of one node each: s_i = (i + 1/2) h,
 * h = pi/4. */
void closed_side(Checks &checks) {
  const GradedLevel level("Scene/Name = E1\n", uniform_plan(1, 2));
  const MultiplierSpace<2> &space = level.multipliers();
  const double h = dealii::numbers::PI / 4., length = 16. * h;
  const unsigned int side = space.surface().patches()[0].side;
  checks.near("closed: nodes", space.node(3)[0], 3.5 * h, 1e-12);
  const auto on = [&](const double from, const double to) {
    return pressure(space, [=](unsigned int, const double s) {
      return (s > from && s < to) || (s + length > from && s + length < to);
    });
  };
  check(checks, "closed: all", space, on(0., length), {});
  check(checks, "closed: inside", space, on(3. * h, 6. * h),
        {{side, 2.5 * h, 3.5 * h}, {side, 5.5 * h, 6.5 * h}});
  check(checks, "closed: around the start", space, on(14. * h, 18. * h),
        {{side, 1.5 * h, 2.5 * h}, {side, 13.5 * h, 14.5 * h}});
  check(checks, "closed: the first node", space, on(0., h), {{side, 15.5 * h, 17.5 * h}});
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv, {two_sides, closed_side});
}
