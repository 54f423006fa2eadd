// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/problem/parameters/parameters.h>
#include <signorini/problem/scene/scene.h>

namespace Signorini {
/** Returns the number of equal patches that a scene states; zero where patches are groups of faces.
 */
template <int dim>
unsigned int n_given_patches(const Scene<dim> &scene);

/** Returns the largest ratio of the lengths of two edges of a cell. Refined cells keep it: it
 * decides how well V-cycles contract. */
template <int dim>
double largest_aspect(const Triangulation<dim> &mesh);

/** The solvers of a level, after Contact solver = automatic is resolved. */
struct SolverChoice {
  ContactSolver contact = ContactSolver::active_set;
  LinearSolver linear = LinearSolver::automatic;

  /** Returns whether V-cycles find contact, without F, C and a dual problem. */
  bool is_by_cycles() const {
    return contact == ContactSolver::multigrid;
  }
  /** Returns whether A is neither assembled nor factorised. */
  bool is_matrix_free() const {
    return linear == LinearSolver::multigrid;
  }
};

/**
 * Chooses the solvers of a level. Contact solver = automatic is multigrid, with the linear solver
 * of that name, where
 *
 * - the linear solver is automatic or multigrid, and meshes are nested,
 * - there are no load cases, plates, bodies that contact alone holds, Output/Compliance, B-bar
 *   elements, or patches of a single face, for which V-cycles cannot be used or are slow,
 * - the level has at least 1e5 unknowns (in 3-D 5000, unless cells are longer than ten times their
 *   width), or the linear solver is multigrid;
 *
 * else active set. That takes columns of C by V-cycles where a body or a plate in space moves
 * freely, or there are load cases, from 1e5 unknowns on.
 */
template <int dim>
SolverChoice choose_solvers(const Parameters &parameters, const Scene<dim> &scene,
                            unsigned int level);

/** Returns whether several ranks share a level with these solvers; else every rank solves it alone.
 * V-cycles and amesos_mumps are there for shared levels of one body without friction, plates and
 * load cases, where every rank gets at least eight subtrees of 4^dim cells. A bound needs the whole
 * body.
 */
template <int dim>
bool is_shared(const Parameters &parameters, const Scene<dim> &scene, const SolverChoice &solvers,
               unsigned int level, unsigned int n_ranks);
} // namespace Signorini
