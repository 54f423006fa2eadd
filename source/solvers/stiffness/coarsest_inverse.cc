// SPDX-License-Identifier: LGPL-2.1-or-later
// The inverse on the coarsest level.

#include <signorini/base/errors.h>
#include <signorini/base/instantiate.h>
#include <signorini/solvers/stiffness/coarsest_inverse.h>

#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/solver_control.h>

#include <Epetra_MultiVector.h>

#include <Teuchos_ParameterList.hpp>
#include <memory>
#include <utility>
#include <vector>

#include "point_kernel.h"

namespace Signorini {
namespace {
/** The largest number of unknowns in space that is factorised: beyond it, factors take longer and
 * more memory than cycles (doc/multigrid.md). */
constexpr unsigned int max_factorised_in_space = 5000;

/** The largest number of steps of conjugate gradients: they take some ten. */
constexpr unsigned int max_steps = 500;

ComputationError singular() {
  return ComputationError(
    "The matrix of the coarsest multigrid level is singular, by rounding: the "
    "body is very slender, or its moduli differ much; Solver/Linear solver = "
    "condensed factorises instead.");
}

/** Returns the translations and rotations of a level whose cells are those of the coarse mesh, one
 * after the other. */
template <int dim>
std::vector<double> rigid_motions(const BlockGrid<dim> &grid, const Triangulation<dim> &mesh) {
  const unsigned int n = dim * grid.n_nodes();
  std::vector<double> motions(dim * (dim + 1) / 2 * n);
  for (const auto &cell : mesh.cell_iterators_on_level(0)) {
    const auto nodes = grid.nodes(cell->index());
    for (const unsigned int v : cell->vertex_indices()) {
      double *u = motions.data() + dim * nodes[v];
      for (int c = 0; c < dim; ++c, u += n)
        u[c] = 1.;
      for (int c = 0; c < dim; ++c)
        for (int d = 0; d < c; ++d, u += n) {
          u[c] = cell->vertex(v)[d];
          u[d] = -cell->vertex(v)[c];
        }
    }
  }
  return motions;
}

/** Assembles the matrix of free displacements. */
template <int dim>
void assemble(const CellOperator<dim, double> &K, const ConstrainedNodes<dim> &conditions,
              SparsityPattern &pattern, SparseMatrix<double> &A) {
  constexpr unsigned int n_dofs = CellOperator<dim, double>::n_dofs;
  const unsigned int n = dim * K.grid->n_nodes();
  AffineConstraints<double> constraints;
  for (const auto &[node, T] : conditions)
    for (int c = 0; c < dim; ++c)
      if (T[c][c] == 0.) {
        constraints.add_line(node * dim + c);
        for (int e = 0; e < dim; ++e)
          if (T[c][e] != 0.)
            constraints.add_entry(node * dim + c, node * dim + e, T[c][e]);
      }
  constraints.close();
  const auto dofs_of = [&](const std::size_t cell) {
    const auto nodes = K.grid->nodes(cell);
    std::vector<types::global_dof_index> dofs(n_dofs);
    for (unsigned int i = 0; i < n_dofs; ++i)
      dofs[i] = nodes[i / dim] * dim + i % dim;
    return dofs;
  };
  DynamicSparsityPattern couplings(n, n);
  for (std::size_t cell = 0; cell < K.grid->n_cells; ++cell)
    constraints.add_entries_local_to_global(dofs_of(cell), couplings);
  pattern.copy_from(couplings);
  A.reinit(pattern);
  std::vector<double> buffer;
  FullMatrix<double> K_cell(n_dofs);
  for (std::size_t cell = 0; cell < K.grid->n_cells; ++cell) {
    const double *const entries = K.entries(cell / n_lanes, buffer) + cell % n_lanes;
    for (unsigned int i = 0; i < n_dofs; ++i)
      for (unsigned int j = 0; j < n_dofs; ++j)
        K_cell(i, j) = entries[lower(i, j) * n_lanes];
    constraints.distribute_local_to_global(K_cell, dofs_of(cell), A);
  }
}
} // namespace

template <int dim>
CoarsestInverse<dim>::CoarsestInverse(const CellOperator<dim, double> &K,
                                      const ConstrainedNodes<dim> &conditions,
                                      const Triangulation<dim> &mesh)
  : is_factorised_(dim == 2 || dim * K.grid->n_nodes() <= max_factorised_in_space) {
  assemble(K, conditions, pattern_, A_);
  if (!is_factorised_) {
    prepare_cycle(rigid_motions<dim>(*K.grid, mesh));
    return;
  }
  try {
    factors_.initialize(A_);
  } catch (const ExceptionBase &) {
    throw singular();
  }
  A_.clear();
  pattern_.reinit(0, 0, 0);
}

template <int dim>
void CoarsestInverse<dim>::prepare_cycle(std::vector<double> motions) {
  A_of_cycle_.reinit(A_);
  motions_ = std::move(motions);
  Teuchos::ParameterList parameters;
  std::unique_ptr<Epetra_MultiVector> no_modes;
  TrilinosWrappers::PreconditionAMG::AdditionalData().set_parameters(parameters, no_modes,
                                                                     A_of_cycle_);
  parameters.set("PDE equations", dim);
  parameters.set("null space: type", "pre-computed");
  parameters.set("null space: dimension", dim * (dim + 1) / 2);
  parameters.set("null space: vectors", motions_.data());
  cycle_.initialize(A_of_cycle_, parameters);
}

template <int dim>
void CoarsestInverse<dim>::solve(dealii::Vector<double> &u) const {
  if (is_factorised_)
    return factors_.solve(u);
  const dealii::Vector<double> b(u);
  u = 0.;
  SolverControl control(max_steps, 1e-4 * b.l2_norm());
  try {
    SolverCG<dealii::Vector<double>>(control).solve(A_, u, b, cycle_);
  } catch (const SolverControl::NoConvergence &) {
    throw singular();
  }
}

template class CoarsestInverse<2>;
template class CoarsestInverse<3>;
} // namespace Signorini
