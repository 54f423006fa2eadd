// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>

#include <deal.II/base/aligned_vector.h>
#include <deal.II/base/types.h>

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

namespace Signorini {
/** The number of a node on one level. */
using NodeNumber = std::uint32_t;

/** The number of cells that a kernel processes at a time. */
constexpr unsigned int n_lanes = 16;

/** The vectors of a level: one array for each component, so that nodes of a row lie side by side,
 * with zeros behind the last node up to a multiple of n_lanes. */
template <int n_components, typename Number>
struct LevelVector : std::array<AlignedVector<Number>, n_components> {
  explicit LevelVector(const unsigned int n_nodes = 0) {
    for (AlignedVector<Number> &component : *this)
      component.resize((n_nodes + n_lanes - 1) / n_lanes * n_lanes);
  }
  std::size_t memory() const {
    return n_components * (*this)[0].memory_consumption();
  }
};

/**
 * One level of the mesh as blocks: every cell of the coarse mesh, with ranks every root of a
 * subtree, is a block of n^dim cells, n a power of two. Cells are numbered block by block, the
 * first direction fastest, and taken n_lanes at a time, as batches. A block has (n + 1)^dim slots
 * for nodes, numbered in the same way. Nodes are numbered in the order in which slots meet them.
 */
template <int dim>
struct BlockGrid {
  static constexpr unsigned int n_vertices = 1U << dim;
  /** The bit of an entry of starts that is set for a list. */
  static constexpr NodeNumber list_bit = 0x80000000U;

  /**
   * Numbers the nodes.
   * @param identity of a vertex of a cell: equal for the same node.
   */
  BlockGrid(unsigned int n_blocks, unsigned int n,
            const std::function<NodeNumber(std::size_t cell, unsigned int vertex)> &identity);

  unsigned int n_nodes() const {
    return static_cast<unsigned int>(identities.size());
  }
  std::size_t n_batches() const {
    return (n_cells + n_lanes - 1) / n_lanes;
  }
  /** Returns the slot of a vertex of a cell. */
  std::size_t slot(std::size_t cell, unsigned int vertex) const;
  /** Returns the nodes of a cell, in the order of its vertices. */
  std::array<NodeNumber, n_vertices> nodes(std::size_t cell) const;
  /** Returns the cell that is a child of a cell of the next coarser level. */
  std::size_t child(std::size_t cell, unsigned int child) const;
  std::size_t memory() const;

  /** Returns the level with n/2 cells per direction, whose identities are the nodes of this one. */
  BlockGrid coarsen() const;
  /** Sets y to the function P x_H that is linear along the edges of the coarse cells, at the nodes
   * of this level. */
  void prolongate(LevelVector<dim, float> &y, const LevelVector<dim, float> &x_H,
                  const BlockGrid &coarse) const;
  /** Computes b_H = Pᵀ y. Afterwards y is zero. */
  void restrict_and_clear(LevelVector<dim, float> &b_H, LevelVector<dim, float> &y,
                          const BlockGrid &coarse) const;

  unsigned int n_blocks;
  /** The number of cells per direction of a block. */
  unsigned int n;
  std::size_t n_cells;
  /** The node in every slot of every block, and the identity of every node. */
  std::vector<NodeNumber> slots, identities;
  /** The nodes of the cells of a batch, [batch][vertex]: the first of n_lanes consecutive numbers,
   * or list_bit and the number of a list. Lanes behind the last cell repeat it. */
  std::vector<NodeNumber> starts;
  std::vector<std::array<NodeNumber, n_lanes>> lists;
};

} // namespace Signorini
