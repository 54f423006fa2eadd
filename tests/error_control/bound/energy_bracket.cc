// SPDX-License-Identifier: LGPL-2.1-or-later
// A bar of length and modulus one that a rigid plate shortens by 1/10: u = -x/10 from the clamp,
// J(u) = 1/200, and every number of the bracket is known. Then scenes whose brackets of all levels
// hold the same number, and bounds that depend on nothing but u_h, p_H and the data.

#include <signorini/error_control/stress/equilibrated_stress.h>

#include <algorithm>

#include "study_helpers.h"
#include "tests.h"

using namespace Signorini;

namespace
{
std::string described(const std::string &text)
{
  return "subsection Scene\nset Name = described\nend\n" + text;
}
std::string boundary(const std::string &text)
{
  return "subsection Boundary\n" + text + "end\n";
}
std::string gap(const std::string &g)
{
  return "subsection Contact\nset Gap = " + g + "\nend\n";
}

/** The bounds of levels 1 to @p finest. */
std::vector<ErrorBound> bounds(const std::string &text, const unsigned int finest)
{
  std::vector<std::string> overrides = levels(1, finest);
  overrides.insert(overrides.end(),
                   {"Discretization/Target error=1e-9", "Output/Inf-sup constant=false"});
  std::vector<ErrorBound> result;
  for (const LevelRecord &level : solve(described(text), overrides).levels)
    result.push_back(*level.bound);
  return result;
}

/** There are brackets, and one number lies in all of them. */
void brackets_meet(Checks &checks, const std::string &name, const std::string &text)
{
  double lower = -1e300, upper = 1e300;
  for (const ErrorBound &bound : bounds(text, 4))
  {
    lower = std::max(lower, bound.energy_lower.value_or(1e300));
    upper = std::min(upper, bound.energy_upper.value_or(-1e300));
  }
  checks.that(name + ": brackets meet", lower <= upper);
}

void test_bar(Checks &checks)
{
  // A constant stress tau < 0 is in equilibrium: -J*(tau) = -tau²/2 - tau g' with the gap -1/10.
  const double exact = 0.1 * 0.1 / 2.;
  for (const double tau : {-0.08, -0.1, -0.13})
  {
    const double minus_dual = -tau * tau / 2. - tau * 0.1;
    // u_h = u: no contact term, no lift, and the whole error is that of tau.
    const double eta = std::abs(tau + 0.1);
    const Bracket bracket = energy_bracket({-minus_dual, -minus_dual}, eta, 0., 0.);
    const std::string name = "tau = " + std::to_string(tau);
    checks.between(name + ": below", exact - bracket.lower, -1e-15, 1.);
    checks.near(name + ": above, sharp", bracket.upper, exact, 1e-15);
    checks.near(name + ": stress", stress_error_bound(eta, 0., 0.), eta, 1e-15);
    // z = x has the energy one, and the force is -1/10.
    checks.near(name + ": force", contact_force_bound(eta, 1.), std::abs(-0.1 - tau), 1e-15);
  }
  // u_h = -0.12 x/1, p_H = -0.12, tau = -0.12: d = -0.02, nothing to lift, 2 T = 2 * 0.12 * 0.02.
  const double tau = -0.12, contact_term = tau * -0.02;
  const double dual = tau * tau / 2. + tau * 0.1;
  const Bracket bracket = energy_bracket({dual, dual}, 0., 0., contact_term);
  checks.between("open: below", exact - bracket.lower, 0., 1.);
  checks.between("open: above", bracket.upper - exact, 0., 1.);
  checks.between("open: stress", stress_error_bound(0., 0., contact_term), 0.02, 1.);
}

/** p_H jumps inside of faces where g and u_h are linear. */
void test_patch_ends(Checks &checks)
{
  const std::string patches = "subsection Discretization\nset Patches = 3\nend\n";
  brackets_meet(checks,
                "inclined plane",
                boundary("set Contact = bottom\nset Displacement = top: 0; -0.05 - 0.02*x\n") +
                  gap("0.1*x - 0.03") + patches);
  brackets_meet(checks,
                "plate that turns",
                boundary("set Contact = bottom\nset Plates = top: -0.1, 1 turning\n") +
                  "subsection Load\nset Plate force = top: -0.05\nend\n" + gap("0.1*x") + patches);
}

/** No edge that may carry tractions stops the block along y: translations along y change
 * nothing. */
void test_best_stress(Checks &checks)
{
  const std::string block = "subsection Geometry\nset Upper right = 2, 1\nend\n" +
                            boundary("set Rollers = left\nset Contact = bottom\n"
                                     "set Traction = top: 0; 0.1*(x-1)-0.001\n");
  const ErrorBound still = bounds(block + gap("0"), 1).front();
  for (const char *g : {"0.001", "1"})
  {
    const ErrorBound moved = bounds(block + gap(g), 1).front();
    checks.near(std::string("block, gap ") + g, *moved.mesh / *still.mesh, 1., 1e-8);
  }
}

/** Pins hold the body while A is solved; nothing holds its contact nodes. */
void test_pins(Checks &checks)
{
  brackets_meet(checks,
                "in a corner",
                boundary("set Contact = bottom left\n") +
                  "subsection Load\nset Body force = -0.02; -0.05\nend\n" +
                  gap("bottom: 0.001*x | left: 0.002*y"));
  brackets_meet(checks,
                "in a box",
                boundary("set Contact = bottom left right top\n") +
                  "subsection Load\nset Body force = 0.02*x; -0.05\nend\n" +
                  gap("bottom: 0.001*x | left: -0.002 | right: -0.003 | top: -0.01"));
}

/** With few contact nodes the lift does not depend on who solves with A; the layer alone would give
 * 1.47 times the bound. */
void test_solvers(Checks &checks)
{
  const std::string beam =
    "subsection Geometry\nset Upper right = 8, 1\nset Cells = 8, 1\nend\n" +
    boundary("set Contact = bottom\nset Rollers = left\nset Displacement = right: 0; 0\n"
             "set Traction = top: 0; -0.02\n") +
    gap("0.01*(x-3)^2") + "subsection Discretization\nset Patches = 16\nend\n";
  const auto bound = [&](const std::string &solver) {
    std::vector<std::string> overrides = levels(4, 4);
    overrides.push_back("Solver/Linear solver=" + solver);
    return *solve(described(beam), overrides).levels.back().bound->absolute;
  };
  const double by_factors = bound("condensed");
  for (const char *solver : {"amesos_mumps", "multigrid"})
    checks.near(std::string("beam, ") + solver, bound(solver) / by_factors, 1., 1e-5);
}
} // namespace

int main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  Checks checks;
  test_bar(checks);
  test_patch_ends(checks);
  test_best_stress(checks);
  test_pins(checks);
  test_solvers(checks);
  return checks.exit_code();
}
