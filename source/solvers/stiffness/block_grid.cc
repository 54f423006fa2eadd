// SPDX-License-Identifier: LGPL-2.1-or-later
// Nodes of blocks of cells, and the transfer between two levels.

#include <signorini/solvers/stiffness/block_grid.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <limits>

namespace Signorini {
namespace {
/** Calls f(row, coarse rows) for all rows of slots of the fine level along the first direction,
 * with the nodes at the slots of the one or more coarse rows next to it, which have equal
 * weights. */
template <int dim, typename Function>
void for_rows(const BlockGrid<dim> &fine, const BlockGrid<dim> &coarse, const Function &f) {
  const std::size_t n = fine.n + 1, N = coarse.n + 1;
  const std::size_t n_layers = dim == 3 ? n : 1, N_layers = dim == 3 ? N : 1;
  std::vector<const NodeNumber *> coarse_rows;
  const NodeNumber *row = fine.slots.data();
  for (std::size_t block = 0; block < fine.n_blocks; ++block)
    for (std::size_t k = 0; k < n_layers; ++k)
      for (std::size_t j = 0; j < n; ++j, row += n) {
        coarse_rows.clear();
        for (std::size_t K = k / 2; K <= (k + 1) / 2; ++K)
          for (std::size_t J = j / 2; J <= (j + 1) / 2; ++J)
            coarse_rows.push_back(&coarse.slots[((block * N_layers + K) * N + J) * N]);
        f(row, coarse_rows);
      }
}
} // namespace

template <int dim>
BlockGrid<dim>::BlockGrid(
  const unsigned int n_blocks, const unsigned int n,
  const std::function<NodeNumber(std::size_t cell, unsigned int vertex)> &identity)
  : n_blocks(n_blocks)
  , n(n)
  , n_cells(n_blocks * Utilities::fixed_power<dim>(std::size_t(n)))
  , slots(n_blocks * Utilities::fixed_power<dim>(std::size_t(n) + 1)) {
  for (std::size_t cell = 0; cell < n_cells; ++cell)
    for (unsigned int v = 0; v < n_vertices; ++v)
      slots[slot(cell, v)] = identity(cell, v);
  constexpr NodeNumber none = std::numeric_limits<NodeNumber>::max();
  std::vector<NodeNumber> numbers(1 + *std::max_element(slots.begin(), slots.end()), none);
  for (NodeNumber &node : slots) {
    NodeNumber &number = numbers[node];
    if (number == none) {
      number = n_nodes();
      identities.push_back(node);
    }
    node = number;
  }
  identities.shrink_to_fit();
  starts.reserve(n_batches() * n_vertices);
  for (std::size_t batch = 0; batch < n_batches(); ++batch)
    for (unsigned int v = 0; v < n_vertices; ++v) {
      std::array<NodeNumber, n_lanes> batch_nodes;
      bool consecutive = true;
      for (unsigned int l = 0; l < n_lanes; ++l) {
        batch_nodes[l] = slots[slot(std::min(batch * n_lanes + l, n_cells - 1), v)];
        consecutive = consecutive && batch_nodes[l] == batch_nodes[0] + l;
      }
      starts.push_back(consecutive ? batch_nodes[0]
                                   : list_bit | static_cast<NodeNumber>(lists.size()));
      if (!consecutive)
        lists.push_back(batch_nodes);
    }
}

template <int dim>
std::size_t BlockGrid<dim>::slot(std::size_t cell, const unsigned int vertex) const {
  std::size_t result = 0, stride = 1;
  for (int d = 0; d < dim; ++d) {
    result += stride * (cell % n + ((vertex >> d) & 1U));
    cell /= n;
    stride *= n + 1;
  }
  return result + stride * cell;
}

template <int dim>
std::array<NodeNumber, BlockGrid<dim>::n_vertices>
BlockGrid<dim>::nodes(const std::size_t cell) const {
  std::array<NodeNumber, n_vertices> result;
  for (unsigned int v = 0; v < n_vertices; ++v)
    result[v] = slots[slot(cell, v)];
  return result;
}

template <int dim>
std::size_t BlockGrid<dim>::child(std::size_t cell, const unsigned int child) const {
  std::size_t result = 0, stride = 1;
  for (int d = 0; d < dim; ++d) {
    result += stride * (2 * (cell % (n / 2)) + ((child >> d) & 1U));
    cell /= n / 2;
    stride *= n;
  }
  return result + stride * cell;
}

template <int dim>
std::size_t BlockGrid<dim>::memory() const {
  return (slots.capacity() + identities.capacity() + starts.capacity() +
          lists.capacity() * n_lanes) *
         sizeof(NodeNumber);
}

template <int dim>
BlockGrid<dim> BlockGrid<dim>::coarsen() const {
  return BlockGrid(n_blocks, n / 2, [&](const std::size_t cell, const unsigned int v) {
    return slots[slot(child(cell, v), v)];
  });
}

template <int dim>
void BlockGrid<dim>::prolongate(LevelVector<dim, float> &y, const LevelVector<dim, float> &x_H,
                                const BlockGrid &coarse) const {
  std::vector<float> sums(coarse.n + 1);
  for_rows(*this, coarse, [&](const NodeNumber *const row, const auto &coarse_rows) {
    const float weight = 0.5F / static_cast<float>(coarse_rows.size());
    for (int c = 0; c < dim; ++c) {
      const float *const source = x_H[c].data();
      float *const target = y[c].data();
      for (unsigned int I = 0; I <= coarse.n; ++I) {
        float sum = 0.F;
        for (const NodeNumber *const coarse_row : coarse_rows)
          sum += source[coarse_row[I]];
        sums[I] = weight * sum;
      }
      for (unsigned int i = 0; i <= n; ++i)
        target[row[i]] = sums[i / 2] + sums[(i + 1) / 2];
    }
  });
}

template <int dim>
void BlockGrid<dim>::restrict_and_clear(LevelVector<dim, float> &b_H, LevelVector<dim, float> &y,
                                        const BlockGrid &coarse) const {
  for (int c = 0; c < dim; ++c)
    b_H[c].fill(0.F);
  // The entries of a row, between two zeros.
  std::vector<float> entries(n + 3);
  for_rows(*this, coarse, [&](const NodeNumber *const row, const auto &coarse_rows) {
    const float weight = 0.5F / static_cast<float>(coarse_rows.size());
    for (int c = 0; c < dim; ++c) {
      float *const source = y[c].data(), *const target = b_H[c].data();
      for (unsigned int i = 0; i <= n; ++i) {
        entries[i + 1] = source[row[i]];
        // A node counts once, at the first of its slots.
        source[row[i]] = 0.F;
      }
      for (unsigned int I = 0; I <= coarse.n; ++I) {
        const float sum = weight * (entries[2 * I] + 2.F * entries[2 * I + 1] + entries[2 * I + 2]);
        for (const NodeNumber *const coarse_row : coarse_rows)
          target[coarse_row[I]] += sum;
      }
    }
  });
}

template struct BlockGrid<2>;
template struct BlockGrid<3>;
} // namespace Signorini
