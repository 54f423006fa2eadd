// SPDX-License-Identifier: LGPL-2.1-or-later
// Linear algebra with few columns.

#include <signorini/solvers/kinematics/pressing_patches.h>
#include <signorini/solvers/kinematics/seen_motions.h>

#include <deal.II/lac/lapack_full_matrix.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace Signorini
{
namespace
{
/** Returns R of M = Q R, k x k, by Gram and Schmidt, each column made orthogonal twice. A column
 * that depends on those before it has R_jj = 0, and no column of Q. */
FullMatrix<double> triangle_of(const FullMatrix<double> &M)
{
  constexpr double dependent = 1e-15;
  const unsigned int k = M.n();
  FullMatrix<double> Q(M.m(), k), R(k, k);
  for (unsigned int j = 0; j < k; ++j)
  {
    double before = 0.;
    for (unsigned int i = 0; i < M.m(); ++i)
    {
      Q(i, j) = M(i, j);
      before += M(i, j) * M(i, j);
    }
    for (unsigned int l = 0; l < 2 * j; ++l)
    {
      double product = 0.;
      for (unsigned int i = 0; i < M.m(); ++i)
        product += Q(i, l % j) * Q(i, j);
      for (unsigned int i = 0; i < M.m(); ++i)
        Q(i, j) -= product * Q(i, l % j);
      R(l % j, j) += product;
    }
    double square = 0.;
    for (unsigned int i = 0; i < M.m(); ++i)
      square += Q(i, j) * Q(i, j);
    R(j, j) = square > dependent * dependent * before ? std::sqrt(square) : 0.;
    for (unsigned int i = 0; i < M.m(); ++i)
      Q(i, j) = R(j, j) > 0. ? Q(i, j) / R(j, j) : 0.;
  }
  return R;
}
} // namespace

SmallCholesky::SmallCholesky(const FullMatrix<double> &Q)
  : L_(Q.m(), Q.m())
{
  for (unsigned int j = 0; j < Q.m(); ++j)
    for (unsigned int i = j; i < Q.m(); ++i)
    {
      double rest = Q(i, j);
      for (unsigned int l = 0; l < j; ++l)
        rest -= L_(i, l) * L_(j, l);
      if (i == j && !(rest > 0.))
        throw std::invalid_argument("The stiffness of the free motions is not positive definite.");
      L_(i, j) = i == j ? std::sqrt(rest) : rest / L_(j, j);
    }
}

dealii::Vector<double> SmallCholesky::forward(const dealii::Vector<double> &x) const
{
  dealii::Vector<double> y = x;
  for (unsigned int i = 0; i < y.size(); ++i)
  {
    for (unsigned int l = 0; l < i; ++l)
      y[i] -= L_(i, l) * y[l];
    y[i] /= L_(i, i);
  }
  return y;
}

dealii::Vector<double> SmallCholesky::solve(const dealii::Vector<double> &x) const
{
  dealii::Vector<double> y = forward(x);
  for (unsigned int i = y.size(); i-- > 0;)
  {
    for (unsigned int l = i + 1; l < y.size(); ++l)
      y[i] -= L_(l, i) * y[l];
    y[i] /= L_(i, i);
  }
  return y;
}

Splitting split_by_size(const FullMatrix<double> &M, const double threshold)
{
  const unsigned int k = M.n();
  Splitting split;
  if (k == 0)
    return split;
  LAPACKFullMatrix<double> R(k, k);
  R = triangle_of(M);
  R.compute_svd();
  for (unsigned int i = 0; i < k; ++i)
  {
    dealii::Vector<double> v(k);
    for (unsigned int j = 0; j < k; ++j)
      v[j] = R.get_svd_vt()(i, j);
    (R.singular_value(i) <= threshold ? split.null : split.rest).push_back(v);
  }
  return split;
}

dealii::Vector<double> times(const FullMatrix<double> &M, const dealii::Vector<double> &x)
{
  dealii::Vector<double> product(M.m());
  for (unsigned int i = 0; i < M.m(); ++i)
    for (unsigned int j = 0; j < x.size(); ++j)
      product[i] += M(i, j) * x[j];
  return product;
}

dealii::Vector<double> transpose_times(const FullMatrix<double> &M, const dealii::Vector<double> &y)
{
  dealii::Vector<double> product(M.n());
  for (unsigned int i = 0; i < y.size(); ++i)
    for (unsigned int j = 0; j < M.n(); ++j)
      product[j] += M(i, j) * y[i];
  return product;
}

// Free motions without units and without those that nothing resists, and their balance.

namespace
{
using Vector = dealii::Vector<double>;
using Matrix = FullMatrix<double>;

/** Returns the unit of each motion: 1/|B_j|, or by its resistance, or as large as the others. */
Vector units_of(const FreeMotions &motions, const Vector &norms, const double stiffness)
{
  const unsigned int k = motions.b.size();
  double largest = 0.;
  for (unsigned int j = 0; j < k; ++j)
    largest = std::max(largest, norms[j]);
  Vector units(k);
  for (unsigned int j = 0; j < k; ++j)
    if (norms[j] > 0.)
      units[j] = 1. / norms[j];
    else if (motions.K(j, j) > 1e-12 * stiffness * largest * largest)
      units[j] = std::sqrt(stiffness / motions.K(j, j));
    else
      units[j] = largest > 0. ? 1. / largest : 1.;
  return units;
}

/** Returns the vectors as columns, with n rows. */
Matrix as_columns(const std::vector<Vector> &vectors, const unsigned int n)
{
  Matrix columns(n, vectors.size());
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < vectors.size(); ++j)
      columns(i, j) = vectors[j][i];
  return columns;
}

/** Returns M N, also without rows or columns. */
Matrix product(const Matrix &M, const Matrix &N)
{
  Matrix result(M.m(), N.n());
  for (unsigned int i = 0; i < result.m(); ++i)
    for (unsigned int l = 0; l < N.m(); ++l)
      for (unsigned int j = 0; j < N.n(); ++j)
        result(i, j) += M(i, l) * N(l, j);
  return result;
}

/** Returns Mᵀ N. */
Matrix transpose_product(const Matrix &M, const Matrix &N)
{
  Matrix result(M.n(), N.n());
  for (unsigned int i = 0; i < result.m(); ++i)
    for (unsigned int l = 0; l < M.m(); ++l)
      for (unsigned int j = 0; j < N.n(); ++j)
        result(i, j) += M(l, i) * N(l, j);
  return result;
}

/** Returns an orthonormal basis of the orthogonal complement of the orthonormal columns, as
 * columns. */
Matrix complement(const Matrix &columns, const unsigned int k)
{
  Matrix rows(std::max<unsigned int>(columns.n(), 1), k);
  for (unsigned int i = 0; i < columns.m(); ++i)
    for (unsigned int j = 0; j < columns.n(); ++j)
      rows(j, i) = columns(i, j);
  return as_columns(split_by_size(rows, 0.5).null, k);
}

/** Returns units_i v_i, where v is scaled so that the largest |v_i| is one. */
Vector with_units(Vector v, const Vector &units)
{
  const double largest = v.linfty_norm();
  for (unsigned int i = 0; i < v.size(); ++i)
    v[i] = std::abs(v[i]) > 1e-10 * largest ? units[i] * v[i] / largest : 0.;
  return v;
}

/** Returns the transposes of the rows of B that are not zero within rounding, with norm one. */
Matrix directions(const Matrix &B)
{
  std::vector<double> norms(B.m());
  double largest = 0.;
  for (unsigned int i = 0; i < B.m(); ++i)
  {
    for (unsigned int j = 0; j < B.n(); ++j)
      norms[i] = std::hypot(norms[i], B(i, j));
    largest = std::max(largest, norms[i]);
  }
  std::vector<Vector> columns;
  for (unsigned int i = 0; i < B.m(); ++i)
    if (norms[i] > 1e-12 * largest)
    {
      columns.emplace_back(B.n());
      for (unsigned int j = 0; j < B.n(); ++j)
        columns.back()[j] = B(i, j) / norms[i];
    }
  return as_columns(columns, B.n());
}

/** Free motions without units: columns of B have norm one or are zero. */
struct Unitless
{
  /** The coupling, with at least one row. */
  Matrix B;
  Matrix K;
  Vector b, units;
  /** The levels of rounding of b and of K. */
  double noise = 0., resistance = 0.;
};

Unitless without_units(const FreeMotions &motions, const unsigned int m, const double stiffness)
{
  const unsigned int k = motions.b.size();
  const Vector norms = m > 0 ? column_norms(motions.B) : Vector(k);
  Unitless all;
  all.units = units_of(motions, norms, stiffness);
  all.B.reinit(std::max(m, 1U), k);
  all.K.reinit(k, k);
  all.b.reinit(k);
  Vector size_of_b(k);
  for (unsigned int j = 0; j < k; ++j)
  {
    const double unit = all.units[j];
    for (unsigned int i = 0; i < m; ++i)
      all.B(i, j) = norms[j] > 0. ? motions.B(i, j) * unit : 0.;
    for (unsigned int i = 0; i < k; ++i)
      all.K(i, j) = 0.5 * (motions.K(i, j) + motions.K(j, i)) * all.units[i] * unit;
    all.b[j] = unit * motions.b[j];
    size_of_b[j] = motions.b_magnitude.size() > 0 ? unit * motions.b_magnitude[j] : 0.;
  }
  all.noise = 1e-9 * std::max(all.b.l2_norm(), size_of_b.l2_norm());
  all.resistance = 1e-14 * k * all.K.linfty_norm() + 1e-12 * stiffness;
  return all;
}

/** Returns an escape through hidden motions, or through those that close patches and K does not
 * resist. */
std::optional<Vector> find_escape(const Unitless &all, const Matrix &hidden, const Matrix &seen)
{
  const Vector hidden_work = transpose_times(hidden, all.b);
  if (hidden_work.size() > 0 && hidden_work.l2_norm() > all.noise)
    return times(hidden, hidden_work);
  const Vector b = transpose_times(seen, all.b);
  if (b.size() == 0 || b.l2_norm() <= all.noise)
    return std::nullopt;
  // -P ≥ 0, so the cone is that of the rows of B.
  const Vector left = remainder_outside_cone(directions(product(all.B, seen)), b, 1e-13);
  if (left.l2_norm() <= all.noise)
    return std::nullopt;
  return times(seen, left);
}
} // namespace

void check_sizes(const FreeMotions &motions, const unsigned int m)
{
  const unsigned int k = motions.b.size();
  const Vector &size_of_b = motions.b_magnitude;
  const bool fits =
    k == 0 || ((m == 0 || (motions.B.m() == m && motions.B.n() == k)) && motions.K.m() == k &&
               motions.K.n() == k && (size_of_b.size() == 0 || size_of_b.size() == k));
  if (!fits)
    throw std::invalid_argument("The sizes of B, K and b do not fit together.");
  const double rounding = k > 0 ? 1e-9 * motions.K.linfty_norm() : 0.;
  for (unsigned int i = 0; i < k; ++i)
    for (unsigned int j = 0; j < k; ++j)
    {
      const double size = std::sqrt(std::abs(motions.K(i, i) * motions.K(j, j)));
      const double skew = std::abs(motions.K(i, j) - motions.K(j, i));
      if (motions.K(i, i) < -rounding || skew > 1e-9 * size + rounding)
        throw std::invalid_argument("K is not symmetric and positive semi-definite.");
    }
}

Vector column_norms(const Matrix &B)
{
  Vector norms(B.n());
  for (unsigned int j = 0; j < B.n(); ++j)
    for (unsigned int i = 0; i < B.m(); ++i)
      norms[j] = std::hypot(norms[j], B(i, j));
  const double largest = B.n() > 0 ? norms.linfty_norm() : 0.;
  for (double &norm : norms)
    norm = norm > 1e-12 * largest ? norm : 0.;
  return norms;
}

ReducedMotions::ReducedMotions(const FreeMotions &motions,
                               const unsigned int m,
                               const double stiffness)
{
  check_sizes(motions, m);
  const unsigned int k = motions.b.size();
  if (k == 0)
    return;
  const Unitless all = without_units(motions, m, stiffness);
  const Matrix free = as_columns(split_by_size(all.K, all.resistance).null, k);
  const Splitting free_splitting = split_by_size(product(all.B, free), 1e-10);
  const Matrix hidden = product(free, as_columns(free_splitting.null, free.n()));
  const Matrix basis = complement(hidden, k);
  B = product(all.B, basis);
  K = transpose_product(basis, product(all.K, basis));
  b = transpose_times(basis, all.b);
  T_ = basis;
  for (unsigned int i = 0; i < T_.m(); ++i)
    for (unsigned int j = 0; j < T_.n(); ++j)
      T_(i, j) *= all.units[i];
  n_original_ = k;
  if (const auto v =
        find_escape(all, hidden, product(free, as_columns(free_splitting.rest, free.n()))))
    escape = with_units(*v, all.units);
  for (unsigned int j = 0; j < hidden.n() && !escape; ++j)
  {
    Vector v(k);
    for (unsigned int i = 0; i < k; ++i)
      v[i] = hidden(i, j);
    unseen.push_back(with_units(v, all.units));
  }
}

Vector ReducedMotions::original(const Vector &z) const
{
  return size() == 0 ? Vector(n_original_) : times(T_, z);
}

Vector ReducedMotions::imbalance(const Vector &P, const Vector &z) const
{
  Vector missing = b;
  missing += transpose_times(B, P);
  missing -= times(K, z);
  return missing;
}
} // namespace Signorini
