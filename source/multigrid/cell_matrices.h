// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "block_grid.h"

namespace Signorini
{
/**
 * The stiffness matrices of the cells of one level, for n_lanes cells at a time: one that all of
 * them share, or one for each lane. Unknown i = dim v + c of a cell is component c at vertex v.
 */
template <int dim, typename Number>
class CellMatrices
{
public:
  static constexpr unsigned int n_dofs = dim << dim;
  /** Of a symmetric matrix: i >= j at i (i + 1)/2 + j. */
  static constexpr unsigned int n_entries = n_dofs * (n_dofs + 1) / 2;
  /** What one batch with matrices of its own takes. */
  static constexpr std::size_t batch_size = static_cast<std::size_t>(n_entries) * n_lanes;

  explicit CellMatrices(const std::size_t n_batches)
    : of_batch(n_batches)
  {
  }
  /** The same numbers with another precision. */
  template <typename Other>
  explicit CellMatrices(const CellMatrices<dim, Other> &other)
    : of_batch(other.of_batch)
    , shared(other.shared.begin(), other.shared.end())
    , stored(other.stored.begin(), other.stored.end())
  {
  }

  static unsigned int entry(const unsigned int i, const unsigned int j)
  {
    return i >= j ? i * (i + 1) / 2 + j : j * (j + 1) / 2 + i;
  }
  bool is_shared(const std::size_t batch) const
  {
    return of_batch[batch] >= 0;
  }
  /** Full, n_dofs by n_dofs. */
  const Number *shared_matrix(const std::size_t batch) const
  {
    return &shared[static_cast<std::size_t>(of_batch[batch]) * n_dofs * n_dofs];
  }
  /** [entry][lane]. */
  const Number *stored_matrices(const std::size_t batch) const
  {
    return &stored[static_cast<std::size_t>(-1 - of_batch[batch]) * batch_size];
  }
  Number *stored_matrices(const std::size_t batch)
  {
    return &stored[static_cast<std::size_t>(-1 - of_batch[batch]) * batch_size];
  }
  Number value(const std::size_t cell, const unsigned int i, const unsigned int j) const
  {
    const std::size_t batch = cell / n_lanes;
    return is_shared(batch) ? shared_matrix(batch)[i * n_dofs + j]
                            : stored_matrices(batch)[entry(i, j) * n_lanes + cell % n_lanes];
  }
  /** Room for matrices of its own. */
  void store(const std::size_t batch)
  {
    of_batch[batch] = -1 - static_cast<int>(stored.size() / batch_size);
    stored.resize(stored.size() + batch_size);
  }
  std::size_t memory() const
  {
    return of_batch.capacity() * sizeof(int) +
           (shared.capacity() + stored.capacity()) * sizeof(Number);
  }

  /** By batch: the number of a shared matrix, or -1 - the number of n_lanes stored ones. */
  std::vector<int> of_batch;
  std::vector<Number> shared, stored;
};

/** Adds the diagonal blocks of nodes, [dim c + d], of the matrix that would be assembled. */
template <int dim, typename Number>
void add_diagonal_blocks(LevelVector<dim * dim, Number> &blocks,
                         const BlockGrid<dim> &grid,
                         const CellMatrices<dim, Number> &matrices)
{
  for (std::size_t cell = 0; cell < grid.n_cells(); ++cell)
  {
    const auto nodes = grid.nodes(cell);
    for (unsigned int v = 0; v < nodes.size(); ++v)
      for (unsigned int c = 0; c < dim; ++c)
        for (unsigned int d = 0; d < dim; ++d)
          blocks[dim * c + d][nodes[v]] += matrices.value(cell, v * dim + c, v * dim + d);
  }
}

/** The matrices of the next coarser level: the energy of functions that are linear along the edges
 * of its cells, sum over the children of P^T K P. */
template <int dim>
CellMatrices<dim, float> coarsen(const CellMatrices<dim, float> &fine,
                                 const BlockGrid<dim> &fine_grid,
                                 const BlockGrid<dim> &coarse_grid);
} // namespace Signorini
