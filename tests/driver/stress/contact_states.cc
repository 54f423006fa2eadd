// SPDX-License-Identifier: LGPL-2.1-or-later
// Gaps of every size, and contact that is full, empty, a point, without pressure, or ends where the
// body is held.

#include "stress.h"

using namespace Signorini;

namespace {
/** The unit square, E = 1, held or pressed at the top. */
std::string block(const std::string &boundary, const std::string &gap) {
  return "subsection Boundary\nset Contact = bottom\n" + boundary + "end\n" +
         entry("Contact", "Gap", gap);
}

const std::string clamped = "set Clamped = top\n";

std::string pressed_by(const std::string &depth) {
  return "set Displacement = top: 0; -" + depth + "\n";
}

struct State {
  std::string name, boundary, gap;
  /** Patches of 16 that press on level 5. */
  unsigned int fewest, most;
};

const std::vector<State> states = {
  {"full contact, gap -1e-12", clamped, "-1e-12", 16, 16},
  {"full contact, gap -0.01", clamped, "-0.01", 16, 16},
  {"full contact, gap -1e12", clamped, "-1e12", 16, 16},
  {"pressed, gap 1e-12", pressed_by("0.01"), "1e-12", 16, 16},
  {"no contact, gap 1e-12", clamped, "1e-12", 0, 0},
  {"no contact, gap 1e12", clamped, "1e12", 0, 0},
  {"touching without pressure", clamped, "0", 0, 0},
  {"a point at a corner", pressed_by("0.01"), "0.2*x", 1, 1},
  {"a point inside", pressed_by("0.01"), "0.2*abs(x-0.5)", 2, 2},
  {"lowered without touching", pressed_by("0.01"), "1e3*x+0.011", 0, 0},
  {"lowered until it touches", pressed_by("0.01"), "0.01", 0, 16},
  {"a gap of 1e12 beside contact", pressed_by("0.01"), "x < 0.5 ? 0 : 1e12", 8, 8},
  {"up to both corners", pressed_by("0.01"), "0", 16, 16},
  {"up to clamped ends", "set Clamped = left right\nset Displacement = top: 0; -0.01*x*(1-x)\n",
   "0", 8, 16},
  {"penetration at one end", clamped, "0.1*x-0.05", 4, 12}};

void test_states(Checks &checks) {
  StabilityTable table("contact_states", "gap and contact");
  for (const State &state : states) {
    checks.about(state.name);
    const Measured measured =
      measure(block(state.boundary, state.gap), levels(2, 5, {"Output/Inf-sup constant=true"}));
    table.add(state.name, measured);
    checks.that("certified", measured.is_certified());
    checks.between("patches that press", measured.finest().contact.active, state.fewest,
                   state.most);
    if (measured.condition > 0.)
      checks.between("active set from scratch", measured.active_set, 1., 12.);
  }
}

/** The problem is piecewise linear: depth d instead of 0.01 gives d/0.01 times the answer. */
void test_proportions(Checks &checks) {
  const auto force = [](const std::string &depth, const std::string &gap) {
    return last(solve(block(pressed_by(depth), gap), levels(2, 4)), "contact_force_n");
  };
  const double reference = force("0.01", "0.02*x^2");
  checks.near("all data times 1e-10", force("1e-12", "2e-12*x^2") / reference, 1e-10, 1e-20);
  checks.near("all data times 1e14", force("1e12", "2e12*x^2") / reference, 1e14, 1e4);
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv, {test_states, test_proportions});
}
