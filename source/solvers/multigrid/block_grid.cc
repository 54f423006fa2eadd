// SPDX-License-Identifier: LGPL-2.1-or-later
// Nodes of blocks of cells.

#include <signorini/solvers/multigrid/block_grid.h>

#include <algorithm>
#include <limits>

#include "multigrid_internal.h"

namespace Signorini
{
namespace
{
constexpr NodeNumber no_node = std::numeric_limits<NodeNumber>::max();

unsigned int power(const unsigned int base, const int exponent)
{
  unsigned int result = 1;
  for (int i = 0; i < exponent; ++i)
    result *= base;
  return result;
}
} // namespace

template <int dim>
BlockGrid<dim>::BlockGrid(const unsigned int n_blocks,
                          const unsigned int n,
                          std::vector<NodeNumber> &identities,
                          const std::size_t n_identities)
  : n_blocks_(n_blocks)
  , n_(n)
  , rows_per_block_(power(n + 1, dim - 1))
  , n_cells_(static_cast<std::size_t>(n_blocks) * power(n, dim))
{
  const std::vector<bool> owned = number_nodes(identities, n_identities);
  make_rows(identities, owned);
  if (!has_long_rows())
    make_batches();
}

template <int dim>
std::vector<bool> BlockGrid<dim>::number_nodes(std::vector<NodeNumber> &places,
                                               const std::size_t n_identities)
{
  std::vector<NodeNumber> number(n_identities, no_node);
  std::vector<bool> owned(places.size(), false);
  identity_.reserve(n_identities);
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    NodeNumber &node_number = number[places[i]];
    if (node_number == no_node)
    {
      node_number = static_cast<NodeNumber>(identity_.size());
      identity_.push_back(places[i]);
      owned[i] = true;
    }
    places[i] = node_number;
  }
  identity_.shrink_to_fit();
  return owned;
}

template <int dim>
void BlockGrid<dim>::make_rows(const std::vector<NodeNumber> &places,
                               const std::vector<bool> &owned)
{
  const std::size_t n_rows = static_cast<std::size_t>(n_blocks_) * rows_per_block_;
  rows_.reserve(n_rows);
  for (std::size_t r = 0; r < n_rows; ++r)
  {
    const std::size_t begin = r * (n_ + 1), end = begin + n_;
    bool consecutive = n_ > 1;
    for (std::size_t i = begin + 2; i < end; ++i)
      consecutive = consecutive && places[i] == places[i - 1] + 1 && owned[i] == owned[i - 1];
    if (consecutive)
    {
      rows_.push_back({places[begin],
                       places[begin + 1],
                       places[end],
                       {owned[begin], owned[begin + 1], owned[end]},
                       false});
      continue;
    }
    rows_.push_back({static_cast<NodeNumber>(list_.size()), 0, 0, {false, false, false}, true});
    for (std::size_t i = begin; i <= end; ++i)
      list_.push_back(places[i] | (owned[i] ? owned_bit : 0U));
  }
}

template <int dim>
void BlockGrid<dim>::make_batches()
{
  batch_nodes_.resize(n_batches() * n_vertices * n_lanes);
  for (std::size_t cell = 0; cell < n_batches() * n_lanes; ++cell)
  {
    // Lanes behind the last cell repeat it; their results are not used.
    const auto cell_data = nodes(std::min(cell, n_cells_ - 1));
    NodeNumber *const batch = &batch_nodes_[cell / n_lanes * n_vertices * n_lanes];
    for (unsigned int v = 0; v < n_vertices; ++v)
      batch[v * n_lanes + cell % n_lanes] = cell_data[v];
  }
}

template <int dim>
std::array<NodeNumber, BlockGrid<dim>::n_vertices> BlockGrid<dim>::nodes(std::size_t cell) const
{
  const auto i = static_cast<unsigned int>(cell % n_);
  cell /= n_;
  std::array<unsigned int, 2> jk = {{0, 0}};
  for (int d = 1; d < dim; ++d)
  {
    jk[d - 1] = static_cast<unsigned int>(cell % n_);
    cell /= n_;
  }
  std::array<NodeNumber, n_vertices> result;
  for (unsigned int v = 0; v < n_vertices; ++v)
  {
    const unsigned int place =
      jk[0] + ((v >> 1U) & 1U) + (dim == 3 ? (n_ + 1) * (jk[1] + (v >> 2U)) : 0U);
    result[v] = node(row(static_cast<unsigned int>(cell), place), i + (v & 1U));
  }
  return result;
}

template <int dim>
std::vector<NodeNumber> every_other(const std::vector<NodeNumber> &places,
                                    const unsigned int n_blocks,
                                    const unsigned int n)
{
  std::vector<NodeNumber> coarse;
  const std::size_t per_block = power(n + 1, dim);
  coarse.reserve(n_blocks * static_cast<std::size_t>(power(n / 2 + 1, dim)));
  for (unsigned int block = 0; block < n_blocks; ++block)
    for (unsigned int k = 0; k <= (dim == 3 ? n : 0U); k += 2)
      for (unsigned int j = 0; j <= n; j += 2)
        for (unsigned int i = 0; i <= n; i += 2)
          coarse.push_back(
            places[block * per_block + (static_cast<std::size_t>(k) * (n + 1) + j) * (n + 1) + i]);
  return coarse;
}

template class BlockGrid<2>;
template class BlockGrid<3>;
template std::vector<NodeNumber> every_other<2>(const std::vector<NodeNumber> &,
                                                unsigned int,
                                                unsigned int);
template std::vector<NodeNumber> every_other<3>(const std::vector<NodeNumber> &,
                                                unsigned int,
                                                unsigned int);

// Essential conditions, node by node.

template <int dim>
Tensor<2, dim> projection_onto_range(const Tensor<2, dim> &T)
{
  Tensor<2, dim> projection;
  for (unsigned int c = 0; c < dim; ++c)
  {
    Tensor<1, dim> column;
    for (unsigned int d = 0; d < dim; ++d)
      column[d] = T[d][c];
    const double size = column.norm();
    // Gram and Schmidt, twice against rounding.
    for (unsigned int repetition = 0; repetition < 2; ++repetition)
      column -= projection * column;
    if (column.norm() <= 1e-10 * size)
      continue;
    column /= column.norm();
    projection += outer_product(column, column);
  }
  return projection;
}

template <int dim>
void project(LevelVector<dim, float> &x, const ConstrainedNodes<dim> &conditions)
{
  for (const ConstrainedNode<dim> &condition : conditions)
  {
    Tensor<1, dim> u;
    for (unsigned int c = 0; c < dim; ++c)
      u[c] = x[c][condition.node];
    u = condition.projection * u;
    for (unsigned int c = 0; c < dim; ++c)
      x[c][condition.node] = static_cast<float>(u[c]);
  }
}

template <int dim>
ConstrainedNodes<dim> coarsen(const ConstrainedNodes<dim> &fine,
                              const unsigned int n_fine_nodes,
                              const BlockGrid<dim> &coarse)
{
  constexpr NodeNumber none = ~0U;
  std::vector<NodeNumber> place(n_fine_nodes, none);
  for (std::size_t i = 0; i < fine.size(); ++i)
    place[fine[i].node] = static_cast<NodeNumber>(i);
  ConstrainedNodes<dim> conditions;
  for (NodeNumber node = 0; node < coarse.n_nodes(); ++node)
    if (const NodeNumber i = place[coarse.identities()[node]]; i != none)
      conditions.push_back({node, fine[i].T, fine[i].projection});
  return conditions;
}

template Tensor<2, 2> projection_onto_range(const Tensor<2, 2> &);
template Tensor<2, 3> projection_onto_range(const Tensor<2, 3> &);
template void project(LevelVector<2, float> &, const ConstrainedNodes<2> &);
template void project(LevelVector<3, float> &, const ConstrainedNodes<3> &);
template ConstrainedNodes<2> coarsen(const ConstrainedNodes<2> &,
                                     unsigned int,
                                     const BlockGrid<2> &);
template ConstrainedNodes<3> coarsen(const ConstrainedNodes<3> &,
                                     unsigned int,
                                     const BlockGrid<3> &);
} // namespace Signorini
