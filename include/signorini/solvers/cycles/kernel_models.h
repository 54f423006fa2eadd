// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/solvers/cycles/boundary_model.h>

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <array>
#include <utility>
#include <vector>

namespace Signorini
{
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
class CosineGrid
{
public:
  using Vector = dealii::Vector<double>;

  /**
   * Tabulates the matrix.
   * @param lengths L_1 and L_2 (length).
   * @param omega_0 positive (1/length).
   */
  CosineGrid(const std::array<unsigned int, 2> &sizes,
             const std::array<double, 2> &lengths,
             double omega_0);

  /** Returns n_1 n_2. */
  unsigned int size() const
  {
    return sizes_[0] * sizes_[1];
  }
  /** Returns the entry for two patches. */
  double entry(unsigned int a, unsigned int b) const;
  /** Returns the matrix times a vector. */
  Vector apply(const Vector &P) const;
  /** Returns the inverse of the matrix times a vector. */
  Vector apply_inverse(const Vector &P) const;

private:
  using Matrix = FullMatrix<double>;

  /** Fills eigenvalues_. */
  void sum_aliases(const std::array<double, 2> &lengths, double omega_0);
  /** Fills table_. */
  void tabulate_entries();
  /** Returns Q_1 (factors .* (Q_1ᵀ P Q_2)) Q_2ᵀ. */
  Vector transform(const Vector &P, const Matrix &factors) const;

  std::array<unsigned int, 2> sizes_;
  /** The orthonormal cosines: row patch, column mode. */
  std::array<Matrix, 2> cosines_;
  /** The eigenvalues of the modes and their inverses, n_1 x n_2. */
  Matrix eigenvalues_, inverse_eigenvalues_;
  /** The table T(a, b) for 0 ≤ a < 2 n_1, 0 ≤ b < 2 n_2: entries are means of T(i -+ i', j -+
   * j'). */
  Matrix table_;
};

/** The patches of one side as a grid. */
struct GridBlock
{
  CosineGrid grid;
  /** The number of the multiplier of every patch of the grid. */
  std::vector<unsigned int> multipliers;
};

/** The model Ĉ = S B S, with B block diagonal with a cosine series on each side, and S a diagonal
 * matrix. */
class CosineModel final : public BoundaryModel
{
public:
  /**
   * Makes the model from its blocks.
   * @param scaling the diagonal of S.
   * @param max_factorised_size see BoundaryModel.
   */
  CosineModel(std::vector<GridBlock> blocks, Vector scaling, unsigned int max_factorised_size);

  unsigned int size() const override;
  Vector apply(const Vector &P) const override;
  Vector apply_inverse(const Vector &P) const override;
  double entry(unsigned int i, unsigned int j) const override;

private:
  std::vector<GridBlock> blocks_;
  Vector scaling_;
  /** The block and the number in its grid of every multiplier. */
  std::vector<std::pair<unsigned int, unsigned int>> places_;
};

/** A patch of the kernel: a segment in 2-D, or a rectangle in 3-D. */
template <int dim>
struct FlatPatch
{
  Point<dim> corner;
  /** The edges, as vectors from the corner. */
  std::array<Tensor<1, dim>, dim - 1> edges;
  /** The measure of the patch itself; that of the segment or rectangle may be smaller. */
  double measure;

  Point<dim> centre() const;
  double diameter() const;
};

/**
 * Returns the displacement of the half-space, without its factor 2/(π E'): ∫ k(x - y) dy over
 * the patch, with k = -log(|x - y|/R) in 2-D and 1/(2 |x - y|) in 3-D. It is exact for segments and
 * rectangles.
 * @param radius R; it has no meaning in 3-D.
 */
template <int dim>
double patch_potential(const FlatPatch<dim> &patch, const Point<dim> &x, double radius);

/** Returns ∫∫ k(x - y) over two patches. The inner integral is exact, the outer one by Gauss'
 * rule with two points per direction, or with four where the patches are near. Far away it is the
 * product of the measures times k between the centres. The interaction is symmetric. */
template <int dim>
double patch_interaction(const FlatPatch<dim> &a, const FlatPatch<dim> &b, double radius);

/** The model Ĉ as a matrix. */
class KernelModel final : public BoundaryModel
{
public:
  explicit KernelModel(Matrix C);

  unsigned int size() const override;
  Vector apply(const Vector &P) const override;
  Vector apply_inverse(const Vector &P) const override;
  double entry(unsigned int i, unsigned int j) const override;

private:
  Matrix C_;
  LAPACKFullMatrix<double> L_;
};
} // namespace Signorini
