// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/discretization/mesh/contact_surface.h>

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <array>
#include <complex>
#include <vector>

namespace Signorini {
/** The dual of the interpolation norm between L2 and H1 on one side of a body of dimension dim, by
 * cosine series. */
template <int dim>
class CosineNorm;

/**
 * The norm on a side of length L:
 *
 *     ‖q‖²_{-1/2} = Σ_{k≥0} (1 + (k π/L)²)^{-1/2} q_k²,
 *     q_0 = L^{-1/2} ∫ q,   q_k = (2/L)^{1/2} ∫ q cos(k π s/L).
 *
 * On a closed side the frequencies k π/L become 2 k π/L, and sines join the cosines.
 *
 * 8192 modes are summed; the remainder of piecewise constants is estimated by the mean over the
 * last modes, (2/L) ω^{-3} mean(S_k²)/(2 K²), where ω k is the frequency of mode k and S_k
 * the sum of jumps times sin(k ω s_i) (and of jumps times cos).
 */
template <>
class CosineNorm<2> {
public:
  using Vector = dealii::Vector<double>;
  /** The coefficients q_k; on a closed side those of the cosine and of the sine of mode k. */
  using Modes = std::vector<std::complex<double>>;

  explicit CosineNorm(double length, bool closed = false);
  explicit CosineNorm(const Side<2> &side)
    : CosineNorm(side.length(), side.is_closed()) {}

  /** Returns the coefficients q_k of a function given by its values times quadrature weights. */
  Modes coefficients(const std::vector<double> &arc_lengths,
                     const std::vector<double> &weighted_values) const;

  /** Returns the coefficients of a piecewise constant function, values[i] from ends[i] to
   * ends[i+1]. */
  Modes coefficients_of_constants(const std::vector<double> &ends, const Vector &values) const;

  /** Returns ‖f - q_H‖ for a continuous f with the coefficients @p f (empty: f = 0) and a piecewise
   * constant q_H. */
  double distance(const Modes &f, const std::vector<double> &ends, const Vector &values) const;
  /** Returns the same for the constants P on the patches of a side. */
  double distance(const Modes &f, const PatchGrid &grid, const Vector &P) const;

  /** Returns the norm to which this one is dual, ‖f‖²_{1/2} = sum (1 + (k π/L)²)^{1/2} f_k², of a
   * continuous function with the coefficients @p f that is smooth on each of @p n_pieces intervals:
   * f_k ~ k^-2. The remainder beyond the modes is estimated by the mean of k⁴ f_k² over the last of
   * them. */
  double primal_norm(const Modes &f, unsigned int n_pieces) const;

  /** Returns the Gram matrix of the characteristic functions of the intervals. */
  FullMatrix<double> gram_matrix(const std::vector<double> &ends) const;
  FullMatrix<double> gram_matrix(const PatchGrid &grid) const {
    return gram_matrix(grid.ends[0]);
  }

private:
  /** Returns (1 + (k ω)²)^{-1/2}. */
  double weight(unsigned int k) const;
  /** Returns the weight of |q_k|² for constants on m intervals; the last modes count for the
   * infinitely many after them, too. */
  double weight_with_tail(unsigned int k, unsigned int m) const;
  /** Returns the number of the last modes that make a mean for m intervals. */
  unsigned int n_tail_modes(unsigned int m) const;
  /** Returns q_k for the integrals ∫ q e^{i k ω s}. */
  Modes normalised(Modes modes) const;

  double length_;
  bool closed_;
  /** The frequency π/L, on a closed side 2 π/L. */
  double omega_;
  unsigned int n_modes_;
};

/**
 * The norm on a rectangle with the edges L_1 and L_2:
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
template <>
class CosineNorm<3> {
public:
  using Matrix = FullMatrix<double>;
  using Modes = Matrix;
  using Counts = std::array<unsigned int, 2>;
  /** The number of the coefficients of a function, per direction. */
  static constexpr unsigned int n_modes = 256;

  explicit CosineNorm(const std::array<double, 2> &lengths);
  explicit CosineNorm(const Side<3> &side)
    : CosineNorm(side.rectangle()) {}

  /** Returns q_ij for i, j < n_modes of a function with given values times weights at points of a
   * grid, @p weighted_values (a, b) at (positions[0][a], positions[1][b]). */
  Matrix coefficients(const std::array<std::vector<double>, 2> &positions,
                      const Matrix &weighted_values) const;

  /** Returns ‖f - q_H‖ for a function with the coefficients @p f, nothing beyond n_modes (empty: f
   * = 0), and q_H with values on m(0) x m(1) equal patches. */
  double distance(const Matrix &f, const Matrix &values) const;
  /** Returns the same for the constants P on the patches of a side. */
  double distance(const Matrix &f, const PatchGrid &grid, const dealii::Vector<double> &P) const;

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
  Matrix gram_matrix(const PatchGrid &grid) const;

private:
  std::array<double, 2> lengths_;
};

/**
 * Returns equal cells whose unions the patches are, for CosineNorm<3>::gram_matrix(): the patches,
 * or, where the last ones are longer, a common divisor of all of them.
 * @throws ComputationError if there are none.
 */
std::array<std::vector<unsigned int>, 2> equal_cells(const PatchGrid &grid);

/** Returns the values on these cells, column by row. */
FullMatrix<double> values_on(const PatchGrid &grid, const dealii::Vector<double> &P);
/** Returns the block diagonal Gram matrix of the constants on the patches: the square of its norm
 * is the sum over the sides. */
template <int dim>
FullMatrix<double> dual_gram_matrix(const ContactSurface<dim> &surface);
} // namespace Signorini
