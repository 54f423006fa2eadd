// SPDX-License-Identifier: LGPL-2.1-or-later
// The choice of the method that finds contact.

#include <signorini/base/instantiate.h>
#include <signorini/discretization/mesh/mesh.h>
#include <signorini/solvers/methods/solver_choice.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace Signorini {
namespace {
/** Returns whether the coarse mesh has many inner vertices at which not four cells meet, like one
 * of split triangles. */
bool is_irregular(const Geometry<2> &geometry) {
  constexpr int many = 50;
  Triangulation<2> mesh;
  geometry.make_coarse_mesh(mesh);
  // Vertices of the boundary have fewer cells.
  std::vector<unsigned int> n_cells(mesh.n_vertices(), 0);
  for (const auto &cell : mesh.active_cell_iterators())
    for (const unsigned int v : cell->vertex_indices())
      ++n_cells[cell->vertex_index(v)];
  for (const auto &face : mesh.active_face_iterators())
    if (face->at_boundary())
      for (const unsigned int v : face->vertex_indices())
        n_cells[face->vertex_index(v)] = 4;
  return std::count_if(n_cells.begin(), n_cells.end(),
                       [](const unsigned int n) { return n != 4; }) > many;
}

/** Returns whether the coarse mesh has cells for which V-cycles contract badly: contact is then
 * left to MINRES, which takes a thousand steps. */
bool is_irregular(const Geometry<3> &geometry) {
  constexpr double long_cell = 10.;
  Triangulation<3> mesh;
  geometry.make_coarse_mesh(mesh);
  return largest_aspect(mesh) > long_cell;
}

/** Returns whether V-cycles are faster than a factorisation. On irregular meshes contact takes up
 * to eight times as many of them: there they save memory only. */
template <int dim>
bool cycles_are_faster(const Geometry<dim> &geometry, const double n_unknowns) {
  constexpr double fewest = dim == 2 ? 1e5 : 5e3;
  return n_unknowns >= 20. * fewest || (n_unknowns >= fewest && !is_irregular(geometry));
}

/** Returns whether V-cycles find contact in few steps, whatever the number of unknowns. Their
 * models of C are plane, or in space. */
template <int dim>
bool may_iterate(const Parameters &parameters, const Scene<dim> &scene) {
  const DiscretizationParameters &discretization = parameters.discretization;
  const bool solver_fits = parameters.solver.linear_solver == LinearSolver::automatic ||
                           parameters.solver.linear_solver == LinearSolver::multigrid;
  return solver_fits && discretization.strategy != Strategy::hp &&
         discretization.element == Element::q1 && discretization.patch_ratio > 1 &&
         n_given_patches(scene) == 0 && !parameters.output.compliance && scene.load_cases.empty() &&
         scene.plates.empty() && !scene.is_held_by_contact &&
         !scene.contact_law.has_tangential_part() && !scene.geometry.axisymmetric;
}

/** Returns whether the dual problem of a body or a plate in space that moves freely is solved with
 * columns of C by V-cycles. Factors of a cube with 1.1e5 unknowns take 11 s and 1.5 GB, its 205
 * pressing columns 31 s and 0.3 GB; the times grow like N² and N^{5/3}, the memory like N^{4/3} and
 * N. */
template <int dim>
bool solves_columns_by_cycles(const Parameters &parameters, const Scene<dim> &scene,
                              const double n_unknowns) {
  constexpr double fewest = 1e5;
  return dim == 3 && n_unknowns >= fewest &&
         (!scene.plates.empty() || scene.is_held_by_contact || !scene.load_cases.empty()) &&
         parameters.solver.linear_solver == LinearSolver::automatic &&
         parameters.discretization.element == Element::q1 && !parameters.output.compliance;
}
} // namespace

template <int dim>
double largest_aspect(const Triangulation<dim> &mesh) {
  double largest = 1.;
  for (const auto &cell : mesh.active_cell_iterators()) {
    double shortest = std::numeric_limits<double>::max(), longest = 0.;
    for (const unsigned int l : cell->line_indices()) {
      const double length = cell->line(l)->diameter();
      shortest = std::min(shortest, length);
      longest = std::max(longest, length);
    }
    largest = std::max(largest, longest / shortest);
  }
  return largest;
}

template <int dim>
unsigned int n_given_patches(const Scene<dim> &scene) {
  const std::vector<unsigned int> patches = scene.given_patches();
  return std::accumulate(patches.begin(), patches.end(), 0U);
}

template <int dim>
SolverChoice choose_solvers(const Parameters &parameters, const Scene<dim> &scene,
                            const unsigned int level) {
  const SolverParameters &solver = parameters.solver;
  SolverChoice choice = {solver.contact_solver, solver.linear_solver};
  const double n_unknowns = dim * scene.geometry.n_coarse_cells * std::pow(2., double(dim) * level);
  if (choice.contact == ContactSolver::automatic)
    choice.contact =
      may_iterate(parameters, scene) && (solver.linear_solver == LinearSolver::multigrid ||
                                         cycles_are_faster(scene.geometry, n_unknowns))
        ? ContactSolver::multigrid
        : ContactSolver::active_set;
  if (choice.is_by_cycles() || solves_columns_by_cycles(parameters, scene, n_unknowns))
    choice.linear = LinearSolver::multigrid;
  return choice;
}

template <int dim>
bool is_shared(const Parameters &parameters, const Scene<dim> &scene, const SolverChoice &solvers,
               const unsigned int level, const unsigned int n_ranks) {
  const bool scene_fits = !scene.contact_law.has_tangential_part() && scene.load_cases.empty() &&
                          scene.plates.empty() && !scene.is_held_by_contact &&
                          scene.geometry.can_be_shared && scene.geometry.n_bodies() == 1 &&
                          !scene.has_pairs() && scene.geometry.distortion == 0. &&
                          !parameters.output.compliance && !parameters.output.lemmas;
  const bool solver_fits = solvers.is_matrix_free() || solvers.linear == LinearSolver::amesos_mumps;
  // Below its root a subtree has at least 4^dim cells.
  constexpr unsigned int min_depth = 2;
  return n_ranks > 1 && scene_fits && solver_fits &&
         level >= min_depth + level_of_subtrees(scene.geometry.n_coarse_cells, dim, n_ranks);
}

INSTANTIATE_FUNCTION(largest_aspect);
INSTANTIATE_FUNCTION(n_given_patches);
INSTANTIATE_FUNCTION(choose_solvers);
INSTANTIATE_FUNCTION(is_shared);
} // namespace Signorini
