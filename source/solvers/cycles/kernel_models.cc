// SPDX-License-Identifier: LGPL-2.1-or-later
// Discrete cosines diagonalise the H^{-1/2} Gram matrix of equal patches.

#include <signorini/solvers/cycles/kernel_models.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace Signorini {
namespace {
using Matrix = FullMatrix<double>;
using numbers::PI;

constexpr int n_aliases = 8;

/** Returns (c_k/n)^{1/2} cos(k π (i + 1/2)/n), c_0 = 1, c_k = 2. */
Matrix orthonormal_cosines(const unsigned int n) {
  Matrix cosines(n, n);
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int k = 0; k < n; ++k)
      cosines(i, k) = std::sqrt((k == 0 ? 1. : 2.) / n) * std::cos(k * PI * (i + 0.5) / n);
  return cosines;
}

/** Returns c_k/n cos(k π a/n) for 0 ≤ a < 2 n. */
Matrix differences(const unsigned int n) {
  Matrix cosines(2 * n, n);
  for (unsigned int a = 0; a < 2 * n; ++a)
    for (unsigned int k = 0; k < n; ++k)
      cosines(a, k) = (k == 0 ? 1. : 2.) / n * std::cos(k * PI * a / n);
  return cosines;
}

/** A mode of the series: the square of its frequency, and the square of the share of it that
 * patches resolve. */
struct Alias {
  double square_of_frequency, share;
};

/** Returns the modes k + 2 n j of the series, with (sin x/x)² for x = ω h/2. */
std::vector<Alias> aliases_of(const unsigned int k, const unsigned int n, const double length) {
  if (length <= 0.)
    return {{0., 1.}};
  std::vector<Alias> aliases;
  for (int j = -n_aliases; j <= n_aliases; ++j) {
    const double x = 0.5 * PI * (k / double(n) + 2. * j);
    const double sinc = x == 0. ? 1. : std::sin(x) / x;
    const double frequency = 2. * x * n / length;
    // The mode 0 meets itself only: sin(j π) = 0.
    if (k > 0 || j == 0)
      aliases.push_back({frequency * frequency, sinc * sinc});
  }
  return aliases;
}
} // namespace

CosineGrid::CosineGrid(const std::array<unsigned int, 2> &sizes,
                       const std::array<double, 2> &lengths, const double omega_0,
                       std::vector<unsigned int> multipliers)
  : sizes_(sizes)
  , multipliers_(std::move(multipliers))
  , cosines_{orthonormal_cosines(sizes[0]), orthonormal_cosines(sizes[1])}
  , eigenvalues_(sizes[0], sizes[1])
  , table_(2 * sizes[0], 2 * sizes[1]) {
  if (multipliers_.empty()) {
    multipliers_.resize(sizes[0] * sizes[1]);
    std::iota(multipliers_.begin(), multipliers_.end(), 0U);
  }
  double measure = 1.;
  for (unsigned int d = 0; d < 2; ++d)
    measure *= lengths[d] > 0. ? lengths[d] / sizes[d] : 1.;
  for (unsigned int l = 0; l < sizes[1]; ++l) {
    const std::vector<Alias> second = aliases_of(l, sizes[1], lengths[1]);
    for (unsigned int k = 0; k < sizes[0]; ++k)
      for (const Alias &a : aliases_of(k, sizes[0], lengths[0]))
        for (const Alias &b : second)
          eigenvalues_(k, l) +=
            measure * a.share * b.share /
            std::sqrt(omega_0 * omega_0 + a.square_of_frequency + b.square_of_frequency);
  }
  const Matrix first = differences(sizes[0]), second = differences(sizes[1]);
  Matrix product(2 * sizes[0], sizes[1]);
  first.mmult(product, eigenvalues_);
  product.mTmult(table_, second);
}

double CosineGrid::entry(const unsigned int a, const unsigned int b) const {
  const unsigned int i = a % sizes_[0], j = a / sizes_[0];
  const unsigned int k = b % sizes_[0], l = b / sizes_[0];
  const unsigned int minus_1 = i > k ? i - k : k - i, plus_1 = i + k + 1;
  const unsigned int minus_2 = j > l ? j - l : l - j, plus_2 = j + l + 1;
  return 0.25 * (table_(minus_1, minus_2) + table_(plus_1, minus_2) + table_(minus_1, plus_2) +
                 table_(plus_1, plus_2));
}

void CosineGrid::apply(Vector &product, const Vector &P, const bool inverse) const {
  const unsigned int n = sizes_[0], m = sizes_[1];
  Matrix values(n, m), half(n, m), modes(n, m);
  for (unsigned int j = 0; j < m; ++j)
    for (unsigned int i = 0; i < n; ++i)
      values(i, j) = P[multipliers_[i + n * j]];
  cosines_[0].Tmmult(half, values);
  half.mmult(modes, cosines_[1]);
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < m; ++j)
      modes(i, j) *= inverse ? 1. / eigenvalues_(i, j) : eigenvalues_(i, j);
  cosines_[0].mmult(half, modes);
  half.mTmult(values, cosines_[1]);
  for (unsigned int j = 0; j < m; ++j)
    for (unsigned int i = 0; i < n; ++i)
      product[multipliers_[i + n * j]] = values(i, j);
}

// Ĉ on sides that are grids of equal patches.

CosineModel::CosineModel(std::vector<CosineGrid> blocks, Vector scaling,
                         const unsigned int max_factorised_size)
  : BoundaryModel(max_factorised_size)
  , blocks_(std::move(blocks))
  , scaling_(std::move(scaling))
  , places_(scaling_.size()) {
  for (unsigned int b = 0; b < blocks_.size(); ++b)
    for (unsigned int a = 0; a < blocks_[b].multipliers().size(); ++a)
      places_[blocks_[b].multipliers()[a]] = {b, a};
}

CosineModel::Vector CosineModel::multiply(const Vector &P, const bool inverse) const {
  Vector scaled(P), product(P.size());
  const auto scale = [&](Vector &values) {
    for (unsigned int k = 0; k < values.size(); ++k)
      values[k] *= inverse ? 1. / scaling_[k] : scaling_[k];
  };
  scale(scaled);
  for (const CosineGrid &block : blocks_)
    block.apply(product, scaled, inverse);
  scale(product);
  return product;
}

double CosineModel::entry(const unsigned int i, const unsigned int j) const {
  if (places_[i].first != places_[j].first)
    return 0.;
  return scaling_[i] * scaling_[j] *
         blocks_[places_[i].first].entry(places_[i].second, places_[j].second);
}

// Ĉ by the kernel of the half space.

KernelModel::KernelModel(Matrix C)
  : BoundaryModel(std::numeric_limits<unsigned int>::max())
  , C_(std::move(C))
  , L_(C_.m(), C_.m()) {
  L_ = C_;
  L_.set_property(LAPACKSupport::symmetric);
  L_.compute_cholesky_factorization();
}

KernelModel::Vector KernelModel::apply(const Vector &P) const {
  Vector product(size());
  C_.vmult(product, P);
  return product;
}

KernelModel::Vector KernelModel::apply_inverse(const Vector &P) const {
  Vector x(P);
  L_.solve(x);
  return x;
}

} // namespace Signorini
