// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <vector>

namespace Signorini
{
/** Q = L L^T for the few unknowns of free motions. */
class SmallCholesky
{
public:
  /** @throws std::invalid_argument if Q is not positive definite. */
  explicit SmallCholesky(const dealii::FullMatrix<double> &Q);

  /** Q^{-1} x. */
  dealii::Vector<double> solve(const dealii::Vector<double> &x) const;
  /** L^{-1} x. */
  dealii::Vector<double> forward(const dealii::Vector<double> &x) const;

private:
  dealii::FullMatrix<double> L_;
};

/** An orthonormal basis of vectors, and one of everything that is orthogonal to them. */
struct Splitting
{
  std::vector<dealii::Vector<double>> null, rest;
};

/** By singular values: |M v| <= threshold for unit vectors v in `null`; M is n x k, k small. */
Splitting split_by_size(const dealii::FullMatrix<double> &M, double threshold);

/** M x and M^T y, also for matrices without rows or columns. */
dealii::Vector<double> times(const dealii::FullMatrix<double> &M, const dealii::Vector<double> &x);
dealii::Vector<double> transpose_times(const dealii::FullMatrix<double> &M,
                                       const dealii::Vector<double> &y);
} // namespace Signorini
