// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/solvers/contact/dual_problem.h>

#include <deal.II/lac/lapack_full_matrix.h>

/** The extreme eigenvalues of B^{-1} C. */
struct Spectrum {
  double smallest, largest;
  double condition() const {
    return largest / smallest;
  }
};

inline Spectrum spectrum(const dealii::FullMatrix<double> &B, const dealii::FullMatrix<double> &C) {
  dealii::LAPACKFullMatrix<double> C_copy(C.m(), C.n()), B_copy(B.m(), B.n());
  C_copy = C;
  B_copy = B;
  std::vector<dealii::Vector<double>> no_eigenvectors;
  C_copy.compute_generalized_eigenvalues_symmetric(B_copy, no_eigenvectors);
  return {C_copy.eigenvalue(0).real(), C_copy.eigenvalue(C.m() - 1).real()};
}
