// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/types.h>

#include <array>
#include <cstdint>
#include <vector>

namespace Signorini
{
/** The number of a node on one level. */
using NodeNumber = std::uint32_t;

/** The number of cells that a kernel processes at a time. */
constexpr unsigned int n_lanes = 16;

/** The n + 1 nodes of a row of cells, along the first direction of a block. Those between the ends
 * have consecutive numbers, unless the row is listed. */
struct NodeRow
{
  /** The node at the beginning, or the position of a listed row in the list. */
  NodeNumber first;
  /** The node after it. */
  NodeNumber middle;
  /** The node at the end. */
  NodeNumber last;
  /** Whether the first, the middle and the last nodes are owned: of the places that a node has in
   * several blocks or rows, one owns it. */
  std::array<bool, 3> owned;
  bool listed;
};

/**
 * One level of the mesh as blocks: every cell of the coarse mesh is a block of n^dim cells, n a
 * power of two. Cells are numbered block by block, the first direction fastest, and taken n_lanes
 * at a time. Nodes are numbered in the order in which rows meet them.
 */
template <int dim>
class BlockGrid
{
public:
  static constexpr unsigned int n_vertices = 1U << dim;
  /** The bit of a node in a list that is set if the node is owned there. */
  static constexpr NodeNumber owned_bit = 0x80000000U;

  /**
   * Numbers the nodes.
   * @param identities the identities of the nodes at all (n + 1)^dim places of every block: equal
   * for the same node. They are replaced by the numbers of the nodes.
   * @param n_identities one more than the largest.
   */
  BlockGrid(unsigned int n_blocks,
            unsigned int n,
            std::vector<NodeNumber> &identities,
            std::size_t n_identities);

  unsigned int n_blocks() const
  {
    return n_blocks_;
  }
  /** Returns the number of cells per direction of a block. */
  unsigned int n() const
  {
    return n_;
  }
  unsigned int n_nodes() const
  {
    return static_cast<unsigned int>(identity_.size());
  }
  std::size_t n_cells() const
  {
    return n_cells_;
  }
  std::size_t n_batches() const
  {
    return (n_cells_ + n_lanes - 1) / n_lanes;
  }
  /** Returns the identity of every node. */
  const std::vector<NodeNumber> &identities() const
  {
    return identity_;
  }
  /** Returns whether n_lanes cells always lie side by side in a row. */
  bool has_long_rows() const
  {
    return n_ >= n_lanes;
  }
  /** Returns the row at j + (n + 1) k of a block. */
  const NodeRow &row(const unsigned int block, const unsigned int place) const
  {
    return rows_[static_cast<std::size_t>(block) * rows_per_block_ + place];
  }
  /** Returns the nodes of a listed row, with owned_bit. */
  const NodeNumber *list(const NodeRow &row) const
  {
    return &list_[row.first];
  }
  unsigned int rows_per_block() const
  {
    return rows_per_block_;
  }
  /** Returns the node at a place of a row. */
  NodeNumber node(const NodeRow &row, const unsigned int i) const
  {
    if (row.listed)
      return list_[row.first + i] & ~owned_bit;
    return i == 0 ? row.first : i == n_ ? row.last : row.middle + (i - 1);
  }
  /** Returns whether the place owns its node. */
  bool owns(const NodeRow &row, const unsigned int i) const
  {
    if (row.listed)
      return (list_[row.first + i] & owned_bit) != 0;
    return row.owned[i == 0 ? 0 : i == n_ ? 2 : 1];
  }
  /** Returns the nodes of a cell, in the order of its vertices. */
  std::array<NodeNumber, n_vertices> nodes(std::size_t cell) const;
  /** Returns the nodes of a batch, [vertex][lane], for grids without long rows. */
  const NodeNumber *batch_nodes(const std::size_t batch) const
  {
    return &batch_nodes_[batch * n_vertices * n_lanes];
  }

  std::size_t memory() const
  {
    return rows_.capacity() * sizeof(NodeRow) +
           (list_.capacity() + batch_nodes_.capacity() + identity_.capacity()) * sizeof(NodeNumber);
  }

private:
  /**
   * Numbers the nodes.
   * @return for every place whether it owns its node.
   */
  std::vector<bool> number_nodes(std::vector<NodeNumber> &places, std::size_t n_identities);
  void make_rows(const std::vector<NodeNumber> &places, const std::vector<bool> &owned);
  void make_batches();

  unsigned int n_blocks_, n_, rows_per_block_;
  std::size_t n_cells_;
  std::vector<NodeRow> rows_;
  std::vector<NodeNumber> list_, batch_nodes_, identity_;
};

/** Returns the numbers of a level with n/2 cells per direction at the same places: every other one.
 */
template <int dim>
std::vector<NodeNumber> every_other(const std::vector<NodeNumber> &places,
                                    unsigned int n_blocks,
                                    unsigned int n);

/** The vectors of a level: one array for each of @p n_components, so that nodes of a row lie side
 * by side. */
template <int n_components, typename Number>
class LevelVector
{
public:
  explicit LevelVector(const unsigned int n_nodes)
    : stride_(n_nodes + 2 * n_lanes)
    , values_(n_components * stride_)
  {
  }

  /** Returns the entries of a component by node. Kernels may read n_lanes entries on either side.
   */
  Number *operator[](const unsigned int component)
  {
    return values_.data() + component * stride_ + n_lanes;
  }
  const Number *operator[](const unsigned int component) const
  {
    return values_.data() + component * stride_ + n_lanes;
  }
  void set_zero()
  {
    std::fill(values_.begin(), values_.end(), Number());
  }

  std::size_t memory() const
  {
    return values_.capacity() * sizeof(Number);
  }

private:
  std::size_t stride_;
  std::vector<Number> values_;
};
} // namespace Signorini
