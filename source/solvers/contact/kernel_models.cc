// SPDX-License-Identifier: LGPL-2.1-or-later
// Ĉ by discrete cosines, which diagonalise the H^{-1/2} Gram matrix of equal patches, and by the
// kernel of the half space.

#include <signorini/discretization/space/cosine_modes.h>
#include <signorini/solvers/contact/kernel_models.h>

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

/** Returns cos(k π a/n) for 0 ≤ a < 2 n. */
Matrix differences(const unsigned int n) {
  Matrix cosines(2 * n, n);
  for (unsigned int a = 0; a < 2 * n; ++a)
    for (unsigned int k = 0; k < n; ++k)
      cosines(a, k) = std::cos(k * PI * a / n);
  return cosines;
}

/** Returns the inverse of the sum of squares of cos(k π (i + 1/2)/n). */
double inverse_square(const unsigned int k, const unsigned int n) {
  return (k == 0 ? 1. : 2.) / n;
}

/** Returns the cosines with all aliases k + 2 n j, |j| ≤ 8, of the modes k < n. */
CosineModes modes_of(const double length, const unsigned int n) {
  constexpr unsigned int n_aliases = 8;
  return {length, n, (2 * n_aliases + 1) * n};
}
} // namespace

CosineGrid::CosineGrid(const std::array<unsigned int, 2> &sizes,
                       const std::array<double, 2> &lengths, const double omega_0,
                       std::vector<unsigned int> multipliers)
  : sizes_(sizes)
  , multipliers_(std::move(multipliers))
  , cosines_{discrete_cosines(sizes[0]), discrete_cosines(sizes[1])}
  , eigenvalues_(
      cosine_eigenvalues(modes_of(lengths[0], sizes[0]), modes_of(lengths[1], sizes[1]), omega_0))
  , table_(2 * sizes[0], 2 * sizes[1]) {
  if (multipliers_.empty()) {
    multipliers_.resize(sizes[0] * sizes[1]);
    std::iota(multipliers_.begin(), multipliers_.end(), 0U);
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
  cosines_[0].mmult(half, values);
  half.mTmult(modes, cosines_[1]);
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < m; ++j)
      modes(i, j) *=
        inverse ? std::pow(inverse_square(i, n) * inverse_square(j, m), 2) / eigenvalues_(i, j)
                : eigenvalues_(i, j);
  cosines_[0].Tmmult(half, modes);
  half.mmult(values, cosines_[1]);
  for (unsigned int j = 0; j < m; ++j)
    for (unsigned int i = 0; i < n; ++i)
      product[multipliers_[i + n * j]] = values(i, j);
}

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
