// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/discretization/elasticity/displacement_space.h>
#include <signorini/problem/scene/scene.h>
#include <signorini/solvers/multigrid/cell_matrices.h>

#include <memory>
#include <vector>

#include "block_grid_internal.h"

namespace Signorini
{
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
  NodeConditions<dim> conditions;
};
} // namespace Signorini
