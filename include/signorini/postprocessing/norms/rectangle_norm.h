// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/discretization/mesh/contact_surface.h>

#include <deal.II/lac/full_matrix.h>

#include <array>
#include <vector>

namespace Signorini {
/**
 * The dual of the interpolation norm between L2 and H1 on a rectangle with the edges L_1 and L_2:
 *
 *     ‖q‖²_{-1/2} = Σ_{i,j≥0} (1 + |k|²)^{-1/2} q_ij²,   k = π (i/L_1, j/L_2),
 *     q_ij = c_i c_j ∫ q cos(k_1 s_1) cos(k_2 s_2),   c_0 = L^{-1/2}, else (2/L)^{1/2}.
 *
 * On n_1 x n_2 equal patches the functions cos(p π (a + 1/2)/n_1) cos(q π (b + 1/2)/n_2) of the
 * patches' numbers a, b are orthogonal in this norm: the modes whose numbers i are 2 n_1 r ± p
 * equal mode p there, with q_i ~ sin(p π/(2 n_1))/k_1. The sums over them take 16 periods 2 n in
 * each direction one by one and the rest as an integral, for a relative error below 1e-5
 * (measured).
 */
class RectangleNorm {
public:
  using Matrix = FullMatrix<double>;
  using Counts = std::array<unsigned int, 2>;
  /** The number of the coefficients of a function, per direction. */
  static constexpr unsigned int n_modes = 256;

  explicit RectangleNorm(const std::array<double, 2> &lengths);

  /** Returns q_ij for i, j < n_modes of a function with given values times weights at points of a
   * grid, @p weighted_values (a, b) at (positions[0][a], positions[1][b]). */
  Matrix coefficients(const std::array<std::vector<double>, 2> &positions,
                      const Matrix &weighted_values) const;

  /** Returns ‖f - q_H‖ for a function with the coefficients @p f, nothing beyond n_modes (empty: f
   * = 0), and q_H with values on m(0) x m(1) equal patches. */
  double distance(const Matrix &f, const Matrix &values) const;

  /** Returns λ_pq: ‖q_H‖² = sum λ_pq Q_pq² with Q_pq = Σ_ab q_ab cos(p π (a + 1/2)/n_1) cos(q π (b
   * + 1/2)/n_2), where q_ab is the value on a patch; without the modes below @p n_without in both
   * directions. */
  Matrix eigenvalues(const Counts &n_patches, unsigned int n_without = 0) const;

  /**
   * Returns the Gram matrix of the characteristic functions of patches that are unions of n_1 x n_2
   * equal cells.
   * @param ends in both directions the numbers of the cells with which the patches begin, and n;
   * the patch of column i and row j is the function i + j (number of columns).
   */
  Matrix gram_matrix(const std::array<std::vector<unsigned int>, 2> &ends) const;

private:
  std::array<double, 2> lengths_;
};

/** Returns the norm of a side. */
RectangleNorm rectangle_norm_on(const PatchGrid &grid);

/**
 * Returns equal cells whose unions the patches are, for RectangleNorm::gram_matrix(): the patches,
 * or, where the last ones are longer, a common divisor of all of them.
 * @throws ComputationError if there are none.
 */
std::array<std::vector<unsigned int>, 2> equal_cells(const PatchGrid &grid);

/** Returns the values on these cells, column by row. */
FullMatrix<double> values_on(const PatchGrid &grid, const dealii::Vector<double> &P);
} // namespace Signorini
