// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/postprocessing/norms/dual_norm_errors.h>
#include <signorini/results/verdict/level_result.h>
#include <signorini/solvers/methods/contact_method.h>

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

/** Adds the bound of the error, where it is wanted, and releases what nothing needs later.
 * Collective. */
template <int dim>
void finish_level(const LevelProblem<dim> &problem, const Discretization<dim> &discretization,
                  bool wants_bound, const Progress &progress, LevelSolution<dim> &solution);

/**
 * Adds the errors against the exact solution, as far as the scene has one. Collective.
 * @param pressure the exact pressure for the dual norms; null if it is not known, or if they are
 * not wanted.
 */
template <int dim>
void add_errors(const Parameters &parameters, const Scene<dim> &scene,
                const Discretization<dim> &discretization, const ExactPressure<dim> *pressure,
                LevelSolution<dim> &solution);
} // namespace Signorini
