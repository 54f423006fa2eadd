// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <memory>

#include "cell_eigenvalues.h"
#include "kernels.h"
#include "node_conditions.h"

namespace Signorini
{
/** One level of the V-cycle: matrices, conditions, and the smoother. */
template <int dim>
class MultigridLevel
{
public:
  MultigridLevel(std::shared_ptr<const BlockGrid<dim>> grid,
                 CellMatrices<dim, float> matrices,
                 NodeConditions<dim> conditions,
                 Instructions instructions);

  const BlockGrid<dim> &grid() const
  {
    return *grid_;
  }
  const CellMatrices<dim, float> &matrices() const
  {
    return matrices_;
  }
  const NodeConditions<dim> &conditions() const
  {
    return conditions_;
  }
  /** An upper bound of the eigenvalues of B A. */
  double largest_eigenvalue() const
  {
    return largest_eigenvalue_;
  }

  /** Steps of Chebyshev's iteration of the fourth kind (J. Lottes, Numer. Linear Algebra Appl. 30
   * (2023) e2518): x changes by a polynomial in B A that depends on the largest eigenvalue only.
   * @param from_zero x counts as zero. */
  void smooth(bool from_zero);
  /** y = A x. */
  void multiply();

  std::size_t memory() const
  {
    return grid_->memory() + matrices_.memory() +
           conditions_.capacity() * sizeof(NodeCondition<dim>) + x.memory() + b.memory() +
           y.memory() + d_.memory() + B_.memory();
  }

  /** Solution, right-hand side, and A x. */
  LevelVector<dim, float> x, b, y;

private:
  void make_blocks();

  std::shared_ptr<const BlockGrid<dim>> grid_;
  CellMatrices<dim, float> matrices_;
  NodeConditions<dim> conditions_;
  Instructions instructions_;
  /** The last change of x. */
  LevelVector<dim, float> d_;
  /** Inverses of the diagonal blocks on what conditions leave. */
  NodeBlocks<dim> B_;
  double largest_eigenvalue_ = 1.;
};
} // namespace Signorini
