// SPDX-License-Identifier: LGPL-2.1-or-later
// One level, from the mesh to the certified answer.

#include <signorini/base/exceptions.h>
#include <signorini/base/stage_timer.h>
#include <signorini/base/text.h>
#include <signorini/compliance/compliance.h>
#include <signorini/postprocess/inf_sup.h>
#include <signorini/qp/active_set.h>
#include <signorini/qp/growing_set.h>
#include <signorini/qp/psor.h>
#include <signorini/recovery/recovery.h>
#include <signorini/study/level.h>

#include <deal.II/lac/exceptions.h>

#include <algorithm>
#include <sstream>

namespace Signorini
{
namespace
{
template <int dim>
MultiplierSpace<dim> make_multiplier_space(const DiscretizationParameters &parameters,
                                           const Scene<dim> &scene,
                                           const Mesh<dim> &mesh)
{
  std::vector<ContactFace<dim>> faces = find_contact_faces(mesh, scene);
  ContactPartition partition = parameters.patches > 0
                                 ? partition_equally(faces, parameters.patches)
                                 : partition_by_ratio(faces, parameters.patch_ratio);
  return MultiplierSpace<dim>(scene, std::move(faces), std::move(partition));
}

/** On coarse meshes the data varies much from cell to cell, and accurate integrals cost nothing. */
unsigned int additional_points(const unsigned int n_cells)
{
  return n_cells <= 64 ? 6 : (n_cells <= 1024 ? 3 : 0);
}

StrainOperator strain_operator(const std::string &element)
{
  return element == "Q1 B-bar" ? StrainOperator::mean_dilatation
                               : StrainOperator::symmetric_gradient;
}

/** C is singular anyway where patches are finer than faces; those that are far finer even on the
 * finest level only cost time. */
constexpr unsigned int most_patches_per_face = 4;

template <int dim>
void refuse_needless_patches(const Parameters &parameters,
                             const unsigned int level,
                             const MultiplierSpace<dim> &multipliers)
{
  const unsigned int finer = std::max(parameters.discretization.finest_level, level) - level;
  const std::size_t n_faces = multipliers.faces().size() << ((dim - 1) * finer);
  const std::size_t n_patches = multipliers.partition().patches.size();
  if (n_patches > most_patches_per_face * n_faces)
    throw InputError(parameters.where("Discretization/Patches") + ": found " +
                     std::to_string(n_patches) + " patches on the " + std::to_string(n_faces) +
                     " contact faces of the finest level, allowed: at most " +
                     std::to_string(most_patches_per_face) + " per face.");
}

/** A patch without a free node next to it cannot feel or do anything. */
void refuse_blind_patches(const Parameters &parameters, const Coupling &condensed_D)
{
  for (unsigned int tau = 0; tau < condensed_D.n_columns(); ++tau)
    if (condensed_D.column(tau).empty())
      throw InputError(parameters.where("Discretization/Coarsest level") + ": contact patch " +
                       std::to_string(tau) +
                       " sees no free mesh node on the coarsest level, allowed: a finer coarsest "
                       "level, fewer patches or a larger patch ratio.");
}

/** F >= 0: P = 0 solves the dual problem, and C is not needed. */
bool nothing_touches(const dealii::Vector<double> &F)
{
  return std::none_of(F.begin(), F.end(), [](const double opening) { return opening < 0.; });
}

/** What went wrong, in half a sentence. */
std::string message_of(const dealii::ExceptionBase &exception)
{
  if (dynamic_cast<const dealii::LACExceptions::ExcSingular *>(&exception) != nullptr)
    return "the compliance of the patches in contact is singular";
  std::ostringstream text;
  exception.print_info(text);
  return one_line(trim(text.str()));
}

/** Says in @p record if not the chosen solver answers. */
QPResult solve_dual_problem(const SolverParameters &parameters,
                            const BoundConstrainedQP &qp,
                            const dealii::Vector<double> &start,
                            DualSolve &record)
{
  record.active_set_failure.reset();
  const auto by_psor = [&]() {
    return solve_by_psor(
      qp,
      start.size() > 0 ? start : dealii::Vector<double>(qp.size()),
      {parameters.relaxation, parameters.tolerance, parameters.maximum_iterations});
  };
  if (parameters.contact_solver == "psor")
    return by_psor();
  try
  {
    return solve_by_active_set(qp, start, {parameters.tolerance, parameters.maximum_iterations});
  }
  catch (const dealii::ExceptionBase &exception)
  {
    record.active_set_failure = message_of(exception);
    // Patches finer than the mesh make C singular: many pressures give the same displacement, and
    // sweeps find one of them where no factorisation can.
    return by_psor();
  }
}

template <int dim>
void describe_discretization(const Discretization<dim> &discretization, LevelRecord &record)
{
  const ContactPartition &partition = discretization.multipliers.partition();
  record.sizes.level = discretization.mesh.level();
  record.sizes.cells = discretization.mesh.triangulation().n_global_active_cells();
  record.sizes.dofs = discretization.space.dofs().n_dofs();
  record.sizes.multipliers = partition.patches.size();
  record.sizes.h = discretization.mesh.longest_edge();
  record.sizes.H = partition.longest_patch();
  record.sizes.unstable = partition.has_unstable_patch();
  record.times = discretization.times;
}

/**
 * C and P, only where something touches. Where every column of C costs a solve, the active set
 * method asks for those of patches that can touch; projected SOR needs them all.
 */
template <int dim>
QPResult find_pressure(const Parameters &parameters,
                       const Discretization<dim> &discretization,
                       const StiffnessInverse &inverse,
                       const dealii::Vector<double> &P_start,
                       const Progress &progress,
                       LevelSolution<dim> &solution)
{
  const DisplacementSpace<dim> &space = discretization.space;
  const Coupling &D = discretization.condensed_D;
  const unsigned int every = std::max(1U, D.n_columns() / 20);
  const auto column_done = [&](const unsigned int done) {
    if (done % every == 0)
      progress("compliance: " + std::to_string(done) + " columns, up to " +
               std::to_string(D.n_columns()));
  };
  const bool may_be_singular = discretization.multipliers.partition().has_unstable_patch();
  const QPSolver solve = [&](const BoundConstrainedQP &qp, const dealii::Vector<double> &start) {
    QPResult result = solve_dual_problem(parameters.solver, qp, start, solution.record.dual);
    result.unique = !may_be_singular || qp.has_unique_solution(result.P);
    return result;
  };
  if (!holds_compliance(inverse, D) && parameters.solver.contact_solver != "psor" &&
      !parameters.output.compliance)
    return solve_on_growing_set(
      solution.F,
      P_start,
      [&](const std::vector<unsigned int> &columns, dealii::FullMatrix<double> &C) {
        const StageTimer timer(solution.record.times.compliance);
        compute_compliance_columns(inverse, space, D, columns, C, column_done);
      },
      solve,
      solution.C);
  solution.C = timed(solution.record.times.compliance,
                     [&]() { return compute_compliance(inverse, space, D, column_done); });
  progress("dual problem");
  return solve(BoundConstrainedQP(solution.C, solution.F), P_start);
}

/** P and C in units of @p unit, with what the table says about them. */
template <int dim>
void solve_contact(const Parameters &parameters,
                   const Discretization<dim> &discretization,
                   const StiffnessInverse &inverse,
                   const double unit,
                   const StartingPressure &start,
                   const Progress &progress,
                   LevelSolution<dim> &solution)
{
  const StageTimer timer(solution.record.times.qp);
  dealii::Vector<double> P_start;
  if (!start.patches.empty())
  {
    P_start =
      transfer_pressure(start.patches, start.P, discretization.multipliers.partition().patches);
    P_start /= unit;
  }
  const QPResult result =
    find_pressure(parameters, discretization, inverse, P_start, progress, solution);
  solution.P = result.P;
  DualSolve &dual = solution.record.dual;
  dual.iterations = result.iterations;
  if (parameters.solver.contact_solver == "psor")
    dual.increment_iterations = result.increment_iterations;
  dual.kkt = result.kkt_residual;
  dual.converged = result.converged;
  dual.unique = result.unique;
}

/** The limit of Inf-sup constant = automatic: it needs a factorisation of its own. */
constexpr unsigned int largest_automatic_inf_sup = 100000;

/** Whether the constant of Lemma 1 is asked for on a level of this size. */
bool wants_inf_sup(const std::string &choice, const unsigned long long n_dofs)
{
  return choice == "true" || (choice == "automatic" && n_dofs <= largest_automatic_inf_sup);
}

/** What the answer amounts to, how good it is. */
template <int dim>
void describe_answer(const Scene<dim> &scene,
                     const Discretization<dim> &discretization,
                     const LinearSystem<dim> &system,
                     const NodalVector &free_U,
                     LevelSolution<dim> &solution)
{
  LevelRecord &record = solution.record;
  record.contact = summarise_contact(discretization.multipliers, solution.P);
  record.certificate = certify(
    discretization.space,
    scene,
    system,
    discretization.multipliers,
    discretization.D,
    ContactSolution<dim>{solution.U, free_U, solution.P, solution.F, discretization.G, solution.C});
  if (discretization.mesh.has_parents())
    record.estimate = estimate_error(discretization.space, solution.U);
}
} // namespace

template <int dim>
Discretization<dim>::Discretization(const Parameters &parameters,
                                    const Scene<dim> &scene,
                                    const unsigned int level,
                                    MPI_Comm communicator)
  : mesh(timed(times.mesh,
               [&]() {
                 return Mesh<dim>(
                   scene.geometry, parameters.discretization.coarsest_level, level, communicator);
               }))
  , n_points(parameters.discretization.quadrature_points +
             additional_points(mesh.triangulation().n_active_cells()))
  , space(timed(times.setup,
                [&]() {
                  return DisplacementSpace<dim>(
                    mesh, scene, strain_operator(parameters.discretization.element));
                }))
  , multipliers(
      timed(times.setup,
            [&]() { return make_multiplier_space(parameters.discretization, scene, mesh); }))
  , D(timed(
      times.setup,
      [&]() { return assemble_coupling(space, multipliers.faces(), multipliers.partition()); }))
  , condensed_D(timed(times.setup, [&]() { return condense(D, space.constraints()); }))
  , G(timed(times.setup, [&]() { return assemble_gap(multipliers, n_points); }))
{
  refuse_blind_patches(parameters, condensed_D);
  refuse_needless_patches(parameters, level, multipliers);
  if (parameters.solver.require_stability && multipliers.partition().has_unstable_patch())
    throw InputError(parameters.where("Solver/Require stability") +
                     ": a contact patch is no longer than a face (H = h), which is not inf-sup "
                     "stable, allowed: a Patch ratio of at least 2 and levels on which every side "
                     "has at least two faces per patch.");
}

template <int dim>
LevelSolution<dim> solve_level(const Parameters &parameters,
                               const Scene<dim> &scene,
                               const Discretization<dim> &discretization,
                               const StartingPressure &start,
                               const Progress &progress)
{
  const DisplacementSpace<dim> &space = discretization.space;
  LevelSolution<dim> solution;
  StageTimes &times = solution.record.times;
  describe_discretization(discretization, solution.record);

  progress("assembly");
  const LinearSystem<dim> system = timed(times.assembly, [&]() {
    return assemble_linear_system(space, scene, discretization.n_points);
  });

  progress("factorisation");
  const auto inverse = timed(times.factor, [&]() {
    return factorise(
      system.A, parameters.solver.linear_solver, contact_unknowns(discretization.condensed_D));
  });

  const FreeState free = timed(times.compliance, [&]() {
    return solve_free_state(*inverse, space, system.f, discretization.D, discretization.G);
  });
  solution.F = free.F;
  solution.P.reinit(discretization.multipliers.n_multipliers());
  if (nothing_touches(free.F))
    solution.U = free.U;
  else
  {
    solve_contact(parameters, discretization, *inverse, system.unit, start, progress, solution);
    const StageTimer timer(times.recovery);
    solution.U =
      recover_displacement(*inverse, space, discretization.condensed_D, solution.P, system.f);
    solution.P *= system.unit;
    solution.C /= system.unit;
  }

  solution.loads = system.loads;
  solution.record.linear = {
    inverse->n_solves(), inverse->largest_residual(), inverse->rounding_error()};

  timed(times.postprocess, [&]() {
    if (wants_inf_sup(parameters.output.inf_sup_constant, space.dofs().n_dofs()))
    {
      progress("inf-sup constant");
      solution.record.inf_sup = measure_inf_sup(space,
                                                scene,
                                                discretization.multipliers,
                                                discretization.condensed_D,
                                                parameters.solver.linear_solver);
    }
    progress("certificate");
    describe_answer(scene, discretization, system, free.U, solution);
  });
  return solution;
}

template struct Discretization<2>;
template LevelSolution<2> solve_level(const Parameters &,
                                      const Scene<2> &,
                                      const Discretization<2> &,
                                      const StartingPressure &,
                                      const Progress &);
} // namespace Signorini
