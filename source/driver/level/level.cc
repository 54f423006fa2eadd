// SPDX-License-Identifier: LGPL-2.1-or-later
// One level, from the mesh to the certified answer.

#include <signorini/base/columns.h>
#include <signorini/driver/level/level.h>
#include <signorini/driver/level/level_iteration.h>
#include <signorini/solvers/contact/recovery.h>
#include <signorini/solvers/methods/escape_message.h>
#include <signorini/solvers/multigrid/stiffness_multigrid.h>

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

/** What the dual problem is told of free motions. */
template <int dim>
FreeMotions motions_of(const MotionModes<dim> &modes,
                       const Scene<dim> &scene,
                       const Coupling &D,
                       const DistributedVector &loads,
                       const NodalVector &U_0)
{
  const MotionWork work = modes.work(scene.plates, NodalVector(loads), U_0);
  return {modes.couple(D), modes.K, work.value, work.magnitude};
}

/** The names of rigid motions that contact does not see. @throws InputError if loads drive one. */
template <int dim>
std::vector<std::string> undetermined_motions(const Parameters &parameters,
                                              const Scene<dim> &scene,
                                              const MotionModes<dim> &modes,
                                              const DistributedVector &loads)
{
  std::vector<std::string> names;
  if (modes.unseen.empty())
    return names;
  if (const auto driven = modes.driven_unseen(scene.plates, NodalVector(loads)))
    refuse_sliding(parameters, *modes.unseen[*driven].rigid);
  for (const FreeMotion &motion : modes.unseen)
    names.push_back(motion.rigid->name());
  return names;
}

/** P, q and U. */
template <int dim>
Pressure find_contact(const Parameters &parameters,
                      const Discretization<dim> &discretization,
                      const StiffnessInverse &inverse,
                      const MotionModes<dim> &modes,
                      const FreeState &free,
                      const DistributedVector &f,
                      const dealii::Vector<double> &start,
                      const Progress &progress,
                      LevelSolution<dim> &solution)
{
  Pressure pressure = {
    dealii::Vector<double>(discretization.multipliers.n_multipliers()), {}, {}, {}, {}};
  solution.P = pressure.P;
  if (modes.size() == 0 && free.nothing_touches())
  {
    solution.U = free.U;
    return pressure;
  }
  pressure = find_pressure(parameters, discretization, inverse, modes, start, progress, solution);
  solution.P = pressure.P;
  solution.U = timed(solution.record.times.recovery,
                     [&]() { return recover(discretization, inverse, modes, f, solution); });
  correct_rounding(parameters, discretization, inverse, modes, f, pressure, solution);
  solution.P = pressure.P;
  solution.algebraic_error = algebraic_error(parameters, discretization, *pressure.C, solution);
  return pressure;
}

/** Makes q part of what is prescribed: U_0 + Z q is the body without contact then. */
template <int dim>
void prescribe_motions(const MotionModes<dim> &modes,
                       const LevelSolution<dim> &solution,
                       FreeState &free)
{
  if (modes.size() == 0)
    return;
  modes.add_to(free.U, solution.q);
  dealii::Vector<double> B_q(free.F.size());
  solution.motions.B.vmult(B_q, solution.q);
  free.F -= B_q;
}
/** What contact was found from. */
template <int dim>
struct ContactAnswer
{
  MotionModes<dim> modes;
  /** With plates and body where they have moved to. */
  FreeState free;
  Pressure pressure;
};

/** By F, C and the dual problem. */
template <int dim>
ContactAnswer<dim> solve_dual(const Parameters &parameters,
                              const Scene<dim> &scene,
                              const Discretization<dim> &discretization,
                              const LinearSystem<dim> &system,
                              const StiffnessInverse &inverse,
                              const dealii::Vector<double> &start,
                              const Progress &progress,
                              LevelSolution<dim> &solution)
{
  const DisplacementSpace<dim> &space = discretization.space;
  LevelRecord &record = solution.record;
  FreeState free = timed(record.times.compliance, [&]() {
    return solve_free_state(inverse, space, system.f, discretization.D, discretization.G);
  });
  solution.F = free.F;
  MotionModes<dim> modes =
    timed(record.times.compliance, [&]() { return make_motion_modes(space, scene, inverse); });
  if (modes.size() > 0)
    solution.motions = motions_of(modes, scene, discretization.D, system.loads, free.U);
  record.motions.undetermined = undetermined_motions(parameters, scene, modes, system.loads);
  Pressure pressure = find_contact(
    parameters, discretization, inverse, modes, free, system.f, start, progress, solution);
  prescribe_motions(modes, solution, free);
  record.linear = {inverse.n_solves(), inverse.largest_residual(), inverse.rounding_error()};
  return {std::move(modes), std::move(free), std::move(pressure)};
}

/** By V-cycles. U stands for the body without contact, too, which nobody knows: it is asked for
 * only as a scale. */
template <int dim>
ContactAnswer<dim> solve_by_cycles(const Parameters &parameters,
                                   const Scene<dim> &scene,
                                   const Discretization<dim> &discretization,
                                   const LinearSystem<dim> &system,
                                   const MultigridInverse &inverse,
                                   const LevelStart &start,
                                   const Progress &progress,
                                   LevelSolution<dim> &solution)
{
  MotionModes<dim> modes = make_motion_modes(discretization.space, scene, inverse);
  progress("V-cycles");
  Pressure pressure = iterate_contact(
    parameters, discretization, system, inverse.stiffness(), modes, start, solution);
  return {std::move(modes), {solution.U, discretization.G}, std::move(pressure)};
}
} // namespace

template <int dim>
LevelSolution<dim> solve_level(const Parameters &parameters,
                               const Scene<dim> &scene,
                               const Discretization<dim> &discretization,
                               const LevelStart &start,
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
      uses_multigrid(parameters) ? assemble_right_hand_side(space, scene, discretization.n_points)
                                 : assemble_linear_system(space, scene, discretization.n_points));
  });
  const LinearSystem<dim> &system = *owned_system;
  if (parameters.output.compliance)
    solution.system = owned_system;

  progress("factorisation");
  const std::shared_ptr<const StiffnessInverse> inverse =
    timed(times.factor, [&]() -> std::unique_ptr<StiffnessInverse> {
      if (uses_multigrid(parameters))
        return make_multigrid_inverse(
          space, scene, iterates_contact(parameters) ? goal_of_estimates : goal_of_solves);
      return factorise(system.matrix,
                       system.unit,
                       parameters.solver.linear_solver,
                       contact_unknowns(discretization.condensed_D));
    });

  const ContactAnswer<dim> contact =
    iterates_contact(parameters)
      ? solve_by_cycles(parameters,
                        scene,
                        discretization,
                        system,
                        dynamic_cast<const MultigridInverse &>(*inverse),
                        start,
                        progress,
                        solution)
      : solve_dual(
          parameters, scene, discretization, system, *inverse, start.P, progress, solution);
  solution.scene = with_plates_moved(scene, contact.modes.plate_motions(scene.plates, solution.q));
  solution.loads = system.loads;

  examine(parameters,
          discretization,
          {system, *inverse, contact.free, contact.pressure, contact.modes},
          progress,
          solution);
  if (!scene.load_cases.empty())
    solution.factors = std::make_shared<const LevelFactors<dim>>(
      LevelFactors<dim>{owned_system, inverse, contact.modes});
  return solution;
}

template LevelSolution<2> solve_level(const Parameters &,
                                      const Scene<2> &,
                                      const Discretization<2> &,
                                      const LevelStart &,
                                      const Progress &);
template LevelSolution<3> solve_level(const Parameters &,
                                      const Scene<3> &,
                                      const Discretization<3> &,
                                      const LevelStart &,
                                      const Progress &);
} // namespace Signorini
