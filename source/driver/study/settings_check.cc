// SPDX-License-Identifier: LGPL-2.1-or-later
// What parameters, scene and ranks can contradict each other in, found before the first level.

#include "settings_check.h"

#include <signorini/base/errors.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <vector>

namespace Signorini
{
namespace
{
/** Both solvers know other names for several processes. */
template <typename Option>
void require_one_rank(const Given<Option> &solver,
                      const std::vector<Option> &on_one_rank,
                      const unsigned int n_ranks)
{
  const auto needs_one_rank = [&](const Option value) {
    return std::find(on_one_rank.begin(), on_one_rank.end(), value) != on_one_rank.end();
  };
  if (!needs_one_rank(solver) || n_ranks == 1)
    return;
  std::string allowed;
  for (const auto &[other, name] : option_names<Option>())
    if (!needs_one_rank(other))
      allowed += (allowed.empty() ? "" : ", ") + name;
  throw InputError(solver.where() + ": found '" + to_text(solver.value) + "' on " +
                   std::to_string(n_ranks) + " processes, allowed on several: " + allowed + ".");
}

template <int dim>
void check_strategy(const Given<Strategy> &strategy, const unsigned int n_ranks)
{
  if (strategy == Strategy::hp && !can_be_graded<dim>(n_ranks))
    throw InputError(strategy.where() + ": found '" + to_text(strategy.value) + "' on " +
                     std::to_string(n_ranks) +
                     " processes, allowed on several: " + to_text(Strategy::nested) + ".");
}

/** V-cycles for contact come with a linear solver of V-cycles, and know one load only. */
template <int dim>
void check_contact_solver(const Parameters &parameters, const Scene<dim> &scene)
{
  const Given<ContactSolver> &solver = parameters.solver.contact_solver;
  const Given<LinearSolver> &linear = parameters.solver.linear_solver;
  if (solver != ContactSolver::multigrid)
    return;
  if (linear != LinearSolver::multigrid && linear != LinearSolver::automatic)
    throw InputError(linear.where() + ": found '" + to_text(linear.value) +
                     "' with Contact solver '" + to_text(solver.value) +
                     "', allowed with it: automatic, multigrid.");
  if (!scene.load_cases.empty())
    throw InputError(solver.where() + ": found '" + to_text(solver.value) +
                     "' with load cases, allowed with them: psor, active set.");
}

/** Multigrid needs nested meshes, and has no matrix to write. */
template <typename Option>
void check_multigrid(const Given<Option> &solver,
                     const std::string &name,
                     const std::string &allowed,
                     const Parameters &parameters)
{
  if (solver != Option::multigrid)
    return;
  const Given<Strategy> &strategy = parameters.discretization.strategy;
  if (strategy == Strategy::hp)
    throw InputError(solver.where() + ": found '" + to_text(solver.value) + "' with Strategy '" +
                     to_text(strategy.value) + "', allowed with it: " + allowed + ".");
  const Given<Element> &element = parameters.discretization.element;
  if (element == Element::q2)
    throw InputError(solver.where() + ": found '" + to_text(solver.value) + "' with Element '" +
                     to_text(element.value) + "', allowed with it: " + allowed + ".");
  if (parameters.output.compliance)
    throw InputError(parameters.output.compliance.where() + ": found 'true' with " + name + " '" +
                     to_text(solver.value) +
                     "', which assembles no matrix, allowed with it: false.");
}

/** Other scenes number their boundary on level 0. */
void check_coarsest_level(const Given<unsigned int> &coarsest_level, const Geometry<2> &geometry)
{
  if (!geometry.number_after_refinement)
    return;
  dealii::Triangulation<2> mesh;
  geometry.make_coarse_mesh(mesh);
  mesh.refine_global(coarsest_level);
  if (ends_inside_a_face(geometry.sides, mesh))
    throw InputError(coarsest_level.where() +
                     ": a side of this scene ends inside a face of the mesh, allowed: a finer "
                     "coarsest level.");
}
} // namespace

template <int dim>
void check_settings(const Parameters &parameters, const Scene<dim> &scene, MPI_Comm communicator)
{
  const unsigned int n_ranks = dealii::Utilities::MPI::n_mpi_processes(communicator);
  require_one_rank(
    parameters.solver.linear_solver, {LinearSolver::condensed, LinearSolver::multigrid}, n_ranks);
  require_one_rank(parameters.solver.contact_solver, {ContactSolver::multigrid}, n_ranks);
  check_strategy<dim>(parameters.discretization.strategy, n_ranks);
  check_contact_solver(parameters, scene);
  check_multigrid(
    parameters.solver.linear_solver, "Linear solver", "automatic, condensed", parameters);
  check_multigrid(
    parameters.solver.contact_solver, "Contact solver", "psor, active set, mprgp", parameters);
  if constexpr (dim == 2)
    check_coarsest_level(parameters.discretization.coarsest_level, scene.geometry);
}

template void check_settings(const Parameters &, const Scene<2> &, MPI_Comm);
template void check_settings(const Parameters &, const Scene<3> &, MPI_Comm);
} // namespace Signorini
