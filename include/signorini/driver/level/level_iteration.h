// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/discretization/elasticity/linear_system.h>
#include <signorini/driver/level/level_pressure.h>
#include <signorini/solvers/multigrid/stiffness_multigrid.h>

namespace Signorini
{
/**
 * The parameters of a level on one or several ranks: what Contact solver = automatic stands for
 * there. It is multigrid, with the linear solver of that name, where
 *
 * - the linear solver is automatic or multigrid, there is one rank, and meshes are nested,
 * - there are no load cases, plates, bodies that contact alone holds, Output/Compliance, B-bar
 *   elements, or patches of a single face, for which V-cycles cannot be used or are slow,
 * - the level has at least 1e5 unknowns, in space 5000, or the linear solver is multigrid;
 *
 * else active set.
 */
template <int dim>
Parameters parameters_of_level(const Parameters &parameters,
                               const Scene<dim> &scene,
                               unsigned int level,
                               unsigned int n_ranks);

/** Whether contact is found by V-cycles, without F, C and a dual problem. */
inline bool iterates_contact(const Parameters &parameters)
{
  return parameters.solver.contact_solver == ContactSolver::multigrid;
}

/** Whether A is neither assembled nor factorised. */
inline bool uses_multigrid(const Parameters &parameters)
{
  return parameters.solver.linear_solver == LinearSolver::multigrid || iterates_contact(parameters);
}

/** How exactly the linear systems behind the estimate of the error are solved where contact is
 * found by V-cycles. */
constexpr double goal_of_estimates = 1e-4;

/** P and U by V-cycles. C P is missing in the result. @throws InputError for bodies and plates that
 * move freely. */
template <int dim>
Pressure iterate_contact(const Parameters &parameters,
                         const Discretization<dim> &discretization,
                         const LinearSystem<dim> &system,
                         const StiffnessOperator &A,
                         const MotionModes<dim> &modes,
                         const LevelStart &start,
                         LevelSolution<dim> &solution);
} // namespace Signorini
