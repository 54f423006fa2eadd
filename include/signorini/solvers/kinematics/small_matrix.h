// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <vector>

namespace Signorini
{
/** The Cholesky factorisation Q = L Lᵀ for the few unknowns of free motions. */
class SmallCholesky
{
public:
  /**
   * Factorises Q.
   * @throws std::invalid_argument if Q is not positive definite.
   */
  explicit SmallCholesky(const dealii::FullMatrix<double> &Q);

  /** Returns Q⁻¹ x. */
  dealii::Vector<double> solve(const dealii::Vector<double> &x) const;
  /** Returns L⁻¹ x. */
  dealii::Vector<double> forward(const dealii::Vector<double> &x) const;

private:
  dealii::FullMatrix<double> L_;
};

/** An orthonormal basis of a null space, and one of its orthogonal complement. */
struct Splitting
{
  std::vector<dealii::Vector<double>> null, rest;
};

/** Splits the space by singular values: |M v| ≤ threshold for unit vectors v in `null`; M is n x
 * k, k small. */
Splitting split_by_size(const dealii::FullMatrix<double> &M, double threshold);

/** times() returns M x, transpose_times() Mᵀ y, also for matrices without rows or columns. */
dealii::Vector<double> times(const dealii::FullMatrix<double> &M, const dealii::Vector<double> &x);
dealii::Vector<double> transpose_times(const dealii::FullMatrix<double> &M,
                                       const dealii::Vector<double> &y);
} // namespace Signorini
