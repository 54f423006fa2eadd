// SPDX-License-Identifier: LGPL-2.1-or-later
// Orders of convergence with other patches and elements, warm start, and what a scene does not
// need.

#include <signorini/base/errors.h>
#include <signorini/driver/study/study.h>

#include <deal.II/base/mpi.h>

#include "study_helpers.h"
#include "tests.h"

using namespace Signorini;

namespace
{
const std::string a1 = named_scene("A1");

void check_orders(Checks &checks)
{
  const auto wide = solve(a1,
                          {"Discretization/Patch ratio=4",
                           "Discretization/Coarsest level=4",
                           "Discretization/Finest level=7"})
                      .levels;
  checks.between("A1, H=4h, order of u_superclose", slope(wide, "u_superclose_h1"), 1.4, 1.9);
  checks.near("A1, H=4h, order of p_l2", slope(wide, "p_l2"), 1., 0.15);
}

/** One order up: biquadratic elements with constants on single faces. Sides with given tractions
 * limit superconvergence to 5/2. */
void check_biquadratic(Checks &checks)
{
  const auto levels = solve(named_scene("C1"),
                            {"Discretization/Element=Q2",
                             "Discretization/Patch ratio=1",
                             "Discretization/Coarsest level=3",
                             "Discretization/Finest level=5"})
                        .levels;
  checks.near("C1, Q2, order of u_h1", slope(levels, "u_h1"), 2., 0.1);
  checks.near("C1, Q2, order of u_superclose", slope(levels, "u_superclose_h1"), 2.5, 0.1);
  checks.near("C1, Q2, order of u_post", slope(levels, "u_post_h1"), 2.5, 0.1);
  checks.near("C1, Q2, order of p_l2", slope(levels, "p_l2"), 1., 0.05);
  checks.near("C1, Q2, order of p_dual", slope(levels, "p_dual_spectral"), 1.5, 0.05);
  checks.near("C1, Q2, inf-sup constant", *value(levels.back(), "inf_sup"), 0.8727, 1e-4);
  checks.between("C1, Q2, effectivity", *value(levels.back(), "effectivity"), 0.98, 1.02);
  checks.that("C1, Q2, no bound", !value(levels.back(), "bound_energy"));
}

/** Where nodal values are much closer than pi^{2h} shows, degree four on 4h brings it out. */
void check_degree_four(Checks &checks)
{
  const auto coarse =
    solve(named_scene("A2"), {"Discretization/Coarsest level=1", "Discretization/Finest level=1"})
      .levels.back();
  checks.that("degree four needs two levels before",
              value(coarse, "u_post_h1") && !value(coarse, "u_post4_h1"));
  const auto a2 =
    solve(named_scene("A2"), {"Discretization/Coarsest level=6", "Discretization/Finest level=6"})
      .levels.back()
      .displacement_errors.value();
  checks.between("A2, degree four against two", *a2.post4_h1 / *a2.post_h1, 0.1, 0.3);
  checks.between("A2, degree four against nodal values", *a2.post4_h1 / a2.superclose_h1, 1., 2.);
  // The singularity of B1 lets no degree gain much, nor does it hurt.
  const auto b1 =
    solve(named_scene("B1"), {"Discretization/Coarsest level=5", "Discretization/Finest level=5"})
      .levels.back()
      .displacement_errors.value();
  checks.between("B1, degree four against two", *b1.post4_h1 / *b1.post_h1, 0.7, 1.02);
}

void check_iterations(Checks &checks)
{
  bool flat = true;
  for (const LevelRecord &level : solve(a1, {"Discretization/Finest level=7"}).levels)
    flat = flat && level.dual.iterations <= 3;
  checks.that("with the warm start at most three active sets per level", flat);
  // From P = 0 with omega = 1: 62 sweeps for m = 16, as counted by an independent implementation.
  const DualSolve dual = solve(a1,
                               {"Discretization/Coarsest level=5",
                                "Discretization/Finest level=5",
                                "Solver/Contact solver=psor",
                                "Solver/Relaxation=1"})
                           .levels.back()
                           .dual;
  checks.that("sweeps of psor", dual.iterations == 62 && *dual.increment_iterations == 62);
  checks.that("projected SOR as chosen: no solver was replaced", !dual.active_set_failure);
}

void check_omissions(Checks &checks)
{
  const std::string block = "subsection Boundary\n set Clamped = top\n set Contact = bottom\n end\n"
                            "subsection Contact\n set Gap = 1\n end\n";
  const LevelRecord open = solve(block, {"Discretization/Finest level=3"}).levels.back();
  checks.that("nothing touches: no iterations", open.dual.iterations == 0 && open.dual.kkt == 0.);
  checks.that("nothing touches: no contact",
              open.contact.active == 0 && open.contact.normal_force == 0.);
  checks.that("no exact solution: no errors",
              !open.displacement_errors && !open.pressure_errors && !value(open, "effectivity"));
  const LevelRecord silent =
    solve(a1, {"Output/Errors=false", "Discretization/Finest level=3"}).levels.back();
  checks.that("Output/Errors = false: an estimate, no errors",
              !silent.displacement_errors && !silent.pressure_errors && !silent.dual_norm_errors &&
                silent.estimate && silent.times.errors == 0.);
  const auto stopped =
    solve(a1, {"Discretization/Target error=0.05", "Discretization/Finest level=9"});
  checks.between("target error", stopped.levels.back().estimate->relative, 0.02, 0.05);
  checks.that("target error: stopped early",
              stopped.levels.back().sizes.level < 7 && stopped.verdict.is_certified());
}

/** More patches than nodes: P is not unique, but U is, and the answer is still certified. */
void check_patches_finer_than_the_mesh(Checks &checks)
{
  const std::vector<std::string> level = {"Discretization/Coarsest level=2",
                                          "Discretization/Finest level=2"};
  auto fine = level;
  fine.emplace_back("Discretization/Patches=7");
  const StudyResult<2> result = solve(a1, fine);
  checks.that("seven patches on four faces: certified", result.verdict.equations_hold());
  checks.that("seven patches on four faces: C is singular, and the record says who answered",
              result.levels.back().dual.active_set_failure.value_or("").find("singular") !=
                std::string::npos);
  checks.that("seven patches on four faces: unstable", result.levels.back().sizes.unstable);
}

void check_failures(Checks &checks)
{
  const auto exhausted = solve(
    a1,
    {"Solver/Contact solver=psor", "Solver/Maximum iterations=3", "Discretization/Finest level=4"});
  checks.that("sweeps run out: not certified", !exhausted.verdict.is_certified());
  checks.that("sweeps run out: no finer level", exhausted.levels.size() == 1);
  checks.that("sweeps run out: the cause is named",
              exhausted.verdict.reason.find("Maximum iterations") != std::string::npos);
  checks.throws<InputError>("H = h refused", "not inf-sup stable", [&]() {
    solve(a1, {"Discretization/Patch ratio=1", "Solver/Require stability=true"});
  });
  checks.throws<InputError>("a level that cannot fit into memory", "GiB", [&]() {
    solve(a1, {"Discretization/Finest level=14"});
  });
  checks.throws<InputError>("patches without free nodes", "sees no free mesh node", [&]() {
    solve("subsection Boundary\n set Clamped = left right top\n set Contact = bottom\n end\n",
          {"Discretization/Coarsest level=0"});
  });
  checks.throws<InputError>(
    "a side that ends inside a face",
    "--set: Discretization/Coarsest level: a side of this scene ends inside a face of the mesh, "
    "allowed: a finer coarsest level.",
    [&]() { solve(named_scene("C4"), {"Discretization/Coarsest level=1"}); });
}
} // namespace

int main(int argc, char **argv)
{
  dealii::deal_II_exceptions::disable_abort_on_exception();
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  Checks checks;
  check_orders(checks);
  check_biquadratic(checks);
  check_degree_four(checks);
  check_iterations(checks);
  check_omissions(checks);
  check_patches_finer_than_the_mesh(checks);
  check_failures(checks);
  return checks.exit_code();
}
