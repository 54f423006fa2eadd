// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/instructions.h>
#include <signorini/solvers/stiffness/block_grid.h>

#include <boost/container/flat_map.hpp>

#include <memory>
#include <vector>

namespace Signorini {
/** The essential conditions of nodes that are not free: T in u = T u_free. Columns of constrained
 * components are zero, and T_cc = 1 for the others. */
template <int dim>
using ConstrainedNodes = boost::container::flat_map<NodeNumber, Tensor<2, dim>>;

/** Gauss' rule on the reference cell, with the same number of points in each direction. */
template <int dim, typename Number>
struct PointRule {
  explicit PointRule(unsigned int n_points_per_direction);

  std::vector<Number> weights;
  /** The derivatives of the shape functions, [point][vertex][direction]. */
  std::vector<Number> gradients;
};

/**
 * The stiffness K of the cells of one level, without conditions, for a body and a modulus of size
 * one. Batches of n_lanes cells have one matrix that all of them share, or one for each lane, or
 * none where products are integrated. Unknown i = dim v + c of a cell is component c at vertex v.
 */
template <int dim, typename Number>
class CellOperator {
public:
  static constexpr unsigned int n_dofs = dim << dim;
  /** The number of entries of a symmetric matrix: i ≥ j at i (i + 1)/2 + j. */
  static constexpr unsigned int n_entries = n_dofs * (n_dofs + 1) / 2;
  static constexpr std::size_t batch_size = std::size_t(n_entries) * n_lanes;
  static constexpr unsigned int n_strains = dim * (dim + 1) / 2;
  static constexpr unsigned int n_moduli = n_strains * (n_strains + 1) / 2;

  /**
   * Stores the grid.
   * @param n_points of the rule per direction.
   */
  CellOperator(std::shared_ptr<const BlockGrid<dim>> grid, unsigned int n_points)
    : grid(std::move(grid))
    , storage(this->grid->n_batches(), -1)
    , rule(n_points) {}
  /** Copies the operator to another precision, and to another rule where products are integrated.
   */
  template <typename Other>
  CellOperator(const CellOperator<dim, Other> &other, unsigned int n_points);

  /** Returns the operator of the next coarser level: the energy of functions that are linear along
   * the edges of its cells, with matrices Pᵀ K P of double precision: a slender body bends with
   * less energy than rounding to single precision gives to rigid motions of its cells. */
  CellOperator coarsen(std::shared_ptr<const BlockGrid<dim>> coarse_grid) const;

  /** Computes y = K x. */
  void multiply(LevelVector<dim, Number> &y, const LevelVector<dim, Number> &x,
                Instructions instructions = instructions_of_this_machine()) const;
  /** Returns the matrices of a batch, [entry][lane]; valid until the buffer changes. */
  const Number *entries(std::size_t batch, std::vector<Number> &buffer) const;
  /**
   * Integrates the matrices of a batch, [entry][lane].
   * @param moduli at the points, [modulus][lane]: those of the next point follow after @p stride
   * numbers.
   */
  void integrate(Number *K, std::size_t batch, const Number *moduli, std::size_t stride) const;

  /** Makes room for matrices of all batches that share none. */
  void store_matrices();
  bool is_shared(const std::size_t batch) const {
    return storage[batch] >= 0;
  }
  /** Returns the full matrix that a batch shares, n_dofs by n_dofs. */
  const Number *shared_matrix(const std::size_t batch) const {
    return &shared[std::size_t(storage[batch]) * n_dofs * n_dofs];
  }
  /** Returns the stored matrices of a batch, [entry][lane]. */
  const Number *stored_matrices(const std::size_t batch) const {
    return &stored[std::size_t(-1 - storage[batch]) * batch_size];
  }
  Number *stored_matrices(const std::size_t batch) {
    return &stored[std::size_t(-1 - storage[batch]) * batch_size];
  }
  std::size_t memory() const {
    return storage.capacity() * sizeof(int) +
           (shared.capacity() + stored.capacity()) * sizeof(Number) + positions.memory();
  }

  std::shared_ptr<const BlockGrid<dim>> grid;
  /** The matrices of each batch: the number of a shared one, or -1 - the number of stored ones. */
  std::vector<int> storage;
  std::vector<Number> shared, stored;
  /** The rule of integrated batches, the positions of nodes in the body of size one, and the moduli
   * E/E_0 in Voigt's notation, by rows of the lower triangle; 11, 22, (33,) 12, (13, 23), the same
   * for each lane. Empty where nothing is integrated. */
  PointRule<dim, Number> rule;
  LevelVector<dim, Number> positions;
  std::vector<Number> moduli;
};

/** Symmetric matrices of nodes: the entries on the diagonal, then (0,1), (0,2), (1,2). */
template <int dim>
using NodeBlocks = LevelVector<dim *(dim + 1) / 2, float>;

/** Returns the diagonal blocks of nodes of the matrix that would be assembled. */
template <int dim>
NodeBlocks<dim> diagonal_blocks(const CellOperator<dim, float> &K);

/** Returns a bound of the eigenvalues of D⁻¹ A, with the diagonal blocks D of nodes: the largest
 * eigenvalue of all cells. With the diagonal blocks D_K of the matrix A_K of a cell, x.A x = Σ
 * x.A_K x ≤ λ Σ x.D_K x = λ x.D x, whatever conditions hold. */
template <int dim>
double max_cell_eigenvalue(const CellOperator<dim, float> &K);

/** Does a step of the smoother, d = α d + γ B (b - y) and x += d, with the inverses B of diagonal
 * blocks. The first step takes x = d = y = 0 for granted. */
template <int dim>
struct SmootherStep {
  LevelVector<dim, float> &x, &d;
  const LevelVector<dim, float> &b, &y;
  const NodeBlocks<dim> &B;
  float alpha, gamma;
  bool is_first;

  void run(Instructions instructions = instructions_of_this_machine()) const;
};
} // namespace Signorini
