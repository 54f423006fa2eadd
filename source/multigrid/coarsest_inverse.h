// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/stiffness_inverse/stiffness_inverse.h>

#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <memory>

#include "cell_matrices.h"
#include "node_conditions.h"

namespace Signorini
{
/** The inverse of A on the displacements that conditions leave, on one level: a matrix if the level
 * is small, else factors. */
template <int dim>
class CoarsestInverse
{
public:
  /** @throws ComputationError if A is not positive definite, by rounding. */
  CoarsestInverse(const BlockGrid<dim> &grid,
                  const CellMatrices<dim, double> &matrices,
                  const NodeConditions<dim> &conditions);

  /** x = A^{-1} b, with the projections of both. */
  void apply(LevelVector<dim, float> &x, LevelVector<dim, float> &b) const;

private:
  unsigned int n_nodes_;
  const NodeConditions<dim> &conditions_;
  /** Of small levels: the inverse, row by row. */
  std::vector<double> inverse_;
  dealii::TrilinosWrappers::SparseMatrix matrix_;
  std::unique_ptr<const StiffnessInverse> factors_;
};
} // namespace Signorini
