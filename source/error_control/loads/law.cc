// SPDX-License-Identifier: LGPL-2.1-or-later
// Hooke's law in components.

#include <signorini/error_control/loads/law.h>

#include <cmath>

namespace Signorini {
namespace {
/** Returns the smallest eigenvalue of Hooke's law, in the orthonormal components (s11, s22, sqrt(2)
 * s12). */
double min_eigenvalue_of(const Tensor<2, 3> &C) {
  // Most laws have axes along x and y, and they are evaluated at every point.
  if (C[0][2] == 0. && C[1][2] == 0.)
    return std::min(0.5 * (C[0][0] + C[1][1]) - std::hypot(0.5 * (C[0][0] - C[1][1]), C[0][1]),
                    2. * C[2][2]);
  const double root = std::sqrt(2.);
  return eigenvalues(SymmetricTensor<2, 3>(
    {C[0][0], C[1][1], 2. * C[2][2], C[0][1], root * C[0][2], root * C[1][2]}))[2];
}
} // namespace

Law::Law(const SymmetricTensor<4, 2> &hooke) {
  constexpr std::array<std::array<unsigned int, 2>, 3> pairs = {{{{0, 0}}, {{1, 1}}, {{0, 1}}}};
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j < 3; ++j)
      stiffness[i][j] = hooke[pairs[i][0]][pairs[i][1]][pairs[j][0]][pairs[j][1]];
  compliance = invert(stiffness);
  min_eigenvalue = min_eigenvalue_of(stiffness);
}

Tensor<2, 3> Law::root() const {
  Tensor<2, 3> L;
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j <= i; ++j) {
      const double rest = stiffness[i][j] - L[i] * L[j];
      L[i][j] = i == j ? std::sqrt(rest) : rest / L[j][j];
    }
  return L;
}
} // namespace Signorini
