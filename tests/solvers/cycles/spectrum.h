// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/solvers/contact/dual_problem.h>

#include <deal.II/lac/lapack_full_matrix.h>

/** The extreme eigenvalues of B^{-1} C. */
struct Spectrum
{
  double smallest, largest;
  double condition() const
  {
    return largest / smallest;
  }
};

/** By the symmetric matrix L^{-1} C L^{-T}, B = L L^T. */
inline Spectrum spectrum(const dealii::FullMatrix<double> &B, const dealii::FullMatrix<double> &C)
{
  const unsigned int n = B.m();
  dealii::FullMatrix<double> L(n, n), half(C), M(n, n);
  L.cholesky(B);
  // half = L^{-1} C, then M = L^{-1} half^T.
  const auto forward = [&](dealii::FullMatrix<double> &X) {
    for (unsigned int j = 0; j < n; ++j)
      for (unsigned int i = 0; i < n; ++i)
      {
        double value = X(i, j);
        for (unsigned int k = 0; k < i; ++k)
          value -= L(i, k) * X(k, j);
        X(i, j) = value / L(i, i);
      }
  };
  forward(half);
  M.copy_transposed(half);
  forward(M);
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < i; ++j)
      M(j, i) = M(i, j);
  dealii::LAPACKFullMatrix<double> matrix(n, n);
  matrix = M;
  dealii::Vector<double> eigenvalues;
  dealii::FullMatrix<double> eigenvectors;
  matrix.compute_eigenvalues_symmetric(0., 1e30, 0., eigenvalues, eigenvectors);
  return {eigenvalues[0], eigenvalues[eigenvalues.size() - 1]};
}
