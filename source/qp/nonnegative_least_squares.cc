// SPDX-License-Identifier: LGPL-2.1-or-later
// Nonnegative least squares after Lawson and Hanson.

#include <signorini/qp/nonnegative_least_squares.h>
#include <signorini/qp/small_matrix.h>

#include <deal.II/lac/householder.h>

#include <algorithm>
#include <vector>

namespace Signorini
{
namespace
{
using Vector = dealii::Vector<double>;
using Matrix = dealii::FullMatrix<double>;
using Columns = std::vector<unsigned int>;

/** The y with the smallest |b - A_S y| without regard to signs. */
Vector least_squares(const Matrix &A, const Columns &S, const Vector &b)
{
  Matrix A_S(A.m(), S.size());
  for (unsigned int i = 0; i < A.m(); ++i)
    for (unsigned int j = 0; j < S.size(); ++j)
      A_S(i, j) = A(i, S[j]);
  Vector y(S.size());
  dealii::Householder<double>(A_S).least_squares(y, b);
  return y;
}

/** The way from y to the wanted values ends where the first entry vanishes, which then leaves. */
void step_back(Columns &S, Vector &y, const Vector &wanted)
{
  double part = 2.;
  unsigned int leaves = 0;
  for (unsigned int j = 0; j < S.size(); ++j)
    if (wanted[j] <= 0.)
    {
      const double here = y[j] > 0. ? y[j] / (y[j] - wanted[j]) : 0.;
      leaves = here < part ? j : leaves;
      part = std::min(part, here);
    }
  Columns left;
  std::vector<double> values;
  for (unsigned int j = 0; j < S.size(); ++j)
    if (j != leaves)
    {
      left.push_back(S[j]);
      values.push_back(y[j] + part * (wanted[j] - y[j]));
    }
  S = left;
  y = Vector(values.begin(), values.end());
}

bool all_positive(const Vector &y)
{
  return std::all_of(y.begin(), y.end(), [](const double value) { return value > 0.; });
}

/** b - A_S y. */
Vector remainder(const Matrix &A, const Columns &S, const Vector &y, const Vector &b)
{
  Vector r = b;
  for (unsigned int j = 0; j < S.size(); ++j)
    for (unsigned int i = 0; i < A.m(); ++i)
      r[i] -= A(i, S[j]) * y[j];
  return r;
}
} // namespace

Vector remainder_outside_cone(const Matrix &A, const Vector &b, const double rounding)
{
  return project_on_cone(A, b, rounding).remainder;
}

ConeProjection project_on_cone(const Matrix &A, const Vector &b, const double rounding)
{
  Columns S;
  Vector y, r = b;
  const double small = rounding * b.l2_norm();
  // |r| falls in each turn, so no set comes back; the bound is for rounding.
  for (unsigned int turn = 0; turn < 3 * A.n() + 10; ++turn)
  {
    const Vector rates = transpose_times(A, r);
    unsigned int best = 0;
    for (unsigned int j = 1; j < A.n(); ++j)
      if (rates[j] > rates[best])
        best = j;
    const bool is_in = std::find(S.begin(), S.end(), best) != S.end();
    if (A.n() == 0 || rates[best] <= small || is_in || S.size() == A.m())
      break;
    S.push_back(best);
    Vector longer(S.size());
    std::copy(y.begin(), y.end(), longer.begin());
    y = longer;
    Vector wanted = least_squares(A, S, b);
    while (!S.empty() && !all_positive(wanted))
    {
      step_back(S, y, wanted);
      wanted = S.empty() ? Vector() : least_squares(A, S, b);
    }
    y = wanted;
    const Vector next = remainder(A, S, y, b);
    if (next.l2_norm() >= r.l2_norm())
      break;
    r = next;
  }
  return {S, y, r};
}
} // namespace Signorini
