// SPDX-License-Identifier: LGPL-2.1-or-later
// The estimate of the energy error against the error itself, from exact gradients: within the
// factors 0.8 and 1.25 for patches of two, four and eight faces and for patches that are not
// refined with the mesh. A block without an exact solution, against a finer mesh. Translations.

#include <signorini/discretization/elasticity/integration.h>

#include <deal.II/base/mpi.h>
#include <deal.II/numerics/vector_tools_interpolate.h>

#include "one_level.h"
#include "study_helpers.h"
#include "tests.h"

using namespace Signorini;

namespace
{
constexpr double lowest = 0.8, highest = 1.25;

std::vector<std::string> options(const std::string &partition, const unsigned int level)
{
  std::vector<std::string> all = levels(level, level);
  all.push_back("Discretization/" + partition);
  all.emplace_back("Output/Inf-sup constant=false");
  return all;
}

/** One level with its errors. It is not the finest one of its study, so that its bound is not
 * computed, which takes most of the time; nor are norms of order -1/2. */
LevelRecord level_without_bound(const std::string &scene,
                                const std::string &partition,
                                const unsigned int level)
{
  const std::size_t equals = partition.find('=');
  const OneLevel one(
    named_scene(scene) + entry("Discretization", "Finest level", std::to_string(level + 1)) +
      entry("Discretization", partition.substr(0, equals), partition.substr(equals + 1)) +
      entry("Output", "Inf-sup constant", "false"),
    level);
  LevelSolution<2> solution = one.solve();
  add_errors<2>(one.parameters, one.scene, one.discretization, nullptr, solution);
  return solution.record;
}

/** All scenes with a known solution. */
void known_solutions(Checks &checks)
{
  for (const char *scene : {"A1",
                            "A1L",
                            "A2",
                            "A3",
                            "B1",
                            "B1q",
                            "B1t",
                            "B2",
                            "B3",
                            "B4",
                            "C1",
                            "C2",
                            "C3",
                            "C4",
                            "E1",
                            "E2",
                            "E3",
                            "O1",
                            "V1"})
    for (const char *partition : {"Patch ratio=2", "Patches=8"})
      checks.between(std::string(scene) + ", " + partition,
                     *value(level_without_bound(scene, partition, 5), "effectivity_energy"),
                     lowest,
                     highest);
}

/** Whether the energy estimate sees what the distance to pi^{2h} alone does not. */
void coarse_patches(Checks &checks)
{
  for (const auto &[scene, partition] :
       {std::make_pair("A1", "Patch ratio=8"), std::make_pair("E2", "Patches=8")})
  {
    const LevelRecord level = level_without_bound(scene, partition, 6);
    const std::string name = std::string(scene) + ", level 6, " + partition;
    checks.between(
      name + ", the energy estimate", *value(level, "effectivity_energy"), lowest, highest);
    checks.between(name + ", H1: blind for long patches", *value(level, "effectivity"), 0., 0.5);
  }
}

/** The block on a parabola against the same on level 7 with H = 2 h. */
void finer_reference(Checks &checks)
{
  const std::string block = named_scene("block on parabola") +
                            entry("Output", "Inf-sup constant", "false") +
                            entry("Discretization", "Coarsest level", "2");
  const OneLevel fine(block, 7);
  const Displacement U = fine.solve().U;
  for (const char *partition : {"4", "8"})
  {
    const OneLevel coarse(block + entry("Discretization", "Patches", partition), 5);
    const LevelSolution<2> solution = coarse.solve();
    Displacement difference = fine.space().zero();
    difference.zero_out_ghost_values();
    dealii::VectorTools::interpolate_to_different_mesh(
      coarse.space().dofs(), solution.U.entries(), fine.space().dofs(), difference.entries());
    difference -= U;
    const double error = energy_norm(fine.space(), fine.scene, difference);
    const ErrorEstimate &estimate = *solution.record.estimate;
    const std::string name = std::string("block on parabola, Patches = ") + partition;
    checks.between(name, estimate.energy / error, lowest, highest);
    checks.that(name + ": the mesh is not the largest part", estimate.mesh < estimate.pressure);
  }
}

/** Displacements and gap moved by the same vector, a thousand sizes of the body. */
void translations(Checks &checks)
{
  const auto estimate = [](const std::string &shift) {
    return *solve(entry("Constants", "Values", "c=" + shift) +
                    "subsection Boundary\nset Contact = bottom\n"
                    "set Displacement = top: c; -0.05-c\nend\n" +
                    entry("Contact", "Gap", "0.3*(x-0.5)^2+c"),
                  options("Patch ratio=4", 5))
              .levels.back()
              .estimate;
  };
  const ErrorEstimate here = estimate("0"), there = estimate("1000");
  checks.that("pressed down: all parts", here.mesh > 0. && here.pressure > 0.);
  checks.near("relative estimate after a translation", there.relative / here.relative, 1., 1e-6);
}
} // namespace

int main(int argc, char **argv)
{
  dealii::deal_II_exceptions::disable_abort_on_exception();
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  Checks checks;
  known_solutions(checks);
  coarse_patches(checks);
  finer_reference(checks);
  translations(checks);
  return checks.exit_code();
}
