// SPDX-License-Identifier: LGPL-2.1-or-later
// What is known about the solution of one level.

#include "level_examination.h"

#include <signorini/base/stage_timer.h>
#include <signorini/bound/error_bound.h>
#include <signorini/compliance/compliance.h>
#include <signorini/postprocess/inf_sup.h>
#include <signorini/qp/dual_solver.h>

namespace Signorini
{
namespace
{
/** The limit of Inf-sup constant = automatic: it needs a factorisation of its own. */
constexpr unsigned int largest_automatic_inf_sup = 100000;

/** Whether the constant of Lemma 1 is asked for on a level of this size; on graded meshes only if
 * the user wants it. */
bool wants_inf_sup(const Parameters &parameters, const unsigned long long n_dofs)
{
  const Choice choice = parameters.output.inf_sup_constant;
  return choice == Choice::yes ||
         (choice == Choice::automatic && parameters.discretization.strategy == Strategy::nested &&
          n_dofs <= largest_automatic_inf_sup);
}

/** The bound is asked for where the study may stop. */
bool wants_bound(const DiscretizationParameters &given, const unsigned int level)
{
  if (given.strategy == Strategy::hp)
    return false;
  return level == given.finest_level || given.target_error > 0.;
}

/** The certificate, and the answer, which needs the same nodal forces. */
template <int dim>
void add_certificate_and_answer(const Scene<dim> &scene,
                                const Discretization<dim> &discretization,
                                const SolvedSystem<dim> &solved,
                                LevelSolution<dim> &solution)
{
  const DisplacementSpace<dim> &space = discretization.space;
  LevelRecord &record = solution.record;
  record.contact = summarise_contact(discretization.multipliers, solution.P);
  const NodalForces forces =
    nodal_forces(space, scene, solved.system.loads, discretization.D, solution.U, solution.P);
  record.certificate = certify(space,
                               scene,
                               solved.system,
                               discretization.multipliers,
                               discretization.D,
                               ContactSolution<dim>{solution.U,
                                                    solved.free.U,
                                                    solution.P,
                                                    solution.F,
                                                    discretization.G,
                                                    solved.pressure.C_P,
                                                    solved.pressure.diagonal_P},
                               forces);
  record.answer =
    compute_answer(space, scene, discretization.multipliers, forces, solution.U, solution.P);
}

/** The dual problem on other patches, for the estimate. */
DualProblem dual_problem(const StiffnessInverse &inverse)
{
  return [&inverse](const Coupling &condensed_D,
                    const dealii::Vector<double> &F,
                    const dealii::Vector<double> &start) -> std::optional<dealii::Vector<double>> {
    double seconds = 0.;
    const QPResult result =
      solve_dual_problem(make_compliance(inverse, condensed_D, seconds), F, start, {});
    return result.converged ? std::optional<dealii::Vector<double>>(result.P) : std::nullopt;
  };
}
/** The estimate of the error. */
template <int dim>
void add_estimate(const Scene<dim> &scene,
                  const Discretization<dim> &discretization,
                  const SolvedSystem<dim> &solved,
                  LevelSolution<dim> &solution)
{
  const PressureCorrection correction = correct_pressure({discretization.space,
                                                          scene,
                                                          discretization.multipliers,
                                                          solved.free.U,
                                                          solution.P,
                                                          discretization.condensed_D,
                                                          solved.inverse,
                                                          discretization.n_points,
                                                          dual_problem(solved.inverse)});
  solution.record.estimate = estimate_error(discretization.space, scene, solution.U, correction);
}

/** The bound of the error of U and P, and where it comes from. */
template <int dim>
void add_bound(const Scene<dim> &scene,
               const Discretization<dim> &discretization,
               const StiffnessInverse &inverse,
               LevelSolution<dim> &solution)
{
  const StageTimer timer(solution.record.times.bound);
  LocatedBound located = compute_located_bound({{discretization.space,
                                                 scene,
                                                 discretization.multipliers,
                                                 solution.U,
                                                 solution.P,
                                                 discretization.n_points},
                                                inverse,
                                                discretization.condensed_D,
                                                discretization.G});
  solution.record.bound = located.bound;
  solution.bound_fields = std::move(located.fields);
}
} // namespace

template <int dim>
void examine(const Parameters &parameters,
             const Scene<dim> &scene,
             const Discretization<dim> &discretization,
             const SolvedSystem<dim> &solved,
             const Progress &progress,
             LevelSolution<dim> &solution)
{
  LevelRecord &record = solution.record;
  const StageTimer timer(record.times.postprocess);
  const DisplacementSpace<dim> &space = discretization.space;
  if (wants_inf_sup(parameters, space.dofs().n_dofs()))
  {
    progress("inf-sup constant");
    record.inf_sup = measure_inf_sup(space,
                                     discretization.multipliers,
                                     discretization.condensed_D,
                                     parameters.solver.linear_solver);
  }
  progress("certificate");
  add_certificate_and_answer(scene, discretization, solved, solution);
  if (discretization.mesh.has_parents())
    add_estimate(scene, discretization, solved, solution);
  if (wants_bound(parameters.discretization, record.sizes.level))
  {
    progress("bound of the error");
    add_bound(scene, discretization, solved.inverse, solution);
  }
}

template void examine(const Parameters &,
                      const Scene<2> &,
                      const Discretization<2> &,
                      const SolvedSystem<2> &,
                      const Progress &,
                      LevelSolution<2> &);
} // namespace Signorini
