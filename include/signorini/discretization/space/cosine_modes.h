// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>

#include <deal.II/lac/full_matrix.h>

#include <vector>

namespace Signorini {
/**
 * The cosines cos(k s), k = π i/L, i = 0, 1, ..., of an edge of length L that is divided into n
 * equal intervals. On the middles of the intervals mode i equals the mode p < n with i = 2 n r ± p,
 * up to its sign.
 */
struct CosineModes {
  /** @param size the number of modes. For L = 0 there is one, the constant of value one. */
  CosineModes(double length, unsigned int n, unsigned int size);

  unsigned int n;
  std::vector<double> frequency;
  /** The mode p < n that equals mode i on the middles of the intervals. */
  std::vector<unsigned int> alias;
  /** The coefficient c ∫ q cos(k s), c_0 = L^{-1/2}, else (2/L)^{1/2}, of the function q with the
   * value cos(p π (a + 1/2)/n) on interval a, divided by the sum of the squares of these cosines;
   * zero where mode i vanishes there. */
  std::vector<double> amplitude;
};

/** Returns cos(p π (a + 1/2)/n), row p and column a. */
FullMatrix<double> discrete_cosines(unsigned int n);

/**
 * Returns λ_pq with Σ (ω_0² + |k|²)^{-1/2} q_ij² = Σ λ_pq Q_pq² for a function q that is constant
 * on the n_1 x n_2 products of intervals: the sum on the left over all products of modes of two
 * edges, without those below @p n_without in both directions, and Q_pq = Σ_ab q_ab cos(p π (a +
 * 1/2)/n_1) cos(q π (b + 1/2)/n_2).
 */
FullMatrix<double> cosine_eigenvalues(const CosineModes &first, const CosineModes &second,
                                      double omega_0, unsigned int n_without = 0);
} // namespace Signorini
