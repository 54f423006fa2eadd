// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/discretization/elasticity/displacement_space.h>
#include <signorini/problem/scene/scene.h>
#include <signorini/solvers/multigrid/block_grid.h>
#include <signorini/solvers/multigrid/cell_matrices.h>
#include <signorini/solvers/multigrid/kernels.h>
#include <signorini/solvers/stiffness/stiffness_inverse.h>

#include <deal.II/base/tensor.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <memory>
#include <vector>

namespace Signorini
{
/** The essential conditions of the displacement of a node. */
template <int dim>
struct ConstrainedNode
{
  NodeNumber node;
  /** The matrix in u = T u_free: columns of constrained components are zero. */
  Tensor<2, dim> T;
  /** The orthogonal projection onto the displacements that the conditions allow. */
  Tensor<2, dim> projection;
};

/** The conditions of the nodes that are not free. */
template <int dim>
using ConstrainedNodes = std::vector<ConstrainedNode<dim>>;

/** Returns the projection onto the range of T. */
template <int dim>
Tensor<2, dim> projection_onto_range(const Tensor<2, dim> &T);

/** Computes x = projection x at all nodes that are not free. */
template <int dim>
void project(LevelVector<dim, float> &x, const ConstrainedNodes<dim> &conditions);

/** Returns the conditions of the next coarser level: its nodes keep those of the finer one. */
template <int dim>
ConstrainedNodes<dim> coarsen(const ConstrainedNodes<dim> &fine,
                              unsigned int n_fine_nodes,
                              const BlockGrid<dim> &coarse);

/** Returns a bound of the eigenvalues of B A, with the inverse B of the diagonal blocks of nodes:
 * the largest eigenvalue of all cells. With the diagonal blocks D_K of the matrix A_K of a cell,
 * x.A x = sum x.A_K x ≤ λ sum x.D_K x = λ x.D x, whatever conditions hold. */
template <int dim>
double max_cell_eigenvalue(const CellMatrices<dim, float> &matrices, const BlockGrid<dim> &grid);

/** The finest level: the mesh's cells as blocks, with the matrices that would be assembled. */
template <int dim>
struct FineLevel
{
  FineLevel(const DisplacementSpace<dim> &space, const Scene<dim> &scene);

  /** Returns the matrices for V-cycles. */
  CellMatrices<dim, float> matrices_in_single_precision() const;

  /** The identities of the finest level by place; then the numbers of nodes, from which coarser
   * grids are made. */
  std::vector<NodeNumber> places;
  /** The grid. Its identities are degrees of freedom divided by dim. */
  std::shared_ptr<const BlockGrid<dim>> grid;
  CellMatrices<dim, double> matrices;
  ConstrainedNodes<dim> conditions;
};

/** One level of the V-cycle: matrices, conditions, and the smoother. */
template <int dim>
class MultigridLevel
{
public:
  MultigridLevel(std::shared_ptr<const BlockGrid<dim>> grid,
                 CellMatrices<dim, float> matrices,
                 ConstrainedNodes<dim> conditions,
                 Instructions instructions);

  const BlockGrid<dim> &grid() const
  {
    return *grid_;
  }
  const CellMatrices<dim, float> &matrices() const
  {
    return matrices_;
  }
  const ConstrainedNodes<dim> &conditions() const
  {
    return conditions_;
  }
  /** Returns an upper bound of the eigenvalues of B A. */
  double max_eigenvalue() const
  {
    return max_eigenvalue_;
  }

  /**
   * Does steps of Chebyshev's iteration of the fourth kind (J. Lottes, Numer. Linear Algebra Appl.
   * 30 (2023) e2518): x changes by a polynomial in B A that depends on the largest eigenvalue only.
   * @param from_zero x is assumed to be zero.
   */
  void smooth(bool from_zero);
  /** Computes y = A x. */
  void multiply();

  std::size_t memory() const
  {
    return grid_->memory() + matrices_.memory() +
           conditions_.capacity() * sizeof(ConstrainedNode<dim>) + x.memory() + b.memory() +
           y.memory() + d_.memory() + B_.memory();
  }

  /** The solution, the right-hand side, and A x. */
  LevelVector<dim, float> x, b, y;

private:
  void make_blocks();

  std::shared_ptr<const BlockGrid<dim>> grid_;
  CellMatrices<dim, float> matrices_;
  ConstrainedNodes<dim> conditions_;
  Instructions instructions_;
  /** The last change of x. */
  LevelVector<dim, float> d_;
  /** The inverses of the diagonal blocks on the displacements that the conditions allow. */
  NodeBlocks<dim> B_;
  double max_eigenvalue_ = 1.;
};

/** The inverse of A on the displacements that the conditions allow, on one level: a matrix if the
 * level is small, else factors. */
template <int dim>
class CoarsestInverse
{
public:
  /**
   * Inverts or factorises A.
   * @throws ComputationError if A is not positive definite, by rounding.
   */
  CoarsestInverse(const BlockGrid<dim> &grid,
                  const CellMatrices<dim, double> &matrices,
                  const ConstrainedNodes<dim> &conditions);

  /** Computes x = A⁻¹ b, with the projections of both. */
  void apply(LevelVector<dim, float> &x, LevelVector<dim, float> &b) const;

private:
  unsigned int n_nodes_;
  const ConstrainedNodes<dim> &conditions_;
  /** The inverse of a small level, row by row. */
  std::vector<double> inverse_;
  TrilinosWrappers::SparseMatrix matrix_;
  std::unique_ptr<const StiffnessInverse> factors_;
};

/** Adds P x_H to x: functions that are linear along the edges of the coarse cells, at the nodes of
 * the fine level. */
template <int dim>
void prolongate(LevelVector<dim, float> &x,
                const LevelVector<dim, float> &x_H,
                const BlockGrid<dim> &fine,
                const BlockGrid<dim> &coarse);

/** Computes b_H = Pᵀ (b - y). */
template <int dim>
void restrict_residual(LevelVector<dim, float> &b_H,
                       const LevelVector<dim, float> &b,
                       const LevelVector<dim, float> &y,
                       const BlockGrid<dim> &fine,
                       const BlockGrid<dim> &coarse);
} // namespace Signorini
