// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/solvers/stiffness/cell_operator.h>

#include <deal.II/grid/tria.h>
#include <deal.II/lac/sparse_direct.h>
#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/lac/trilinos_precondition.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <vector>

namespace Signorini {
/**
 * The inverse of the matrix of the coarsest level: factors, or, for many nodes in space, where
 * factors have some n^{4/3} numbers, conjugate gradients with a cycle of Trilinos' algebraic
 * multigrid (ML) in each step.
 */
template <int dim>
class CoarsestInverse {
public:
  /**
   * Factorises the matrix of free displacements, or prepares cycles.
   * @param mesh whose coarse cells those of K are, where there are many of them.
   * @throws ComputationError if it cannot be factorised.
   */
  CoarsestInverse(const CellOperator<dim, double> &K, const ConstrainedNodes<dim> &conditions,
                  const Triangulation<dim> &mesh);

  /** Replaces forces by displacements; the components of a node follow each other.
   * @throws ComputationError if the iteration does not converge. */
  void solve(dealii::Vector<double> &u) const;

private:
  /** Prepares cycles. @param motions those with small energies, one after the other. */
  void prepare_cycle(std::vector<double> motions);

  bool is_factorised_;
  SparseDirectUMFPACK factors_;
  /** Without factors: the matrix, and the data of the cycle. (Products of deal.II's vectors with
   * matrices of Trilinos do not link with clang++.) */
  SparsityPattern pattern_;
  SparseMatrix<double> A_;
  TrilinosWrappers::SparseMatrix A_of_cycle_;
  std::vector<double> motions_;
  TrilinosWrappers::PreconditionAMG cycle_;
};
} // namespace Signorini
