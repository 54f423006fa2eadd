// SPDX-License-Identifier: LGPL-2.1-or-later
// Contact by V-cycles, each followed by a problem on the boundary.

#include <signorini/base/columns.h>
#include <signorini/base/errors.h>
#include <signorini/driver/level/level_iteration.h>
#include <signorini/solvers/cycles/contact_iteration.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
namespace
{
/** t grows a little from level to level. */
constexpr double growth_of_scale = 1.05;
/** Of the error of the discretisation. */
constexpr double share_of_discretisation_error = 0.1;
/** Where MINRES needs more than that, a factorisation is the better choice. */
constexpr unsigned int most_cycles = 1000;
/** Between the tolerances of stationarity and of the KKT residual. */
constexpr double stationarity_per_tolerance = 10.;

/** Unknowns from which V-cycles are faster than a factorisation. */
constexpr double fewest_unknowns(const unsigned int dim)
{
  return dim == 2 ? 1e5 : 5e3;
}

/** Whether nothing but the size speaks against V-cycles. */
template <int dim>
bool may_iterate(const Parameters &parameters, const Scene<dim> &scene, const unsigned int n_ranks)
{
  const DiscretizationParameters &discretization = parameters.discretization;
  const bool solver_fits = parameters.solver.linear_solver == LinearSolver::automatic ||
                           parameters.solver.linear_solver == LinearSolver::multigrid;
  return solver_fits && n_ranks == 1 && discretization.strategy == Strategy::nested &&
         discretization.element == Element::q1 && discretization.patch_ratio > 1 &&
         discretization.patches == 0 && !parameters.output.compliance && scene.load_cases.empty() &&
         scene.plates.empty() && !scene.is_held_by_contact;
}

/** Nodal values without those of constrained rows; zero where there are none. */
template <int dim>
NodalVector free_part(const DisplacementSpace<dim> &space, const NodalVector &U)
{
  if (U.size() == 0)
    return NodalVector(space.dofs().n_dofs());
  NodalVector free(U);
  for (const auto &line : space.constraints().get_lines())
    free[line.index] = 0.;
  return free;
}

/** U = T U_free + k. */
template <int dim>
NodalVector complete_free_part(const DisplacementSpace<dim> &space, const NodalVector &U_free)
{
  DistributedVector free = space.make_vector();
  for (const auto i : space.locally_owned())
    free(i) = U_free[i];
  free.compress(dealii::VectorOperation::insert);
  return space.complete(free);
}

/**
 * The algebraic error that does not matter beside that of the discretisation, relative in the
 * energy norm. u_h has about half the error of the level before, and pi^{2h} u_h, which gains an
 * order where the solution is smooth, not less than the square of that.
 */
double energy_tolerance(const Parameters &parameters, const LevelStart &start)
{
  if (parameters.solver.stop_at != StopAt::discretisation_error || !start.relative_error)
    return 0.;
  const double before = *start.relative_error;
  return share_of_discretisation_error * std::min(0.25 * before, before * before);
}
} // namespace

template <int dim>
Parameters parameters_of_level(const Parameters &parameters,
                               const Scene<dim> &scene,
                               const unsigned int level,
                               const unsigned int n_ranks)
{
  Parameters resolved = parameters;
  Given<ContactSolver> &solver = resolved.solver.contact_solver;
  const double n_unknowns = dim * scene.geometry.n_coarse_cells * std::pow(2., double(dim) * level);
  const bool many = n_unknowns >= fewest_unknowns(dim) ||
                    parameters.solver.linear_solver == LinearSolver::multigrid;
  if (solver == ContactSolver::automatic)
    solver.value = many && may_iterate(parameters, scene, n_ranks) ? ContactSolver::multigrid
                                                                   : ContactSolver::active_set;
  if (solver == ContactSolver::multigrid)
    resolved.solver.linear_solver.value = LinearSolver::multigrid;
  return resolved;
}

template Parameters
parameters_of_level(const Parameters &, const Scene<2> &, unsigned int, unsigned int);
template Parameters
parameters_of_level(const Parameters &, const Scene<3> &, unsigned int, unsigned int);

template <int dim>
Pressure iterate_contact(const Parameters &parameters,
                         const Discretization<dim> &discretization,
                         const LinearSystem<dim> &system,
                         const StiffnessOperator &A,
                         const MotionModes<dim> &modes,
                         const LevelStart &start,
                         LevelSolution<dim> &solution)
{
  const SolverParameters &solver = parameters.solver;
  if (modes.size() > 0 || !modes.unseen.empty())
    throw InputError(solver.contact_solver.where() + ": found '" +
                     to_text(solver.contact_solver.value) +
                     "' for a body or a plate that moves freely, allowed there: psor, active set.");
  const StageTimer timer(solution.record.times.qp);
  const DisplacementSpace<dim> &space = discretization.space;
  const auto model = make_boundary_model(discretization.multipliers);
  const NodalVector f(system.f);
  dealii::Vector<double> gap(discretization.G);
  gap -= discretization.D.transpose_product(space.prescribed(discretization.surface.scene()));
  ContactIterationOptions options;
  options.tolerance = solver.tolerance;
  options.stationarity = stationarity_per_tolerance * solver.tolerance;
  options.maximum_cycles = std::min<unsigned int>(solver.maximum_iterations, most_cycles);
  options.scale = growth_of_scale * start.scale;
  options.energy_tolerance = energy_tolerance(parameters, start);
  const ContactIterationResult result =
    solve_contact_by_cycles({A,
                             f,
                             discretization.condensed_D,
                             gap,
                             *model,
                             space.condense(NodalVector(system.loads)).l2_norm()},
                            free_part(space, start.U),
                            start.P.size() > 0 ? start.P : dealii::Vector<double>(gap.size()),
                            options);

  solution.P = result.P;
  solution.U = complete_free_part(space, result.U);
  solution.F = discretization.G;
  solution.contact_scale = result.scale;
  solution.energy_of_residual = result.energy_of_residual;
  DualSolve &dual = solution.record.dual;
  dual.method = ContactSolver::multigrid;
  dual.iterations = result.cycles + result.cycles_for_scale;
  dual.kkt = result.kkt_residual;
  dual.converged = result.converged;
  dual.stalled = result.stalled;
  dual.energy_tolerance = options.energy_tolerance;
  dealii::Vector<double> diagonal = model->diagonal(), diagonal_P(result.P);
  diagonal *= result.scale;
  diagonal_P.scale(diagonal);
  dealii::Vector<double> W = discretization.D.transpose_product(solution.U);
  W -= discretization.G;
  solution.algebraic_error = std::hypot(algebraic_error(result.P, W, diagonal),
                                        std::sqrt(2. * std::abs(result.energy_of_residual)));
  return {result.P, {}, diagonal_P, nullptr, {}};
}

template Pressure iterate_contact(const Parameters &,
                                  const Discretization<2> &,
                                  const LinearSystem<2> &,
                                  const StiffnessOperator &,
                                  const MotionModes<2> &,
                                  const LevelStart &,
                                  LevelSolution<2> &);
template Pressure iterate_contact(const Parameters &,
                                  const Discretization<3> &,
                                  const LinearSystem<3> &,
                                  const StiffnessOperator &,
                                  const MotionModes<3> &,
                                  const LevelStart &,
                                  LevelSolution<3> &);
} // namespace Signorini
