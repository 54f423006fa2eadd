// SPDX-License-Identifier: LGPL-2.1-or-later
// Orders of convergence with other patches and elements, warm start, and quantities that a scene
// does not need.

#include <tuple>

#include "study_helpers.h"
#include "tests.h"

using namespace Signorini;

namespace {
const std::string a1 = named_scene("A1");

void check_wide_patches(Checks &checks) {
  check_orders(checks, solve(a1, levels(4, 7, {"Discretization/Patch ratio=4"})).levels,
               {{"u_superclose_h1", 1.4, 1.9}, {"p_l2", 0.85, 1.15}});
}

/** One order up: biquadratic elements with constants on single faces. Sides with given tractions
 * limit superconvergence to 5/2. */
void check_biquadratic(Checks &checks) {
  checks.about("C1, Q2");
  const StudyResult<2> result = solve(
    named_scene("C1"), levels(3, 5, {"Discretization/Element=Q2", "Discretization/Patch ratio=1"}));
  check_orders(checks, result.levels,
               {{"u_h1", 1.9, 2.1},
                {"u_superclose_h1", 2.4, 2.6},
                {"u_post_h1", 2.4, 2.6},
                {"p_l2", 0.95, 1.05},
                {"p_dual_spectral", 1.45, 1.55}});
  checks.near("inf-sup constant", last(result, "inf_sup"), 0.8727, 1e-4);
  checks.between("effectivity", last(result, "effectivity"), 0.98, 1.02);
  checks.between("bound over error", last(result, "bound_energy") / last(result, "u_energy"), 1.,
                 1.2);
}

/** Where nodal values are much closer than pi^{2h} shows, degree four on 4h brings it out. */
void check_degree_four(Checks &checks) {
  const auto errors = [](const std::string &scene, const unsigned int level) {
    return *solve(named_scene(scene), levels(level, level)).levels.back().displacement_errors;
  };
  const DisplacementErrors coarse = errors("A2", 1), a2 = errors("A2", 6), b1 = errors("B1", 5);
  checks.that("degree four needs two levels before", coarse.post_h1 && !coarse.post4_h1);
  checks.between("A2, degree four against two", *a2.post4_h1 / *a2.post_h1, 0.1, 0.3);
  checks.between("A2, degree four against nodal values", *a2.post4_h1 / a2.superclose_h1, 1., 2.);
  // The singularity of B1 lets no degree gain much, nor does it hurt.
  checks.between("B1, degree four against two", *b1.post4_h1 / *b1.post_h1, 0.7, 1.02);
}

/** From P = 0 with omega = 1: 62 sweeps for m = 16, as counted by an independent implementation. */
void check_iterations(Checks &checks) {
  const DualSolve dual =
    solve(a1, levels(5, 5, {"Solver/Contact solver=psor", "Solver/Relaxation=1"}))
      .levels.back()
      .dual;
  checks.that("sweeps of psor", dual.iterations == 62 && *dual.increment_iterations == 62);
  checks.that("projected SOR as chosen: no solver was replaced", !dual.active_set_failure);
}

void check_omissions(Checks &checks) {
  const LevelRecord open =
    solve("", levels(2, 3, {"Boundary/Clamped=top", "Boundary/Contact=bottom", "Contact/Gap=1"}))
      .levels.back();
  checks.that("no exact solution: no errors",
              !open.displacement_errors && !open.pressure_errors && !value(open, "effectivity"));
  const LevelRecord silent = solve(a1, levels(2, 3, {"Output/Errors=false"})).levels.back();
  checks.that("Output/Errors = false: an estimate, no errors",
              !silent.displacement_errors && !silent.pressure_errors && !silent.dual_norm_errors &&
                silent.estimate && silent.times.errors == 0.);
  const auto stopped = solve(a1, levels(2, 9, {"Discretization/Target error=0.05"}));
  checks.between("target error", last(stopped, "estimated_relative"), 0.02, 0.05);
  checks.that("target error: stopped early",
              stopped.levels.back().sizes.level < 7 && stopped.verdict.is_certified());
}

/** More patches than nodes: P is not unique, but U is, and the answer is still certified. */
void check_patches_finer_than_the_mesh(Checks &checks) {
  checks.about("seven patches on four faces");
  const StudyResult<2> result = solve(a1, levels(2, 2, {"Discretization/Patches=7"}));
  checks.that("certified, but unstable",
              result.verdict.equations_hold() && result.levels.back().sizes.unstable);
  // Rounding decides whether a pivot vanishes.
  const std::string failure = result.levels.back().dual.active_set_failure.value_or("");
  checks.that("where C is found singular, the record says who answered",
              failure.empty() || failure.find("singular") != std::string::npos);
}

/** Other refusals stand in wrong_files.txt. */
void check_failures(Checks &checks) {
  const auto exhausted =
    solve(a1, levels(2, 4, {"Solver/Contact solver=psor", "Solver/Maximum iterations=3"}));
  checks.that("sweeps run out: not certified, no finer level, and the cause is named",
              !exhausted.verdict.is_certified() && exhausted.levels.size() == 1 &&
                exhausted.verdict.reason.find("Maximum iterations") != std::string::npos);
  checks.refuses("a side of this scene ends inside a face of the mesh, allowed: a finer mesh "
                 "(Coarsest level).",
                 []() { solve(named_scene("C4"), {"Discretization/Coarsest level=1"}); });
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv,
                   {check_wide_patches, check_biquadratic, check_degree_four, check_iterations,
                    check_omissions, check_patches_finer_than_the_mesh, check_failures});
}
