// SPDX-License-Identifier: LGPL-2.1-or-later
// Cosine series of functions that are constant on equal intervals.

#include <signorini/discretization/space/cosine_modes.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

namespace Signorini {
using numbers::PI;

CosineModes::CosineModes(const double length, const unsigned int n, const unsigned int size)
  : n(n)
  , frequency(1, 0.)
  , alias(1, 0)
  , amplitude(1, length > 0. ? std::sqrt(length) / n : 1.) {
  for (unsigned int i = 1; i < size && length > 0.; ++i) {
    const unsigned int rest = i % (2 * n);
    frequency.push_back(i * PI / length);
    alias.push_back(std::min(rest, 2 * n - rest) % n);
    amplitude.push_back(std::sqrt(8. / length) / frequency[i] *
                        (rest < n   ? 1.
                         : rest > n ? -1.
                                    : 0.) *
                        std::sin(0.5 * alias[i] * PI / n));
  }
}

FullMatrix<double> discrete_cosines(const unsigned int n) {
  FullMatrix<double> cosines(n, n);
  for (unsigned int p = 0; p < n; ++p)
    for (unsigned int a = 0; a < n; ++a)
      cosines(p, a) = std::cos(PI * p * (a + 0.5) / n);
  return cosines;
}

FullMatrix<double> cosine_eigenvalues(const CosineModes &first, const CosineModes &second,
                                      const double omega_0, const unsigned int n_without) {
  FullMatrix<double> sums(first.n, second.n);
  for (unsigned int i = 0; i < first.alias.size(); ++i) {
    const double square = std::pow(first.amplitude[i], 2);
    const double omega_and_k1 = omega_0 * omega_0 + std::pow(first.frequency[i], 2);
    for (unsigned int j = i < n_without ? n_without : 0; square > 0. && j < second.alias.size();
         ++j)
      sums(first.alias[i], second.alias[j]) +=
        square * std::pow(second.amplitude[j], 2) /
        std::sqrt(omega_and_k1 + std::pow(second.frequency[j], 2));
  }
  return sums;
}
} // namespace Signorini
