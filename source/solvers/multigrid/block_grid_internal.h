// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/solvers/multigrid/block_grid.h>

#include <deal.II/base/tensor.h>

#include <vector>

namespace Signorini
{
/** The essential conditions of the displacement of a node. */
template <int dim>
struct NodeCondition
{
  NodeNumber node;
  /** The matrix in u = T u_free: columns of constrained components are zero. */
  dealii::Tensor<2, dim> T;
  /** The orthogonal projection onto the displacements that the conditions allow. */
  dealii::Tensor<2, dim> projection;
};

/** The conditions of the nodes that are not free. */
template <int dim>
using NodeConditions = std::vector<NodeCondition<dim>>;

/** Returns the projection onto the range of T. */
template <int dim>
dealii::Tensor<2, dim> projection_onto_range(const dealii::Tensor<2, dim> &T);

/** Computes x = projection x at all nodes that are not free. */
template <int dim>
void project(LevelVector<dim, float> &x, const NodeConditions<dim> &conditions);

/** Returns the conditions of the next coarser level: its nodes keep those of the finer one. */
template <int dim>
NodeConditions<dim> coarsen(const NodeConditions<dim> &fine,
                            unsigned int n_fine_nodes,
                            const BlockGrid<dim> &coarse);
} // namespace Signorini
