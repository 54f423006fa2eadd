// SPDX-License-Identifier: LGPL-2.1-or-later
// The contact part of the bound: its order, contact that is missed, the error of the contact force,
// and where there is no bound, that is said.

#include <cmath>

#include "bounded.h"
#include "error_control/hp/graded.h"
#include "study_helpers.h"
#include "tests.h"

using namespace Signorini;

namespace {
void orders(Checks &checks) {
  for (const auto &[name, low, high] :
       {std::tuple("A1", 1.5, 2.5), std::tuple("A3", 1.5, 2.5), std::tuple("B1", 1., 3.5)}) {
    std::vector<double> x, y;
    for (unsigned int level = 3; level <= 6; ++level) {
      x.push_back(-std::log(2.) * level);
      y.push_back(std::log(Bounded(named_scene(name), level).bound.contact.value()));
    }
    checks.between(std::string(name) + ": order of the contact part", fit(x, y).slope, low, high);
  }
}

/** The tip of an indenter between the nodes of coarse meshes, as far as its mean over patches is an
 * opening. */
void missed_contact(Checks &checks) {
  const std::string missed = "Geometry/Lower left = -1, 0\nGeometry/Upper right = 1, 2\n"
                             "Boundary/Clamped = top\nBoundary/Contact = bottom\n"
                             "Contact/Gap = (x-0.0313)^2/(2*0.08)-0.003\n";
  for (const unsigned int number : {3U, 4U, 5U}) {
    const Bounded level(missed, number);
    checks.about("missed contact, level " + std::to_string(number));
    checks.that("P = 0", level.solution.contact.P.normal().linfty_norm() == 0.);
    checks.near("penetration", *level.bound.penetration, 0.003, 1e-4);
    checks.that("place", level.bound.place_of_penetration.find("bottom at (0.03") == 0);
  }
}

void held_corners(Checks &checks) {
  const std::string held = "Boundary/Clamped = left\nBoundary/Contact = bottom\n"
                           "Boundary/Traction = top: 0; -0.1\nContact/Gap = ",
                    pushed = "Boundary/Displacement = right: 0; -0.02\nBoundary/Contact = bottom\n"
                             "Boundary/Clamped = left\nContact/Gap = ";
  for (const auto &[name, text] :
       {std::pair("a gap that closes a clamp", held + "-0.01+0.1*x"),
        std::pair("a prescribed displacement into the foundation", pushed + "0.01")})
    checks.throws<InputError>(name, "no displacement of finite energy",
                              [&text = text]() { Bounded(text, 3); });
  for (const auto &[name, text] : {std::pair("a foundation that touches a clamp", held + "0.1*x"),
                                   std::pair("a steep gap at a clamp", held + "-0.01*sqrt(x)"),
                                   std::pair("curved sides", named_scene("E2"))}) {
    const ErrorBound bound = Bounded(text, 3).bound;
    checks.that(name, bound.missing.empty() && bound.absolute.has_value());
  }
}

/** A1: int p = -10 xi^4/4; B1: -2/3 xi^{3/2}, xi = 1/sqrt(2). */
void contact_force(Checks &checks) {
  for (const auto &[name, force] :
       {std::pair("A1", 0.625), std::pair("B1", 2. / 3. * std::pow(0.5, 0.75))}) {
    const Bounded level(named_scene(name), 5);
    checks.between(std::string(name) + ": force",
                   std::abs(level.solution.record.contact.normal_force - force), 0.,
                   *level.bound.force_error);
  }
}

/** The lift does not depend on who solves with A; V-cycles find it nearly, though cells are so long
 * that they take many steps. */
void solvers(Checks &checks) {
  const auto bound = [](const std::string &solver) {
    return *Bounded(
              "Geometry/Upper right = 8, 1\nGeometry/Cells = 8, 1\nBoundary/Contact = bottom\n"
              "Boundary/Rollers = left\nBoundary/Displacement = right: 0; 0\n"
              "Boundary/Traction = top: 0; -0.02\nContact/Gap = 0.01*(x-3)^2\n"
              "Discretization/Patches = 16\nSolver/Linear solver = " +
                solver,
              4)
              .bound.absolute;
  };
  const double by_factors = bound("condensed");
  for (const auto &[solver, tolerance] :
       {std::pair("amesos_mumps", 1e-5), std::pair("multigrid", 0.04)})
    checks.near(std::string("beam, ") + solver, bound(solver) / by_factors, 1., tolerance);
}
/** On graded meshes the roots of rounding along contact faces do not count. */
void rounding(Checks &checks) {
  const StudyResult<2> result =
    solve(named_scene("A1"), {"Discretization/Strategy=hp", "Discretization/Coarsest level=2",
                              "Discretization/Target error=2e-10"});
  checks.that("a target of 2e-10 is reached", result.verdict.outcome == Outcome::certified);
  checks.between("contact part", last(result, "bound_contact"), 0., 1e-10);
}

/** Rounding of the force of a plate weighs more than cells that are 1e-9 of it. */
void plate_and_small_cells(Checks &checks) {
  MeshPlan plan = uniform_plan(1, 4);
  plan.singularities = {corner({-1., 1.}, 30.), corner({1., 1.}, 30.)};
  const GradedLevel level("Geometry/Lower left = -1, 0\nGeometry/Cells = 2, 1\n"
                          "Boundary/Plates = top: 0, -1\nLoad/Plate force = top: 0.01\n"
                          "Boundary/Contact = bottom\nContact/Gap = 0.02*x^2\n"
                          "Discretization/Target error = 1e-9\n",
                          plan);
  checks.between("plate and small cells", level.solve().record.bound->relative.value_or(1.), 0.,
                 0.05);
}

/** A line through corners of cells crosses no edge, and the modulus jumps inside nevertheless. */
void moduli_on_diagonals(Checks &checks) {
  const auto contact_part = [](const std::string &slope) {
    return *Bounded("Boundary/Clamped = top\nBoundary/Contact = bottom\n"
                    "Contact/Gap = 0.02*(x-0.5)^2\nLoad/Body force = 0; -0.05\n"
                    "Material/Young's modulus = y < " +
                      slope + "*x ? 10 : 1",
                    3)
              .bound.contact;
  };
  checks.near("a jump along diagonals", contact_part("1") / contact_part("1.0000001"), 1., 1e-3);
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv,
                   {orders, missed_contact, held_corners, contact_force, solvers, rounding,
                    plate_and_small_cells, moduli_on_diagonals});
}
