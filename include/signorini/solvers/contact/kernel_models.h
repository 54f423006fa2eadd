// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/solvers/contact/boundary_model.h>

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <array>
#include <utility>
#include <vector>

namespace Signorini {
/**
 * The Gram matrix of the characteristic functions of a grid of n_1 x n_2 equal patches on a
 * rectangle L_1 x L_2 in the norm
 *
 *     |q|² = Σ_{k,l ≥ 0} (ω_0² + (k π/L_1)² + (l π/L_2)²)^{-1/2} q_kl²,
 *
 * where q_kl are the coefficients in the orthonormal cosines. On the segment L_1 (n_2 = 1, L_2 = 0)
 * the sum is over k alone.
 *
 * A mode of the grid, cos(k π (i + 1/2)/n), couples with the modes k + 2 n j of the series only,
 * so that discrete cosines diagonalise the matrix. Aliases up to |j| = 8 are summed, the rest is
 * below 1e-4 of the entry. (Only equivalence is needed.)
 *
 * Patch (i, j) has the number i + n_1 j. A product costs four products of small matrices.
 */
class CosineGrid {
public:
  using Vector = dealii::Vector<double>;

  /**
   * Tabulates the matrix.
   * @param lengths L_1 and L_2 (length).
   * @param omega_0 positive (1/length).
   * @param multipliers the number of the multiplier of every patch; empty: that of the patch.
   */
  CosineGrid(const std::array<unsigned int, 2> &sizes, const std::array<double, 2> &lengths,
             double omega_0, std::vector<unsigned int> multipliers = {});

  /** Returns the numbers of the multipliers. */
  const std::vector<unsigned int> &multipliers() const {
    return multipliers_;
  }
  /** Returns the entry for two patches. */
  double entry(unsigned int a, unsigned int b) const;
  /** Sets the entries of the multipliers to the matrix, or its inverse, times those of P. */
  void apply(Vector &product, const Vector &P, bool inverse) const;

private:
  using Matrix = FullMatrix<double>;

  std::array<unsigned int, 2> sizes_;
  std::vector<unsigned int> multipliers_;
  /** The discrete cosines: row mode, column patch. */
  std::array<Matrix, 2> cosines_;
  /** The matrix is diagonal in the discrete cosines: n_1 x n_2 factors. */
  Matrix eigenvalues_;
  /** The table T(a, b) for 0 ≤ a < 2 n_1, 0 ≤ b < 2 n_2: entries are means of T(i -+ i', j -+
   * j'). */
  Matrix table_;
};

/** The model Ĉ = S B S, with B block diagonal with a cosine series on each side, and S a diagonal
 * matrix. */
class CosineModel final : public BoundaryModel {
public:
  /**
   * Makes the model from its blocks.
   * @param scaling the diagonal of S.
   * @param max_factorised_size see BoundaryModel.
   */
  CosineModel(std::vector<CosineGrid> blocks, Vector scaling, unsigned int max_factorised_size);

  unsigned int size() const override {
    return scaling_.size();
  }
  Vector apply(const Vector &P) const override {
    return multiply(P, false);
  }
  Vector apply_inverse(const Vector &P) const override {
    return multiply(P, true);
  }
  double entry(unsigned int i, unsigned int j) const override;

private:
  Vector multiply(const Vector &P, bool inverse) const;

  std::vector<CosineGrid> blocks_;
  Vector scaling_;
  /** The block and the number in its grid of every multiplier. */
  std::vector<std::pair<unsigned int, unsigned int>> places_;
};

/** The model Ĉ as a matrix. */
class KernelModel final : public BoundaryModel {
public:
  explicit KernelModel(Matrix C);

  unsigned int size() const override {
    return C_.m();
  }
  Vector apply(const Vector &P) const override;
  Vector apply_inverse(const Vector &P) const override;
  double entry(const unsigned int i, const unsigned int j) const override {
    return C_(i, j);
  }

private:
  Matrix C_;
  LAPACKFullMatrix<double> L_;
};
} // namespace Signorini
