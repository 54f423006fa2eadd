// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/results/verdict/level_result.h>
#include <signorini/solvers/methods/contact_method.h>

#include <functional>

namespace Signorini {
/** A scene, and the solvers of a level. */
template <int dim>
struct LevelProblem {
  const Parameters &parameters;
  const Scene<dim> &scene;
  SolverChoice solvers;
};

/**
 * Solves (5) on one level and examines the solution: contact by the chosen method, the
 * certificate, the answer and the estimate of the error. Collective.
 */
template <int dim>
LevelSolution<dim> solve_level(const LevelProblem<dim> &problem,
                               const Discretization<dim> &discretization, const ContactStart &start,
                               const Progress &progress);

/** Adds the known facts about other solutions with Coulomb's friction, in 2-D. Collective. */
template <int dim>
void add_other_solutions(const Discretization<dim> &discretization, LevelSolution<dim> &solution);

/** Adds the bound of the error of a 2-D body, or says why there is none. Collective.
 * @param keeps_stress whether a graded level keeps its stress (LevelSolution::reference). */
template <int dim>
void add_bound(const Parameters &parameters, const Discretization<dim> &discretization,
               const Progress &progress, LevelSolution<dim> &solution, bool keeps_stress = false);

/** Releases the operators, which take most of the memory, unless load cases or files need them. */
template <int dim>
void release_unused(const LevelProblem<dim> &problem, LevelSolution<dim> &solution);

/** A callback that adds numbers to the record of a solved level which its solution alone does not
 * give, such as errors against an exact solution. Collective. */
template <int dim>
using Verify = std::function<void(const Discretization<dim> &discretization,
                                  const Progress &progress, LevelSolution<dim> &solution)>;
} // namespace Signorini
