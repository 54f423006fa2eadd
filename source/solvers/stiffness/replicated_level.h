// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/solvers/stiffness/stiffness_multigrid.h>

#include <deal.II/base/types.h>

#include <vector>

#include "fine_operator.h"

namespace Signorini {
/** A level of all ranks, as every one of them stores it. */
template <int dim>
struct ReplicatedLevel {
  CellOperator<dim, double> K;
  ConstrainedNodes<dim> conditions;
  /** The numbers there of the nodes of this rank. */
  std::vector<NodeNumber> nodes;
};

/**
 * Collects a level of all ranks.
 * @param conditions of its nodes on this rank.
 * @param numbers of these nodes in the whole mesh.
 * @param blocks of this rank.
 */
template <int dim>
ReplicatedLevel<dim> replicate(const CellOperator<dim, double> &K,
                               const ConstrainedNodes<dim> &conditions,
                               const std::vector<types::global_dof_index> &numbers,
                               const std::vector<BlockPlace<dim>> &blocks, const Mesh<dim> &mesh);
} // namespace Signorini
