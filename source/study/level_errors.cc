// SPDX-License-Identifier: LGPL-2.1-or-later
// What is known about a level when the exact solution is.

#include <signorini/base/stage_timer.h>
#include <signorini/errors/contact_ends.h>
#include <signorini/study/level.h>

namespace Signorini
{
template <int dim>
void add_errors(const Parameters &parameters,
                const Scene<dim> &scene,
                const Discretization<dim> &discretization,
                const ExactPressure<dim> *pressure,
                LevelSolution<dim> &solution)
{
  if (!parameters.output.errors)
    return;
  const unsigned int n_points = discretization.n_points + 1;
  const MultiplierSpace<dim> &multipliers = discretization.multipliers;
  LevelRecord &record = solution.record;
  const StageTimer timer(record.times.errors);
  if (scene.exact_displacement != nullptr)
    record.displacement_errors =
      compute_displacement_errors(discretization.space, scene, solution.U, n_points);
  if (scene.has_exact_pressure())
  {
    record.pressure_errors = compute_pressure_errors(multipliers, solution.P, n_points);
    record.endpoint_error = contact_end_error(multipliers, scene, solution.P);
  }
  if (pressure != nullptr)
    record.dual_norm_errors = pressure->errors(multipliers, solution.P);
  if constexpr (dim == 2)
    if (parameters.output.lemmas && parameters.discretization.strategy == Strategy::nested &&
        scene.exact_displacement != nullptr && pressure != nullptr)
      record.lemmas = compute_lemma_numbers(discretization.space,
                                            scene,
                                            multipliers,
                                            discretization.D,
                                            *pressure,
                                            solution.loads,
                                            parameters.solver.linear_solver,
                                            n_points);
}

template void add_errors(const Parameters &,
                         const Scene<2> &,
                         const Discretization<2> &,
                         const ExactPressure<2> *,
                         LevelSolution<2> &);
template void add_errors(const Parameters &,
                         const Scene<3> &,
                         const Discretization<3> &,
                         const ExactPressure<3> *,
                         LevelSolution<3> &);
} // namespace Signorini
