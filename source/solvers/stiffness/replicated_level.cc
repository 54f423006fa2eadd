// SPDX-License-Identifier: LGPL-2.1-or-later
// The levels below the subtrees, on every rank.

#include "replicated_level.h"

#include <signorini/base/instantiate.h>
#include <signorini/base/parallel.h>

#include <deal.II/base/utilities.h>

#include <boost/serialization/vector.hpp>

#include <algorithm>

namespace Signorini {
namespace {
/** The cells of a level. */
struct CellTable {
  /** The number of each cell on the whole level, the nodes of its vertices, and the entries of its
   * matrix. */
  std::vector<std::size_t> cells;
  std::vector<types::global_dof_index> nodes;
  std::vector<double> entries;
};

/** Returns the cells of this rank. @param n cells per direction of a tree. */
template <int dim>
CellTable table_of(const CellOperator<dim, double> &K,
                   const std::vector<types::global_dof_index> &numbers,
                   const std::vector<BlockPlace<dim>> &blocks, const std::size_t n) {
  using Operator = CellOperator<dim, double>;
  const BlockGrid<dim> &grid = *K.grid;
  CellTable table;
  std::vector<double> buffer;
  for (std::size_t cell = 0; cell < grid.n_cells; ++cell) {
    const auto &[tree, position] = blocks[cell / (grid.n_cells / grid.n_blocks)];
    std::size_t number = Utilities::fixed_power<dim>(n) * tree, stride = 1, rest = cell;
    for (int d = 0; d < dim; ++d) {
      number += stride * (position[d] * grid.n + rest % grid.n);
      rest /= grid.n;
      stride *= n;
    }
    table.cells.push_back(number);
    for (const NodeNumber node : grid.nodes(cell))
      table.nodes.push_back(numbers[node]);
    const double *const entries = K.entries(cell / n_lanes, buffer) + cell % n_lanes;
    for (unsigned int i = 0; i < Operator::n_entries; ++i)
      table.entries.push_back(entries[i * n_lanes]);
  }
  return table;
}
} // namespace

template <int dim>
ReplicatedLevel<dim> replicate(const CellOperator<dim, double> &K,
                               const ConstrainedNodes<dim> &conditions,
                               const std::vector<types::global_dof_index> &numbers,
                               const std::vector<BlockPlace<dim>> &blocks, const Mesh<dim> &mesh) {
  using Operator = CellOperator<dim, double>;
  constexpr unsigned int n_vertices = 1U << dim;
  const MPI_Comm communicator = mesh.communicator();
  const unsigned int n = K.grid->n << mesh.subtree_level();
  const CellTable mine = table_of<dim>(K, numbers, blocks, n);
  const std::vector<std::size_t> cells = collect(mine.cells, communicator);
  const auto cell_nodes = collect(mine.nodes, communicator);
  const std::vector<double> entries = collect(mine.entries, communicator);
  std::vector<types::global_dof_index> sorted = cell_nodes;
  std::sort(sorted.begin(), sorted.end());
  sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
  const auto index_of = [&sorted](const types::global_dof_index number) {
    return static_cast<NodeNumber>(std::lower_bound(sorted.begin(), sorted.end(), number) -
                                   sorted.begin());
  };
  std::vector<std::size_t> row_of_cell(cells.size());
  for (std::size_t row = 0; row < cells.size(); ++row)
    row_of_cell[cells[row]] = row;
  const auto grid = std::make_shared<const BlockGrid<dim>>(
    mesh.triangulation().n_cells(0), n, [&](const std::size_t cell, const unsigned int v) {
      return index_of(cell_nodes[row_of_cell[cell] * n_vertices + v]);
    });
  ReplicatedLevel<dim> level = {Operator(grid, 1), {}, {}};
  level.K.store_matrices();
  for (std::size_t cell = 0; cell < cells.size(); ++cell)
    for (unsigned int i = 0; i < Operator::n_entries; ++i)
      level.K.stored_matrices(cell / n_lanes)[i * n_lanes + cell % n_lanes] =
        entries[row_of_cell[cell] * Operator::n_entries + i];
  std::vector<NodeNumber> node_of(sorted.size());
  for (NodeNumber node = 0; node < grid->n_nodes(); ++node)
    node_of[grid->identities[node]] = node;
  std::vector<std::pair<types::global_dof_index, Tensor<2, dim>>> given;
  for (const auto &[node, T] : conditions)
    given.emplace_back(numbers[node], T);
  given = collect(given, communicator);
  for (auto &condition : given)
    condition.first = node_of[index_of(condition.first)];
  level.conditions.insert(given.begin(), given.end());
  for (const types::global_dof_index number : numbers)
    level.nodes.push_back(node_of[index_of(number)]);
  return level;
}

INSTANTIATE_FUNCTION(replicate);
} // namespace Signorini
