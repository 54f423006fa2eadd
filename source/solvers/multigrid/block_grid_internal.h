// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/solvers/multigrid/block_grid.h>

#include <deal.II/base/tensor.h>

#include <vector>

namespace Signorini
{
/** What essential conditions leave of the displacement of a node. */
template <int dim>
struct NodeCondition
{
  NodeNumber node;
  /** u = T u_free: columns of constrained components are zero. */
  dealii::Tensor<2, dim> T;
  /** The orthogonal projection onto the displacements that are left. */
  dealii::Tensor<2, dim> projection;
};

/** Of the nodes that are not free. */
template <int dim>
using NodeConditions = std::vector<NodeCondition<dim>>;

/** The projection onto the range of T. */
template <int dim>
dealii::Tensor<2, dim> projection_onto_range(const dealii::Tensor<2, dim> &T);

/** x = projection x at all nodes that are not free. */
template <int dim>
void project(LevelVector<dim, float> &x, const NodeConditions<dim> &conditions);

/** The nodes of the next coarser level keep the conditions that they have on the finer one. */
template <int dim>
NodeConditions<dim> coarsen(const NodeConditions<dim> &fine,
                            unsigned int n_fine_nodes,
                            const BlockGrid<dim> &coarse);
} // namespace Signorini
