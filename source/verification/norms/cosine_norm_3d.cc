// SPDX-License-Identifier: LGPL-2.1-or-later
// |||.|||_{-1/2} on rectangles by cosine series in both directions.

#include <signorini/base/errors.h>
#include <signorini/discretization/space/cosine_modes.h>
#include <signorini/verification/norms/cosine_norm.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

namespace Signorini {
namespace {
/** The cosines that are summed one by one on an edge of n equal intervals, in whole periods 2 n,
 * and the sum of the others. */
struct EdgeModes : CosineModes {
  EdgeModes(const double length, const unsigned int n, const unsigned int at_least)
    : CosineModes(length, n, whole_periods(n, at_least))
    , end(frequency.size() * numbers::PI / length) {
    for (unsigned int p = 0; p < n; ++p)
      density.push_back(8. * std::pow(std::sin(0.5 * p * numbers::PI / n), 2) / (numbers::PI * n));
  }
  static unsigned int whole_periods(const unsigned int n, const unsigned int at_least) {
    constexpr unsigned int n_periods = 16;
    const unsigned int period = 2 * n;
    return period * std::max(n_periods, (at_least + period - 1) / period);
  }

  /** The first frequency that is not summed by itself. */
  double end;
  /** The sum of amplitude² k² over the modes like p from the end on, for each unit of frequency. */
  std::vector<double> density;
};

/** Returns the integral of k^-2 (1 + a² + k²)^{-1/2} over k > K. */
double edge_tail(const double a, const double K) {
  return 1. / (K * (std::sqrt(1. + a * a + K * K) + K));
}

/** Returns the integral of k_1^-2 k_2^-2 |k|⁻¹ over k_1 > A, k_2 > B. */
double corner_tail(const double A, const double B) {
  const double c = std::pow(A * A + B * B, 1.5) - A * A * A - B * B * B;
  return c / (3. * A * A * A * B * B * B);
}

/** Returns the columns of the cells of every patch added up. */
FullMatrix<double> sum_over_patches(const FullMatrix<double> &cell_columns,
                                    const std::vector<unsigned int> &ends) {
  FullMatrix<double> sums(cell_columns.m(), ends.size() - 1);
  for (unsigned int p = 0; p < sums.m(); ++p)
    for (unsigned int i = 0; i < sums.n(); ++i)
      for (unsigned int a = ends[i]; a < ends[i + 1]; ++a)
        sums(p, i) += cell_columns(p, a);
  return sums;
}

/** The number of cells along an edge above which a divisor is due to rounding. */
constexpr double max_cells = 1e5;
/** The rounding error of lengths, relative to an edge. */
constexpr double edge_rounding = 1e-9;

/** Returns the common divisor of two lengths that are known up to @p rounding, by Euclid's
 * algorithm. */
double common_divisor(double a, double b, const double rounding) {
  while (b > rounding) {
    const double rest = std::abs(std::remainder(a, b));
    a = b;
    b = rest;
  }
  return a;
}

/** Returns A B Cᵀ. */
FullMatrix<double> transform(const FullMatrix<double> &A, const FullMatrix<double> &B,
                             const FullMatrix<double> &C) {
  FullMatrix<double> product(A.m(), B.n()), result(A.m(), C.m());
  A.mmult(product, B);
  product.mTmult(result, C);
  return result;
}

/** Returns the remainder of the modes of one edge with those beyond the end of the other. */
FullMatrix<double> tail(const EdgeModes &along, const EdgeModes &across) {
  FullMatrix<double> sums(along.density.size(), across.density.size());
  for (unsigned int i = 0; i < along.alias.size(); ++i) {
    const double factor =
      std::pow(along.amplitude[i], 2) * edge_tail(along.frequency[i], across.end);
    for (unsigned int q = 0; q < sums.n(); ++q)
      sums(along.alias[i], q) += factor * across.density[q];
  }
  return sums;
}
} // namespace

CosineNorm<3>::CosineNorm(const std::array<double, 2> &lengths)
  : lengths_(lengths) {}

FullMatrix<double> CosineNorm<3>::coefficients(const std::array<std::vector<double>, 2> &positions,
                                               const Matrix &weighted_values) const {
  std::array<Matrix, 2> cosines;
  for (unsigned int d = 0; d < 2; ++d) {
    cosines[d].reinit(n_modes, positions[d].size());
    for (unsigned int i = 0; i < n_modes; ++i) {
      const double c = std::sqrt((i == 0 ? 1. : 2.) / lengths_[d]);
      for (std::size_t a = 0; a < positions[d].size(); ++a)
        cosines[d](i, a) = c * std::cos(numbers::PI * i * positions[d][a] / lengths_[d]);
    }
  }
  return transform(cosines[0], weighted_values, cosines[1]);
}

FullMatrix<double> CosineNorm<3>::eigenvalues(const Counts &n_patches,
                                              const unsigned int n_without) const {
  const EdgeModes first(lengths_[0], n_patches[0], n_without);
  const EdgeModes second(lengths_[1], n_patches[1], n_without);
  Matrix sums = cosine_eigenvalues(first, second, 1., n_without);
  sums.add(1., tail(first, second));
  const Matrix beyond_first = tail(second, first);
  const double corner = corner_tail(first.end, second.end);
  for (unsigned int p = 0; p < sums.m(); ++p)
    for (unsigned int q = 0; q < sums.n(); ++q)
      sums(p, q) += beyond_first(q, p) + corner * first.density[p] * second.density[q];
  return sums;
}

double CosineNorm<3>::distance(const Matrix &f, const Matrix &values) const {
  const Counts n = {{static_cast<unsigned int>(values.m()), static_cast<unsigned int>(values.n())}};
  const Matrix Q = transform(discrete_cosines(n[0]), values, discrete_cosines(n[1]));
  const EdgeModes first(lengths_[0], n[0], f.m()), second(lengths_[1], n[1], f.m());
  double square = 0.;
  for (unsigned int i = 0; i < f.m(); ++i)
    for (unsigned int j = 0; j < f.n(); ++j) {
      const double q_H =
        first.amplitude[i] * second.amplitude[j] * Q(first.alias[i], second.alias[j]);
      const double k = std::hypot(first.frequency[i], second.frequency[j]);
      square += std::pow(f(i, j) - q_H, 2) / std::hypot(1., k);
    }
  const Matrix beyond = eigenvalues(n, f.m());
  for (unsigned int p = 0; p < n[0]; ++p)
    for (unsigned int q = 0; q < n[1]; ++q)
      square += beyond(p, q) * Q(p, q) * Q(p, q);
  return std::sqrt(square);
}

FullMatrix<double>
CosineNorm<3>::gram_matrix(const std::array<std::vector<unsigned int>, 2> &ends) const {
  const Counts n_cells = {{ends[0].back(), ends[1].back()}};
  const Matrix lambda = eigenvalues(n_cells);
  const Matrix x = sum_over_patches(discrete_cosines(n_cells[0]), ends[0]);
  const Matrix y = sum_over_patches(discrete_cosines(n_cells[1]), ends[1]);
  const unsigned int m = x.n() * y.n();
  Matrix weighted(m, n_cells[0] * n_cells[1]), gram(m, m);
  for (unsigned int j = 0; j < y.n(); ++j)
    for (unsigned int i = 0; i < x.n(); ++i)
      for (unsigned int q = 0; q < n_cells[1]; ++q)
        for (unsigned int p = 0; p < n_cells[0]; ++p)
          weighted(i + x.n() * j, p + n_cells[0] * q) = std::sqrt(lambda(p, q)) * x(p, i) * y(q, j);
  weighted.mTmult(gram, weighted);
  return gram;
}

double CosineNorm<3>::distance(const Matrix &f, const PatchGrid &grid,
                               const dealii::Vector<double> &P) const {
  return distance(f, values_on(grid, P));
}

FullMatrix<double> CosineNorm<3>::gram_matrix(const PatchGrid &grid) const {
  return gram_matrix(equal_cells(grid));
}

std::array<std::vector<unsigned int>, 2> equal_cells(const PatchGrid &grid) {
  std::array<std::vector<unsigned int>, 2> numbers;
  for (unsigned int d = 0; d < 2; ++d) {
    const std::vector<double> &ends = grid.ends[d];
    double cell = grid.length(d);
    for (std::size_t i = 0; i + 1 < ends.size(); ++i)
      cell = common_divisor(cell, ends[i + 1] - ends[i], edge_rounding * grid.length(d));
    for (const double s : ends) {
      const double number = (s - ends[0]) / cell;
      if (std::abs(number - std::round(number)) > 0.01 || number > max_cells)
        throw ComputationError(
          "The norm of order -1/2 in space needs patches that are unions of equal cells.");
      numbers[d].push_back(static_cast<unsigned int>(std::round(number)));
    }
  }
  return numbers;
}

FullMatrix<double> values_on(const PatchGrid &grid, const dealii::Vector<double> &P) {
  const auto ends = equal_cells(grid);
  FullMatrix<double> values(ends[0].back(), ends[1].back());
  for (unsigned int i = 0; i < grid.n(0); ++i)
    for (unsigned int j = 0; j < grid.n(1); ++j)
      for (unsigned int a = ends[0][i]; a < ends[0][i + 1]; ++a)
        for (unsigned int b = ends[1][j]; b < ends[1][j + 1]; ++b)
          values(a, b) = P[grid.at(i, j)];
  return values;
}
} // namespace Signorini
