// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/solvers/multigrid/block_grid.h>

#include <array>
#include <cstddef>
#include <limits>
#include <memory>
#include <vector>

namespace Signorini
{
/** The rule by which matrices of cells follow from the positions of their vertices, for a constant
 * tensor. */
template <int dim, typename Number>
struct PointRule
{
  static constexpr unsigned int n_strains = dim * (dim + 1) / 2;
  static constexpr unsigned int n_moduli = n_strains * (n_strains + 1) / 2;

  /** The positions of the nodes in the body of size one. */
  LevelVector<dim, Number> places;
  /** The moduli E/E_0 in Voigt's notation, by rows of the lower triangle; 11, 22, (33,) 12, (13,
   * 23). */
  std::array<Number, n_moduli> moduli;
  /** The derivatives of shape functions on the reference cell, [point][vertex][direction]. */
  std::vector<Number> gradients;
  /** The weights of the points. */
  std::vector<Number> weights;
};

/**
 * The stiffness matrices of the cells of one level, for n_lanes cells at a time: one that all of
 * them share, one for each lane, or none where products are integrated. Unknown i = dim v + c of a
 * cell is component c at vertex v.
 */
template <int dim, typename Number>
class CellMatrices
{
public:
  static constexpr unsigned int n_dofs = dim << dim;
  /** The number of entries of a symmetric matrix: i ≥ j at i (i + 1)/2 + j. */
  static constexpr unsigned int n_entries = n_dofs * (n_dofs + 1) / 2;
  /** The number of entries of one batch with matrices of its own. */
  static constexpr std::size_t batch_size = static_cast<std::size_t>(n_entries) * n_lanes;

  explicit CellMatrices(const std::size_t n_batches)
    : batch_storage(n_batches)
  {
  }
  /** Copies the matrices to another precision; @p new_rule replaces the rule of the other. */
  template <typename Other>
  CellMatrices(const CellMatrices<dim, Other> &other,
               std::shared_ptr<const PointRule<dim, Number>> new_rule)
    : batch_storage(other.batch_storage)
    , shared(other.shared.begin(), other.shared.end())
    , stored(other.stored.begin(), other.stored.end())
    , rule(std::move(new_rule))
  {
  }

  static unsigned int entry(const unsigned int i, const unsigned int j)
  {
    return i >= j ? i * (i + 1) / 2 + j : j * (j + 1) / 2 + i;
  }
  bool is_shared(const std::size_t batch) const
  {
    return batch_storage[batch] >= 0;
  }
  bool is_integrated(const std::size_t batch) const
  {
    return batch_storage[batch] == integrated;
  }
  /** Returns the full matrix that a batch shares, n_dofs by n_dofs. */
  const Number *shared_matrix(const std::size_t batch) const
  {
    return &shared[static_cast<std::size_t>(batch_storage[batch]) * n_dofs * n_dofs];
  }
  /** Returns the matrices of a batch, [entry][lane]. */
  const Number *stored_matrices(const std::size_t batch) const
  {
    return &stored[static_cast<std::size_t>(-1 - batch_storage[batch]) * batch_size];
  }
  Number *stored_matrices(const std::size_t batch)
  {
    return &stored[static_cast<std::size_t>(-1 - batch_storage[batch]) * batch_size];
  }
  /** Allocates matrices of its own for a batch. */
  void store(const std::size_t batch)
  {
    batch_storage[batch] = -1 - static_cast<int>(stored.size() / batch_size);
    stored.resize(stored.size() + batch_size);
  }
  std::size_t memory() const
  {
    return batch_storage.capacity() * sizeof(int) +
           (shared.capacity() + stored.capacity()) * sizeof(Number) +
           (rule == nullptr ? 0 : rule->places.memory());
  }

  static constexpr int integrated = std::numeric_limits<int>::min();
  /** The storage of each batch: the number of a shared matrix, -1 - the number of n_lanes stored
   * ones, or integrated. */
  std::vector<int> batch_storage;
  std::vector<Number> shared, stored;
  /** The rule for batches whose products are integrated. */
  std::shared_ptr<const PointRule<dim, Number>> rule;
};

/** Returns the rule of the next coarser level, with its nodes. */
template <int dim, typename Number>
std::shared_ptr<const PointRule<dim, Number>> coarsen(const PointRule<dim, Number> &fine,
                                                      const BlockGrid<dim> &coarse_grid);

/** Returns the matrices of the next coarser level: the energy of functions that are linear along
 * the edges of its cells, the sum over the children of Pᵀ K P. It is computed in double precision:
 * a slender body bends with less energy than rounding to single precision gives to rigid motions of
 * its cells. */
template <int dim>
CellMatrices<dim, double> coarsen(const CellMatrices<dim, double> &fine,
                                  const BlockGrid<dim> &fine_grid,
                                  const BlockGrid<dim> &coarse_grid);
} // namespace Signorini
