// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/solvers/multigrid/cell_matrices.h>

namespace Signorini
{
/** The instruction sets of processors; each kernel exists for all of them. */
enum class Instructions
{
  basic,
  avx2,
  avx512
};

/** Returns the best instruction set of this processor. */
Instructions instructions_of_this_machine();

/** The inverses of the nodes' diagonal blocks, one array per entry: those on the diagonal, then
 * (0,1), (0,2), (1,2). */
template <int dim>
using NodeBlocks = LevelVector<dim *(dim + 1) / 2, float>;

/** Computes y = K x, cell by cell, without constraints. */
template <int dim, typename Number>
void multiply(LevelVector<dim, Number> &y,
              const LevelVector<dim, Number> &x,
              const BlockGrid<dim> &grid,
              const CellMatrices<dim, Number> &matrices,
              Instructions instructions);

/** The step d = α d + γ B (b - y); x += d. Without y and d (null) it is d = γ B b, x =
 * d. */
template <int dim>
struct SmootherStep
{
  LevelVector<dim, float> &x, &d;
  const LevelVector<dim, float> &b, &y;
  const NodeBlocks<dim> &B;
  unsigned int n_nodes;
  float alpha, gamma;
  /** Whether x and d are zero, and y is not needed. */
  bool is_first;
};
template <int dim>
void smooth(const SmootherStep<dim> &step, Instructions instructions);
} // namespace Signorini
