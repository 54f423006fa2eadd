// SPDX-License-Identifier: LGPL-2.1-or-later
// Linear algebra with few columns.

#include <signorini/solvers/kinematics/small_matrix.h>

#include <deal.II/lac/lapack_full_matrix.h>

#include <cmath>
#include <stdexcept>

namespace Signorini
{
namespace
{
/** Returns R of M = Q R, k x k, by Gram and Schmidt, each column made orthogonal twice. A column
 * that depends on those before it has R_jj = 0, and no column of Q. */
dealii::FullMatrix<double> triangle_of(const dealii::FullMatrix<double> &M)
{
  constexpr double dependent = 1e-15;
  const unsigned int k = M.n();
  dealii::FullMatrix<double> Q(M.m(), k), R(k, k);
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

SmallCholesky::SmallCholesky(const dealii::FullMatrix<double> &Q)
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

Splitting split_by_size(const dealii::FullMatrix<double> &M, const double threshold)
{
  const unsigned int k = M.n();
  Splitting split;
  if (k == 0)
    return split;
  dealii::LAPACKFullMatrix<double> R(k, k);
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

dealii::Vector<double> times(const dealii::FullMatrix<double> &M, const dealii::Vector<double> &x)
{
  dealii::Vector<double> product(M.m());
  for (unsigned int i = 0; i < M.m(); ++i)
    for (unsigned int j = 0; j < x.size(); ++j)
      product[i] += M(i, j) * x[j];
  return product;
}

dealii::Vector<double> transpose_times(const dealii::FullMatrix<double> &M,
                                       const dealii::Vector<double> &y)
{
  dealii::Vector<double> product(M.n());
  for (unsigned int i = 0; i < y.size(); ++i)
    for (unsigned int j = 0; j < M.n(); ++j)
      product[j] += M(i, j) * y[i];
  return product;
}
} // namespace Signorini
