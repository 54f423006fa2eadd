// SPDX-License-Identifier: LGPL-2.1-or-later
// One level, from the mesh to the certified answer.

#include <signorini/base/stage_timer.h>
#include <signorini/bound/error_bound.h>
#include <signorini/compliance/compliance.h>
#include <signorini/compliance/free_state.h>
#include <signorini/postprocess/inf_sup.h>
#include <signorini/qp/dual_solver.h>
#include <signorini/recovery/recovery.h>
#include <signorini/study/level.h>

#include <algorithm>

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
          discretization.surface.has_unstable_patch()};
}

DualSolve summary_of(const QPResult &result, const ContactSolver method)
{
  DualSolve summary;
  summary.iterations = result.iterations;
  if (method == ContactSolver::psor)
    summary.increment_iterations = result.increment_iterations;
  summary.kkt = result.kkt_residual;
  summary.converged = result.converged;
  summary.unique = result.unique;
  summary.active_set_failure = result.active_set_failure;
  return summary;
}

/** Tells the user of every twentieth part of the columns of C. */
ColumnProgress column_progress(const Progress &progress, const unsigned int n_columns)
{
  const unsigned int every = std::max(1U, n_columns / 20);
  return [&progress, every, n_columns](const unsigned int done) {
    if (done % every == 0)
      progress("compliance: " + std::to_string(done) + " columns, up to " +
               std::to_string(n_columns));
  };
}

/** The limit of Inf-sup constant = automatic: it needs a factorisation of its own. */
constexpr unsigned int largest_automatic_inf_sup = 100000;

/** Whether the constant of Lemma 1 is asked for on a level of this size. */
bool wants_inf_sup(const Choice choice, const unsigned long long n_dofs)
{
  return choice == Choice::yes ||
         (choice == Choice::automatic && n_dofs <= largest_automatic_inf_sup);
}

/** The bound is asked for where the study may stop. */
bool wants_bound(const DiscretizationParameters &given, const unsigned int level)
{
  return level == given.finest_level || given.target_error > 0.;
}

/** P of the dual problem, which C P and C_kk P_k go with. */
struct Pressure
{
  dealii::Vector<double> P, C_P, diagonal_P;
  /** Empty where nothing touches. */
  std::shared_ptr<const ComplianceOperator> C;
  /** F of the last correct_rounding(). */
  dealii::Vector<double> corrected_F;
};

template <int dim>
QPResult solve_contact(const std::shared_ptr<const ComplianceOperator> &C,
                       const dealii::Vector<double> &F,
                       const dealii::Vector<double> &start,
                       const Parameters &parameters,
                       const Discretization<dim> &discretization)
{
  const SolverParameters &solver = parameters.solver;
  return solve_dual_problem(C,
                            F,
                            start,
                            {solver.contact_solver,
                             solver.relaxation,
                             solver.tolerance,
                             solver.maximum_iterations,
                             discretization.surface.has_unstable_patch()});
}

/** C and P: only where something touches. */
template <int dim>
Pressure find_pressure(const Parameters &parameters,
                       const Discretization<dim> &discretization,
                       const StiffnessInverse &inverse,
                       const PatchPressure &start,
                       const Progress &progress,
                       LevelSolution<dim> &solution)
{
  const Coupling &D = discretization.condensed_D;
  const auto C = make_compliance(
    inverse, D, solution.record.times.compliance, column_progress(progress, D.n_columns()));
  if (parameters.output.compliance)
    solution.C = C->dense();
  progress("dual problem");
  const StageTimer timer(solution.record.times.qp);
  dealii::Vector<double> P_start;
  if (!start.patches.empty())
    P_start = transfer_pressure(start, discretization.surface.patches());
  const QPResult result = solve_contact(C, solution.F, P_start, parameters, discretization);
  solution.record.dual = summary_of(result, parameters.solver.contact_solver);
  return {result.P, C->apply(result.P), diagonal_times(*C, result.P), C, {}};
}

/**
 * Openings by U and by C differ where rounding has spoilt C: D^T U - G is C P - F + r. Then F - r
 * takes the place of F, up to three times. Only what rounding has done is corrected: without it r
 * is zero, however P was found.
 */
template <int dim>
void correct_rounding(const Parameters &parameters,
                      const Discretization<dim> &discretization,
                      const StiffnessInverse &inverse,
                      const DistributedVector &f,
                      Pressure &pressure,
                      LevelSolution<dim> &solution)
{
  constexpr unsigned int most_passes = 3;
  constexpr double negligible = 1e-10;
  const double measure = discretization.multipliers.integrals().l2_norm();
  for (unsigned int pass = 0; pass < most_passes; ++pass)
  {
    dealii::Vector<double> W = discretization.D.transpose_product(solution.U);
    W -= discretization.G;
    dealii::Vector<double> corrected_F(pressure.C_P);
    corrected_F -= W;
    dealii::Vector<double> r(corrected_F);
    r -= pass == 0 ? solution.F : pressure.corrected_F;
    if (r.l2_norm() <= negligible * measure * solution.U.linfty_norm())
      return;
    pressure.corrected_F = corrected_F;
    const QPResult result =
      solve_contact(pressure.C, corrected_F, pressure.P, parameters, discretization);
    solution.record.dual = summary_of(result, parameters.solver.contact_solver);
    pressure.P = result.P;
    pressure.C_P = pressure.C->apply(result.P);
    pressure.diagonal_P = diagonal_times(*pressure.C, result.P);
    solution.U = recover_displacement(
      inverse, discretization.space, discretization.condensed_D, pressure.P, f);
  }
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
} // namespace

template <int dim>
LevelSolution<dim> solve_level(const Parameters &parameters,
                               const Scene<dim> &scene,
                               const Discretization<dim> &discretization,
                               const PatchPressure &start,
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

  const StageTimer timer(times.postprocess);
  if (wants_inf_sup(parameters.output.inf_sup_constant, space.dofs().n_dofs()))
  {
    progress("inf-sup constant");
    record.inf_sup = measure_inf_sup(space,
                                     discretization.multipliers,
                                     discretization.condensed_D,
                                     parameters.solver.linear_solver);
  }
  progress("certificate");
  record.contact = summarise_contact(discretization.multipliers, solution.P);
  const NodalForces forces =
    nodal_forces(space, scene, system.loads, discretization.D, solution.U, solution.P);
  record.certificate = certify(space,
                               scene,
                               system,
                               discretization.multipliers,
                               discretization.D,
                               ContactSolution<dim>{solution.U,
                                                    free.U,
                                                    solution.P,
                                                    solution.F,
                                                    discretization.G,
                                                    pressure.C_P,
                                                    pressure.diagonal_P},
                               forces);
  record.answer =
    compute_answer(space, scene, discretization.multipliers, forces, solution.U, solution.P);
  if (discretization.mesh.has_parents())
    record.estimate = estimate_error(space,
                                     scene,
                                     solution.U,
                                     correct_pressure({space,
                                                       scene,
                                                       discretization.multipliers,
                                                       free.U,
                                                       solution.P,
                                                       discretization.condensed_D,
                                                       *inverse,
                                                       discretization.n_points,
                                                       dual_problem(*inverse)}));
  if (wants_bound(parameters.discretization, record.sizes.level))
  {
    progress("bound of the error");
    add_bound(scene, discretization, *inverse, solution);
  }
  return solution;
}

template LevelSolution<2> solve_level(const Parameters &,
                                      const Scene<2> &,
                                      const Discretization<2> &,
                                      const PatchPressure &,
                                      const Progress &);
} // namespace Signorini
