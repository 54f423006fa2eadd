// SPDX-License-Identifier: LGPL-2.1-or-later
// All contact solvers and linear solvers give the solution of the mixed problem (5), in every scene
// of the catalogue and in described ones; V-cycles need no more of them on finer levels. Every
// sweep of projected SOR lowers the dual objective.

#include <signorini/discretization/space/internal_forces.h>
#include <signorini/results/verdict/judge.h>
#include <signorini/solvers/contact/projected_methods.h>
#include <signorini/verification/catalogue/catalogue.h>

#include "one_level.h"
#include "study_helpers.h"
#include "tests.h"

using namespace Signorini;
using Vector = dealii::Vector<double>;

namespace {
using Settings = std::vector<std::string>;

Settings operator+(Settings a, const Settings &b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

const Settings held = {"Boundary/Clamped=top", "Boundary/Contact=bottom",
                       "Load/Body force=0.05; -0.2"};
const Settings block = held + Settings{"Contact/Gap=2*(x-0.4)^2-0.02"};

const std::vector<Settings> described = {
  block,
  // Nothing touches.
  held + Settings{"Contact/Gap=1"},
  block + Settings{"Material/Young's modulus=1+9*y"},
  // Patches aligned with nothing.
  block + Settings{"Discretization/Patches=11"},
  {"Boundary/Clamped=top", "Boundary/Contact=bottom left", "Load/Body force=-0.4; -0.5*x",
   "Contact/Gap=bottom: 0.3*x^2 | left: 0.1*y"},
  {"Boundary/Clamped=top", "Boundary/Contact=bottom, right", "Boundary/Traction=left: 0.3; 0",
   "Load/Body force=0.05; -0.2", "Contact/Gap=0.02"},
  {"Boundary/Displacement=top: 0.01*x; -0.05", "Boundary/Rollers=left", "Boundary/Contact=bottom",
   "Contact/Gap=0.01+0.06*(x-0.8)^2"},
  // The corner of the contact side is moved.
  {"Boundary/Displacement=left: 0.01; -0.02*(1-y)", "Boundary/Contact=bottom",
   "Boundary/Traction=top: 0; -0.1", "Contact/Gap=0.02+0.3*x^2"},
  {"Geometry/Shape=polygon", "Geometry/Vertices=0,0; 2,0; 2.5,1; 1,2; -0.5,1",
   "Boundary/Clamped=side2", "Boundary/Contact=side0", "Load/Body force=0.05; -0.2",
   "Contact/Gap=0.1*(x-1)^2-0.01"},
  {"Boundary/Displacement=top: 0; -0.1", "Boundary/Contact=bottom", "Material/Poisson's ratio=0.49",
   "Discretization/Element=Q1 B-bar", "Contact/Gap=0.2*(x-0.5)^2"}};

/** The body is held by contact, or by a plate: there are free motions. */
const std::vector<Settings> movable = {
  {"Geometry/Shape=polygon", "Geometry/Vertices=0,0; 2,0; 2.5,1.5; 1,2.5; -0.5,1",
   "Boundary/Contact=side0 side4", "Boundary/Rollers=side1 side2", "Load/Body force=-0.1; -0.3",
   "Contact/Gap=side0: 0.4*(x-1)^2 | side4: 0.2*y"},
  {"Boundary/Contact=bottom", "Load/Body force=0; -1", "Contact/Gap=0.1*(x-0.5)^2"},
  {"Boundary/Contact=bottom", "Boundary/Rollers=left", "Boundary/Plates=top: 0, -1",
   "Load/Plate force=top: 0.1", "Contact/Gap=0.1*x^2"}};

/** |a - b| / |b|, or |a| where b vanishes. */
template <typename First>
double relative_error(const First &a, const First &b) {
  const double size = b.linfty_norm();
  return distance(a, b) / (size > 0. ? size : 1.);
}

/**
 * A sweep lowers the objective by at least (1/omega - 1/2) sum C_ii (P_i^{k+1} - P_i^k)²: each of
 * its steps is part of the way, at most omega times, to the minimum along a coordinate.
 */
void check_sweeps(Checks &checks, const BoundConstrainedQP &qp) {
  for (const double relaxation : {0.5, 1.1, 1.8}) {
    Vector P(qp.size());
    for (unsigned int sweep = 0; sweep < 300; ++sweep) {
      Vector step(P);
      double rise = -qp.energy(P);
      psor_sweep(qp, relaxation, P);
      rise += qp.energy(P);
      step -= P;
      for (unsigned int i = 0; i < P.size(); ++i)
        rise += (1. / relaxation - 0.5) * qp.diagonal[i] * step[i] * step[i];
      checks.that("a sweep lowers the objective", rise <= 1e-13 * std::abs(P * qp.F));
    }
  }
}

void compare(Checks &checks, const Settings &settings, const std::vector<Settings> &solvers) {
  const auto solve_by = [&](const Settings &solver) {
    return OneLevel("", 4, settings + Settings{"Solver/Tolerance=1e-12"} + solver).solve();
  };
  const LevelSolution<2> exact =
    solve_by({"Solver/Contact solver=active set", "Output/Compliance=true"});
  checks.about(settings[0] + ", " + settings.back());
  checks.near("the mixed problem", max_residual(exact.record.certificate).value, 0., 1e-10);
  if (exact.contact.touches())
    check_sweeps(checks, BoundConstrainedQP(exact.operators->C->dense(), exact.contact.dual()->F));
  for (const Settings &solver : solvers) {
    const LevelSolution<2> found = solve_by(solver);
    checks.about(settings[0] + ", " + settings.back() + ", " + solver.back());
    checks.that("converged", found.record.dual.converged);
    checks.near("the mixed problem", max_residual(found.record.certificate).value, 0., 1e-9);
    checks.near("U", relative_error(found.contact.U, exact.contact.U), 0., 1e-8);
    checks.near("P", relative_error(found.contact.P.normal(), exact.contact.P.normal()), 0., 1e-8);
    checks.near("active", found.record.contact.active, exact.record.contact.active, 0.);
    const double energy = exact.record.certificate.energy, estimate = exact.record.estimate->energy;
    checks.near("energy", found.record.certificate.energy, energy,
                1e-10 * (1e-12 + std::abs(energy)));
    checks.near("the estimate", found.record.estimate->energy, estimate, 1e-6 * estimate + 1e-12);
  }
}

const std::string psor = "Solver/Contact solver=psor",
                  multigrid = "Solver/Contact solver=multigrid",
                  linear_multigrid = "Solver/Linear solver=multigrid";

void test_scenes(Checks &checks) {
  for (const Settings &settings : described)
    compare(checks, settings, {{psor}, {multigrid}, {linear_multigrid}});
  for (const Settings &settings : movable)
    compare(checks, settings, {{psor}, {linear_multigrid}});
  for (const CatalogueEntry<2> &scene : catalogue<2>())
    if (!scene.make().contact_law.has_tangential_part())
      compare(checks, {"Scene/Name=" + scene.name}, {{psor}});
  for (const std::string name : {"C4", "E3", "O1", "V1"})
    compare(checks, {"Scene/Name=" + name}, {{linear_multigrid}});
}

/** A solver that stops at 1 % says how far it is from the discrete solution (energy norm). */
void test_early_stop(Checks &checks) {
  const OneLevel level("", 4, block + Settings{"Solver/Tolerance=1e-12"});
  const LevelSolution<2> exact = level.solve();
  const ErrorEstimate &estimate = *exact.record.estimate;
  checks.between("exact: algebraic error", *estimate.algebra / estimate.energy, 0., 1e-8);
  for (const std::string &method : {psor, multigrid}) {
    checks.about(method);
    const LevelSolution<2> found =
      OneLevel("", 4, block + Settings{"Solver/Tolerance=1e-2", method}).solve();
    Displacement difference(found.contact.U);
    difference -= exact.contact.U;
    const double error =
      internal_forces(DisplacedBody(level.space(), level.scene, difference)).energy_norm;
    checks.that("stops early", error > 1e-8 * exact.contact.U.linfty_norm());
    checks.between("algebraic error over the true one", *found.record.estimate->algebra / error, 1.,
                   30.);
  }
}

template <int dim>
void check_cycles(Checks &checks, const StudyResult<dim> &result) {
  for (const LevelRecord &level : result.levels)
    checks.between("V-cycles on each level", level.dual.iterations, 5., 20.);
}

/** Studies on nested levels: certified, and as many V-cycles on every level. */
void test_nested(Checks &checks) {
  const StudyResult<2> exact = solve("", levels(3, 7, block)),
                       found = solve("", levels(3, 7, block + Settings{multigrid}));
  checks.about("nested");
  checks.that("certified", found.verdict.outcome == exact.verdict.outcome);
  check_cycles(checks, found);
  // The estimate and the lift of the bound are solved for loosely.
  for (const auto &[column, tolerance] :
       {std::pair("energy", 1e-9), std::pair("contact_force_n", 1e-7),
        std::pair("estimated_relative", 1e-4), std::pair("bound_relative", 1e-3)})
    checks.near(column, last(found, column) / last(exact, column), 1., tolerance);
}

void test_3d(Checks &checks) {
  const auto solve_by = [](const std::vector<std::string> &overrides) {
    return solve<3>("set Dimension = 3\n" + named_scene("D3"), levels(2, 4, overrides));
  };
  const StudyResult<3> exact = solve_by({"Solver/Contact solver=active set"});
  checks.about("3-D");
  const StudyResult<3> found = solve_by({multigrid});
  checks.near("P", relative_error(found.pressure.P, exact.pressure.P), 0., 1e-8);
  for (const char *column : {"energy", "u_h1", "u_post_h1", "p_l2"})
    checks.near(column, last(found, column) / last(exact, column), 1., 1e-8);
  checks.that("equations hold", found.verdict.equations_hold());
  check_cycles(checks, found);
}

} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv, {test_scenes, test_early_stop, test_nested, test_3d});
}
