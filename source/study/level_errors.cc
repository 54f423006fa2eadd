// SPDX-License-Identifier: LGPL-2.1-or-later
// What is known about a level when the exact solution is.

#include <signorini/errors/contact_ends.h>
#include <signorini/errors/displacement_errors.h>
#include <signorini/errors/lemma_numbers.h>
#include <signorini/errors/pressure_errors.h>
#include <signorini/study/level.h>

namespace Signorini
{
namespace
{
void record_pressure_errors(const PressureErrors &errors,
                            const DualNormErrors &dual,
                            LevelRecord &record)
{
  record.p_l2 = errors.l2;
  record.p_post_l2 = errors.post_l2;
  record.p_dual = dual.slobodeckij;
  record.p_dual_spectral = dual.spectral;
  record.p_superclose_dual = dual.superclose_slobodeckij;
  record.p_superclose_dual_spectral = dual.superclose_spectral;
}

void record_displacement_errors(const DisplacementErrors &errors, LevelRecord &record)
{
  record.u_h1 = errors.h1;
  record.u_l2 = errors.l2;
  record.u_superclose_h1 = errors.superclose_h1;
  record.u_post_h1 = errors.post_h1;
  record.u_post4_h1 = errors.post4_h1;
}

void record_lemma_numbers(const LemmaNumbers &numbers, LevelRecord &record)
{
  record.lemma_2_l2 = numbers.projection_l2;
  record.lemma_2_dual = numbers.projection_dual;
  record.lemma_3_h1 = numbers.interpolation_h1;
  record.lemma_3_trace = numbers.interpolation_trace;
  record.lemma_5 = numbers.consistency;
  record.bound_26 = numbers.bound_26;
  record.bound_27 = numbers.bound_27;
  record.bound_30 = numbers.bound_30;
}
} // namespace

template <int dim>
void add_errors(const Parameters &parameters,
                const Scene<dim> &scene,
                const Discretization<dim> &discretization,
                const ExactPressure<dim> *pressure,
                LevelSolution<dim> &solution)
{
  if (!parameters.output.errors)
    return;
  StageClock clock;
  const unsigned int n_points = discretization.n_points + 1;
  const MultiplierSpace<dim> &multipliers = discretization.multipliers;
  LevelRecord &record = solution.record;
  if (scene.exact_displacement != nullptr)
    record_displacement_errors(
      compute_displacement_errors(discretization.space, scene, solution.U, n_points), record);
  if (pressure != nullptr)
  {
    record_pressure_errors(compute_pressure_errors(multipliers, solution.P, n_points),
                           pressure->errors(multipliers, solution.P),
                           record);
    record.endpoint_error = contact_end_error(multipliers, scene, solution.P);
  }
  if (parameters.output.lemmas && scene.exact_displacement != nullptr && pressure != nullptr)
    record_lemma_numbers(compute_lemma_numbers(discretization.space,
                                               scene,
                                               multipliers,
                                               discretization.D,
                                               *pressure,
                                               solution.loads,
                                               parameters.solver.linear_solver,
                                               n_points),
                         record);
  clock.add_to(record.times.errors);
}

template void add_errors(const Parameters &,
                         const Scene<2> &,
                         const Discretization<2> &,
                         const ExactPressure<2> *,
                         LevelSolution<2> &);
} // namespace Signorini
