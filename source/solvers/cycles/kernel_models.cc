// SPDX-License-Identifier: LGPL-2.1-or-later
// Discrete cosines diagonalise the H^{-1/2} Gram matrix of equal patches.

#include <signorini/solvers/cycles/kernel_models.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace Signorini
{
namespace
{
using Matrix = FullMatrix<double>;
using numbers::PI;

constexpr int n_aliases = 8;

/** Returns (c_k/n)^{1/2} cos(k π (i + 1/2)/n), c_0 = 1, c_k = 2. */
Matrix orthonormal_cosines(const unsigned int n)
{
  Matrix cosines(n, n);
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int k = 0; k < n; ++k)
      cosines(i, k) = std::sqrt((k == 0 ? 1. : 2.) / n) * std::cos(k * PI * (i + 0.5) / n);
  return cosines;
}

/** Returns c_k/n cos(k π a/n) for 0 ≤ a < 2 n. */
Matrix differences(const unsigned int n)
{
  Matrix cosines(2 * n, n);
  for (unsigned int a = 0; a < 2 * n; ++a)
    for (unsigned int k = 0; k < n; ++k)
      cosines(a, k) = (k == 0 ? 1. : 2.) / n * std::cos(k * PI * a / n);
  return cosines;
}

/** A mode of the series: the square of its frequency, and the square of the share of it that
 * patches resolve. */
struct Alias
{
  double square_of_frequency, share;
};

/** Returns the modes k + 2 n j of the series, with (sin x/x)² for x = ω h/2. */
std::vector<Alias> aliases_of(const unsigned int k, const unsigned int n, const double length)
{
  if (length <= 0.)
    return {{0., 1.}};
  std::vector<Alias> aliases;
  for (int j = -n_aliases; j <= n_aliases; ++j)
  {
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
                       const std::array<double, 2> &lengths,
                       const double omega_0)
  : sizes_(sizes)
  , cosines_{orthonormal_cosines(sizes[0]), orthonormal_cosines(sizes[1])}
  , eigenvalues_(sizes[0], sizes[1])
  , inverse_eigenvalues_(sizes[0], sizes[1])
{
  sum_aliases(lengths, omega_0);
  tabulate_entries();
}

void CosineGrid::sum_aliases(const std::array<double, 2> &lengths, const double omega_0)
{
  double measure = 1.;
  for (unsigned int d = 0; d < 2; ++d)
    measure *= lengths[d] > 0. ? lengths[d] / sizes_[d] : 1.;
  std::vector<std::vector<Alias>> second(sizes_[1]);
  for (unsigned int l = 0; l < sizes_[1]; ++l)
    second[l] = aliases_of(l, sizes_[1], lengths[1]);
  for (unsigned int k = 0; k < sizes_[0]; ++k)
  {
    const std::vector<Alias> first = aliases_of(k, sizes_[0], lengths[0]);
    for (unsigned int l = 0; l < sizes_[1]; ++l)
    {
      double sum = 0.;
      for (const Alias &a : first)
        for (const Alias &b : second[l])
          sum += a.share * b.share /
                 std::sqrt(omega_0 * omega_0 + a.square_of_frequency + b.square_of_frequency);
      eigenvalues_(k, l) = measure * sum;
      inverse_eigenvalues_(k, l) = 1. / eigenvalues_(k, l);
    }
  }
}

void CosineGrid::tabulate_entries()
{
  const Matrix first = differences(sizes_[0]), second = differences(sizes_[1]);
  Matrix product(2 * sizes_[0], sizes_[1]);
  first.mmult(product, eigenvalues_);
  table_.reinit(2 * sizes_[0], 2 * sizes_[1]);
  product.mTmult(table_, second);
}

double CosineGrid::entry(const unsigned int a, const unsigned int b) const
{
  const unsigned int i = a % sizes_[0], j = a / sizes_[0];
  const unsigned int k = b % sizes_[0], l = b / sizes_[0];
  const unsigned int minus_1 = i > k ? i - k : k - i, plus_1 = i + k + 1;
  const unsigned int minus_2 = j > l ? j - l : l - j, plus_2 = j + l + 1;
  return 0.25 * (table_(minus_1, minus_2) + table_(plus_1, minus_2) + table_(minus_1, plus_2) +
                 table_(plus_1, plus_2));
}

CosineGrid::Vector CosineGrid::transform(const Vector &P, const Matrix &factors) const
{
  const unsigned int n = sizes_[0], m = sizes_[1];
  Matrix values(n, m), half(n, m), modes(n, m);
  for (unsigned int j = 0; j < m; ++j)
    for (unsigned int i = 0; i < n; ++i)
      values(i, j) = P[i + n * j];
  cosines_[0].Tmmult(half, values);
  half.mmult(modes, cosines_[1]);
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < m; ++j)
      modes(i, j) *= factors(i, j);
  cosines_[0].mmult(half, modes);
  half.mTmult(values, cosines_[1]);
  Vector result(P.size());
  for (unsigned int j = 0; j < m; ++j)
    for (unsigned int i = 0; i < n; ++i)
      result[i + n * j] = values(i, j);
  return result;
}

CosineGrid::Vector CosineGrid::apply(const Vector &P) const
{
  return transform(P, eigenvalues_);
}

CosineGrid::Vector CosineGrid::apply_inverse(const Vector &P) const
{
  return transform(P, inverse_eigenvalues_);
}

// Ĉ on sides that are grids of equal patches.

namespace
{
using Vector = ComplianceOperator::Vector;

Vector gather_block(const std::vector<unsigned int> &numbers, const Vector &P)
{
  Vector part(numbers.size());
  for (unsigned int a = 0; a < numbers.size(); ++a)
    part[a] = P[numbers[a]];
  return part;
}

void scatter_block(const std::vector<unsigned int> &numbers, const Vector &part, Vector &P)
{
  for (unsigned int a = 0; a < numbers.size(); ++a)
    P[numbers[a]] = part[a];
}
} // namespace

CosineModel::CosineModel(std::vector<GridBlock> blocks,
                         Vector scaling,
                         const unsigned int max_factorised_size)
  : BoundaryModel(max_factorised_size)
  , blocks_(std::move(blocks))
  , scaling_(std::move(scaling))
  , places_(scaling_.size())
{
  for (unsigned int b = 0; b < blocks_.size(); ++b)
    for (unsigned int a = 0; a < blocks_[b].multipliers.size(); ++a)
      places_[blocks_[b].multipliers[a]] = {b, a};
}

unsigned int CosineModel::size() const
{
  return scaling_.size();
}

Vector CosineModel::apply(const Vector &P) const
{
  Vector scaled(P), product(P.size());
  scaled.scale(scaling_);
  for (const GridBlock &block : blocks_)
    scatter_block(
      block.multipliers, block.grid.apply(gather_block(block.multipliers, scaled)), product);
  product.scale(scaling_);
  return product;
}

Vector CosineModel::apply_inverse(const Vector &P) const
{
  Vector scaled(P), product(P.size());
  for (unsigned int k = 0; k < P.size(); ++k)
    scaled[k] /= scaling_[k];
  for (const GridBlock &block : blocks_)
    scatter_block(block.multipliers,
                  block.grid.apply_inverse(gather_block(block.multipliers, scaled)),
                  product);
  for (unsigned int k = 0; k < P.size(); ++k)
    product[k] /= scaling_[k];
  return product;
}

double CosineModel::entry(const unsigned int i, const unsigned int j) const
{
  if (places_[i].first != places_[j].first)
    return 0.;
  return scaling_[i] * scaling_[j] *
         blocks_[places_[i].first].grid.entry(places_[i].second, places_[j].second);
}

// Ĉ by the kernel of the half space.

namespace
{
/** The distance in diameters beyond which patches act on each other as points. */
constexpr double far_away = 4.;

/** Returns ∫ -log(r/R) ds for r = (s² + z²)^{1/2}, from 0 to u. */
double log_primitive(const double u, const double z, const double radius)
{
  const double square = u * u + z * z;
  if (square == 0.)
    return 0.;
  const double angle = z > 0. ? z * std::atan(u / z) : 0.;
  return u - angle - 0.5 * u * std::log(square / (radius * radius));
}

/** Returns ∫∫ 1/r over [0, u] x [0, v] without terms that cancel. */
double inverse_distance_primitive(const double u, const double v, const double z)
{
  const double r = std::sqrt(u * u + v * v + z * z);
  double sum = 0.;
  if (u != 0.)
    sum += u * std::asinh(v / std::hypot(u, z));
  if (v != 0.)
    sum += v * std::asinh(u / std::hypot(v, z));
  if (z > 0.)
    sum -= z * std::atan(u * v / (z * r));
  return sum;
}

template <int dim>
double kernel_of(const double distance, const double radius)
{
  return dim == 2 ? -std::log(distance / radius) : 0.5 / distance;
}
} // namespace

template <int dim>
Point<dim> FlatPatch<dim>::centre() const
{
  Point<dim> x = corner;
  for (const auto &edge : edges)
    x += 0.5 * edge;
  return x;
}

template <int dim>
double FlatPatch<dim>::diameter() const
{
  Tensor<1, dim> diagonal;
  for (const auto &edge : edges)
    diagonal += edge;
  return diagonal.norm();
}

template <>
double patch_potential(const FlatPatch<2> &patch, const Point<2> &x, const double radius)
{
  const double length = patch.edges[0].norm();
  const Tensor<1, 2> from = x - patch.corner;
  const double s = from * patch.edges[0] / length;
  // Rounding must not make a line of no width.
  const double z = (from - s / length * patch.edges[0]).norm();
  const double off = z > 1e-12 * length ? z : 0.;
  return (log_primitive(length - s, off, radius) - log_primitive(-s, off, radius)) *
         (patch.measure / length);
}

template <>
double patch_potential(const FlatPatch<3> &patch, const Point<3> &x, const double /*radius*/)
{
  const Tensor<1, 3> from = x - patch.corner;
  std::array<double, 2> low, high;
  Tensor<1, 3> rest = from;
  double area = 1.;
  for (unsigned int d = 0; d < 2; ++d)
  {
    const double length = patch.edges[d].norm();
    const double s = from * patch.edges[d] / length;
    rest -= s / length * patch.edges[d];
    low[d] = -s;
    high[d] = length - s;
    area *= length;
  }
  const double z = rest.norm() > 1e-12 * patch.diameter() ? rest.norm() : 0.;
  const double integral = inverse_distance_primitive(high[0], high[1], z) -
                          inverse_distance_primitive(low[0], high[1], z) -
                          inverse_distance_primitive(high[0], low[1], z) +
                          inverse_distance_primitive(low[0], low[1], z);
  return 0.5 * integral * (patch.measure / area);
}

template <int dim>
double patch_interaction(const FlatPatch<dim> &a, const FlatPatch<dim> &b, const double radius)
{
  const double distance = a.centre().distance(b.centre());
  const double size = std::max(a.diameter(), b.diameter());
  if (distance > far_away * size)
    return a.measure * b.measure * kernel_of<dim>(distance, radius);
  static const QGauss<dim - 1> usual(2), near(4);
  const Quadrature<dim - 1> &rule = distance > 1.5 * size ? usual : near;
  const auto one_way = [&](const FlatPatch<dim> &outer, const FlatPatch<dim> &inner) {
    double sum = 0.;
    for (unsigned int q = 0; q < rule.size(); ++q)
    {
      Point<dim> x = outer.corner;
      for (unsigned int d = 0; d < dim - 1; ++d)
        x += rule.point(q)[d] * outer.edges[d];
      sum += rule.weight(q) * outer.measure * patch_potential(inner, x, radius);
    }
    return sum;
  };
  return 0.5 * (one_way(a, b) + one_way(b, a));
}

KernelModel::KernelModel(Matrix C)
  : BoundaryModel(std::numeric_limits<unsigned int>::max())
  , C_(std::move(C))
  , L_(C_.m(), C_.m())
{
  L_ = C_;
  L_.set_property(LAPACKSupport::symmetric);
  L_.compute_cholesky_factorization();
}

unsigned int KernelModel::size() const
{
  return C_.m();
}

KernelModel::Vector KernelModel::apply(const Vector &P) const
{
  Vector product(size());
  C_.vmult(product, P);
  return product;
}

KernelModel::Vector KernelModel::apply_inverse(const Vector &P) const
{
  Vector x(P);
  L_.solve(x);
  return x;
}

double KernelModel::entry(const unsigned int i, const unsigned int j) const
{
  return C_(i, j);
}

template struct FlatPatch<2>;
template struct FlatPatch<3>;
template double patch_interaction(const FlatPatch<2> &, const FlatPatch<2> &, double);
template double patch_interaction(const FlatPatch<3> &, const FlatPatch<3> &, double);
} // namespace Signorini
