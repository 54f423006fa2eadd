// SPDX-License-Identifier: LGPL-2.1-or-later
// What parameters, scene and ranks can contradict each other in, found before the first level.

#include "settings_check.h"

#include <signorini/base/exceptions.h>

#include <deal.II/base/mpi.h>

namespace Signorini
{
namespace
{
void check_linear_solver(const Given<LinearSolver> &solver, const unsigned int n_ranks)
{
  const auto needs_one_rank = [](const LinearSolver value) {
    return value == LinearSolver::condensed || value == LinearSolver::multigrid;
  };
  if (!needs_one_rank(solver) || n_ranks == 1)
    return;
  std::string allowed;
  for (const auto &[other, name] : option_names<LinearSolver>())
    if (!needs_one_rank(other))
      allowed += (allowed.empty() ? "" : ", ") + name;
  throw InputError(solver.where() + ": found '" + to_text(solver.value) + "' on " +
                   std::to_string(n_ranks) + " processes, allowed on several: " + allowed + ".");
}

void check_strategy(const Given<Strategy> &strategy, const unsigned int n_ranks)
{
  if (strategy == Strategy::hp && n_ranks > 1)
    throw InputError(strategy.where() + ": found '" + to_text(strategy.value) + "' on " +
                     std::to_string(n_ranks) +
                     " processes, allowed on several: " + to_text(Strategy::nested) + ".");
}

/** Multigrid knows bilinear elements on nested meshes, and has no matrix to write. */
void check_multigrid(const Parameters &parameters)
{
  const Given<LinearSolver> &solver = parameters.solver.linear_solver;
  if (solver != LinearSolver::multigrid)
    return;
  const Given<Strategy> &strategy = parameters.discretization.strategy;
  if (strategy == Strategy::hp)
    throw InputError(solver.where() + ": found '" + to_text(solver.value) + "' with Strategy '" +
                     to_text(strategy.value) +
                     "', allowed with it: " + to_text(LinearSolver::automatic) + ", " +
                     to_text(LinearSolver::condensed) + ".");
  if (parameters.output.compliance)
    throw InputError(parameters.output.compliance.where() + ": found 'true' with Linear solver '" +
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
  check_linear_solver(parameters.solver.linear_solver, n_ranks);
  check_strategy(parameters.discretization.strategy, n_ranks);
  check_multigrid(parameters);
  if constexpr (dim == 2)
    check_coarsest_level(parameters.discretization.coarsest_level, scene.geometry);
}

template void check_settings(const Parameters &, const Scene<2> &, MPI_Comm);
template void check_settings(const Parameters &, const Scene<3> &, MPI_Comm);
} // namespace Signorini
