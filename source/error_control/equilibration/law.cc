// SPDX-License-Identifier: LGPL-2.1-or-later
// Hooke's law in components, and how much it varies in a cell.

#include <signorini/error_control/equilibration/law.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/lapack_full_matrix.h>
#include <deal.II/lac/vector.h>

#include <algorithm>
#include <cmath>

namespace Signorini {
namespace {
/** Returns Hooke's law in components. */
Tensor<2, 3> matrix_of(const SymmetricTensor<4, 2> &hooke) {
  constexpr std::array<std::array<unsigned int, 2>, 3> pairs = {{{{0, 0}}, {{1, 1}}, {{0, 1}}}};
  Tensor<2, 3> matrix;
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j < 3; ++j)
      matrix[i][j] = hooke[pairs[i][0]][pairs[i][1]][pairs[j][0]][pairs[j][1]];
  return matrix;
}

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

Law::Law(const SymmetricTensor<4, 2> &hooke)
  : stiffness(matrix_of(hooke))
  , compliance(invert(stiffness))
  , min_eigenvalue(min_eigenvalue_of(stiffness)) {}

Tensor<2, 3> upper_bound(const Tensor<2, 3> &A, const Tensor<2, 3> &B) {
  // In orthonormal components (s11, s22, sqrt(2) s12).
  const std::array<double, 3> factors = {{1., 1., std::sqrt(0.5)}};
  SymmetricTensor<2, 3> more;
  LAPACKFullMatrix<double> matrix(3);
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j < 3; ++j)
      more[i][j] = matrix(i, j) = factors[i] * factors[j] * (B[i][j] - A[i][j]);
  Tensor<2, 3> upper = A;
  const double largest = eigenvalues(more)[0], rounding = 1e-14 * A.norm();
  if (largest <= rounding)
    return upper;
  // deal.II's eigenvectors() do not link with clang++.
  dealii::Vector<double> values;
  FullMatrix<double> vectors;
  matrix.compute_eigenvalues_symmetric(0.5 * rounding, 2. * largest, 0., values, vectors);
  for (unsigned int k = 0; k < values.size(); ++k)
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
        upper[i][j] += values[k] * vectors(i, k) * vectors(j, k) / (factors[i] * factors[j]);
  return upper;
}

void Law::soften(const Law &other) {
  compliance = upper_bound(compliance, other.compliance);
  stiffness = invert(compliance);
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

namespace {
/** Returns the norms of Hooke's tensor and of its inverse, and the shares of its entries in the
 * norm. */
std::array<double, 8> features(const SymmetricTensor<4, 2> &C) {
  const Tensor<2, 3> matrix = matrix_of(C), shares = matrix / matrix.norm();
  return {{matrix.norm(), invert(matrix).norm(), shares[0][0], shares[1][1], shares[2][2],
           shares[0][1], shares[0][2], shares[1][2]}};
}
} // namespace

bool law_varies(const Material<2> &material, const std::array<Point<2>, 4> &corners) {
  constexpr unsigned int n = 6;
  constexpr double max_ratio = 1.5, max_difference = 0.4;
  const CellShape shape(corners);
  std::array<double, 8> low, high;
  low.fill(HUGE_VAL);
  high.fill(-HUGE_VAL);
  const QIterated<2> places(QMidpoint<1>(), n);
  for (const Point<2> &at : places.get_points()) {
    const std::array<double, 8> here =
      features(material.relative_hooke(shape.point(CellFunctions(at))));
    for (unsigned int i = 0; i < here.size(); ++i) {
      low[i] = std::min(low[i], here[i]);
      high[i] = std::max(high[i], here[i]);
    }
  }
  for (unsigned int i = 0; i < low.size(); ++i)
    if (i < 2 ? high[i] > max_ratio * low[i] : high[i] - low[i] > max_difference)
      return true;
  return false;
}
} // namespace Signorini
