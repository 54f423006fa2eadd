// SPDX-License-Identifier: LGPL-2.1-or-later
// The estimate of the energy error against the error itself, from exact gradients: within the
// factors 0.8 and 1.25 for patches of two, four and eight faces and for patches that are not
// refined with the mesh. A block without an exact solution, against a finer mesh.

#include <signorini/discretization/space/internal_forces.h>
#include <signorini/verification/catalogue/catalogue.h>
#include <signorini/verification/verify.h>

#include <deal.II/numerics/vector_tools_interpolate.h>

#include "one_level.h"
#include "study_helpers.h"
#include "tests.h"

using namespace Signorini;

namespace {
constexpr double lowest = 0.8, highest = 1.25;

/** One level with its errors. It is not the finest one of its study, so that its bound is not
 * computed, which takes most of the time; nor are norms of order -1/2. */
LevelRecord level_without_bound(const std::string &scene, const std::string &partition,
                                const unsigned int level) {
  const OneLevel one(named_scene(scene), level,
                     {"Discretization/Finest level=" + std::to_string(level + 1),
                      "Discretization/" + partition, "Output/Inf-sup constant=false"});
  LevelSolution<2> solution = one.solve();
  add_errors<2>(one.parameters, one.discretization, nullptr, solution);
  return solution.record;
}

/** All scenes with a known solution but D1, which is solved exactly. */
void known_solutions(Checks &checks) {
  for (const CatalogueEntry<2> &scene : checks.rows(catalogue<2>(), 6))
    if (scene.name != "D1" && scene.name != "block on parabola" &&
        !scene.make().contact_law.has_tangential_part())
      for (const std::string partition : {"Patch ratio=2", "Patches=8"})
        checks.between(scene.name + ", " + partition,
                       *value(level_without_bound(scene.name, partition, 5), "effectivity_energy"),
                       lowest, highest);
}

/** Whether the energy estimate sees errors that the distance to pi^{2h} alone does not. */
void coarse_patches(Checks &checks) {
  for (const auto &[scene, partition] :
       {std::pair("A1", "Patch ratio=8"), std::pair("E2", "Patches=8")}) {
    const LevelRecord level = level_without_bound(scene, partition, 6);
    checks.about(scene);
    checks.between("the energy estimate on level 6", *value(level, "effectivity_energy"), lowest,
                   highest);
    checks.between("H1: blind for long patches", *value(level, "effectivity"), 0., 0.5);
  }
}

/** The block on a parabola against the same on level 7 with H = 2 h. */
void finer_reference(Checks &checks) {
  const std::string block = named_scene("block on parabola");
  const std::vector<std::string> options = {"Output/Inf-sup constant=false",
                                            "Discretization/Coarsest level=2"};
  const OneLevel fine(block, 7, options);
  const Displacement U = fine.solve().contact.U;
  for (const char *partition : {"4", "8"}) {
    const OneLevel coarse(block + entry("Discretization", "Patches", partition), 5, options);
    const LevelSolution<2> solution = coarse.solve();
    Displacement difference = fine.space().zero();
    difference.zero_out_ghost_values();
    dealii::VectorTools::interpolate_to_different_mesh(coarse.space().dofs(),
                                                       solution.contact.U.entries(),
                                                       fine.space().dofs(), difference.entries());
    difference -= U;
    const double error =
      internal_forces(DisplacedBody(fine.space(), fine.scene, difference)).energy_norm;
    const ErrorEstimate &estimate = *solution.record.estimate;
    const std::string name = std::string("block on parabola, Patches = ") + partition;
    // Two of four patches press, and the misfit of contact exceeds the error of p_H.
    constexpr double highest_of_few = 1.5;
    checks.between(name, estimate.energy / error, lowest, highest_of_few);
    checks.that(name + ": the mesh is not the largest part", estimate.mesh < estimate.pressure);
  }
}

} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv, {known_solutions, coarse_patches, finer_reference});
}
