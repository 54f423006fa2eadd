// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/lac/full_matrix.h>

#include <cmath>

#include "random_numbers.h"

/** M^T M + I for a random M. */
inline dealii::FullMatrix<double> random_matrix(const unsigned int m, RandomNumbers &random) {
  dealii::FullMatrix<double> M(m, m), C(m, m);
  for (unsigned int i = 0; i < m; ++i)
    for (unsigned int j = 0; j < m; ++j)
      M(i, j) = random();
  M.Tmmult(C, M);
  for (unsigned int i = 0; i < m; ++i)
    C(i, i) += 1.;
  return C;
}

/**
 * int int -log|x - y| over pairs of m equal patches of [0,1]: the flexibility of a half-plane, as
 * the compliance of contact problems resembles it. Positive definite on intervals shorter than 4.
 */
inline dealii::FullMatrix<double> logarithmic_kernel(const unsigned int m) {
  // Second differences of the second antiderivative of -log|t|.
  const auto antiderivative = [](const double t) {
    return t == 0. ? 0. : 0.75 * t * t - 0.5 * t * t * std::log(std::abs(t));
  };
  const double H = 1. / m;
  dealii::FullMatrix<double> C(m, m);
  for (unsigned int i = 0; i < m; ++i)
    for (unsigned int j = 0; j < m; ++j) {
      const double d = H * (static_cast<double>(i) - j);
      C(i, j) = antiderivative(d + H) - 2. * antiderivative(d) + antiderivative(d - H);
    }
  return C;
}
