// SPDX-License-Identifier: LGPL-2.1-or-later
// One level, from the mesh to the certified answer.

#include <signorini/base/stage_timer.h>
#include <signorini/recovery/recovery.h>
#include <signorini/study/level.h>

#include "level_examination.h"

namespace Signorini
{
namespace
{
template <int dim>
LevelSizes sizes_of(const Discretization<dim> &discretization)
{
  return {discretization.mesh.level(),
          discretization.mesh.triangulation().n_global_active_cells(),
          discretization.space.dofs().n_dofs(),
          discretization.multipliers.n_multipliers(),
          discretization.mesh.longest_edge(),
          discretization.surface.longest_patch(),
          is_unstable(discretization),
          discretization.space.largest_degree(),
          discretization.mesh.shortest_edge()};
}
} // namespace

template <int dim>
LevelSolution<dim> solve_level(const Parameters &parameters,
                               const Scene<dim> &scene,
                               const Discretization<dim> &discretization,
                               const dealii::Vector<double> &start,
                               const Progress &progress)
{
  const DisplacementSpace<dim> &space = discretization.space;
  LevelSolution<dim> solution;
  LevelRecord &record = solution.record;
  StageTimes &times = record.times;
  record.sizes = sizes_of(discretization);
  times = discretization.times;

  progress("assembly");
  const auto owned_system = timed(times.assembly, [&]() {
    return std::make_shared<const LinearSystem<dim>>(
      assemble_linear_system(space, scene, discretization.n_points));
  });
  const LinearSystem<dim> &system = *owned_system;
  if (parameters.output.compliance)
    solution.system = owned_system;

  progress("factorisation");
  const auto inverse = timed(times.factor, [&]() {
    return factorise(system.matrix,
                     system.unit,
                     parameters.solver.linear_solver,
                     contact_unknowns(discretization.condensed_D));
  });

  const FreeState free = timed(times.compliance, [&]() {
    return solve_free_state(*inverse, space, system.f, discretization.D, discretization.G);
  });
  solution.F = free.F;

  Pressure pressure = {
    dealii::Vector<double>(discretization.multipliers.n_multipliers()), {}, {}, {}, {}};
  if (!free.nothing_touches())
    pressure = find_pressure(parameters, discretization, *inverse, start, progress, solution);
  solution.P = pressure.P;
  solution.U = free.nothing_touches() ? free.U : timed(times.recovery, [&]() {
    return recover_displacement(*inverse, space, discretization.condensed_D, solution.P, system.f);
  });
  if (pressure.C)
    correct_rounding(parameters, discretization, *inverse, system.f, pressure, solution);
  solution.P = pressure.P;
  solution.loads = system.loads;
  record.linear = {inverse->n_solves(), inverse->largest_residual(), inverse->rounding_error()};

  examine(
    parameters, scene, discretization, {system, *inverse, free, pressure}, progress, solution);
  return solution;
}

template LevelSolution<2> solve_level(const Parameters &,
                                      const Scene<2> &,
                                      const Discretization<2> &,
                                      const dealii::Vector<double> &,
                                      const Progress &);
} // namespace Signorini
