// SPDX-License-Identifier: LGPL-2.1-or-later
// Anderson's acceleration of V-cycles and boundary problems.

#include "acceleration.h"

#include <algorithm>
#include <cmath>

namespace Signorini
{
namespace
{
constexpr unsigned int acceleration_depth = 2;

double product(const dealii::Vector<float> &a, const dealii::Vector<float> &b)
{
  double sum = 0.;
  for (unsigned int i = 0; i < a.size(); ++i)
    sum += double(a[i]) * double(b[i]);
  return sum;
}

double product(const dealii::Vector<float> &a, const dealii::Vector<double> &b)
{
  double sum = 0.;
  for (unsigned int i = 0; i < a.size(); ++i)
    sum += double(a[i]) * b[i];
  return sum;
}

dealii::Vector<double> difference_of(dealii::Vector<double> a, const dealii::Vector<double> &b)
{
  a -= b;
  return a;
}

/** to = from - to. */
void subtract_from(const NodalVector &from, dealii::Vector<float> &to)
{
  for (unsigned int i = 0; i < to.size(); ++i)
    to[i] = static_cast<float>(from[i] - to[i]);
}
} // namespace

double ContactStep::size() const
{
  return std::sqrt(std::abs(r * z + d * C_d));
}

void Acceleration::forget()
{
  differences_.clear();
  products_.clear();
  has_last_ = false;
}

void Acceleration::remember(const ContactStep &step)
{
  // The vectors of the last step become those of the difference.
  subtract_from(step.r, last_r_);
  subtract_from(step.z, last_z_);
  differences_.push_back({std::move(last_increment_),
                          std::move(last_z_),
                          last_P_increment_,
                          difference_of(step.d, last_d_),
                          difference_of(step.C_d, last_C_d_)});
  if (differences_.size() > acceleration_depth)
  {
    differences_.pop_front();
    products_.pop_front();
    for (auto &row : products_)
      row.pop_front();
  }
  const Difference &added = differences_.back();
  products_.emplace_back();
  for (unsigned int i = 0; i < differences_.size(); ++i)
  {
    const double value = product(differences_[i].z, last_r_) + differences_[i].d * added.C_d;
    products_.back().push_back(value);
    if (i + 1 < differences_.size())
      products_[i].push_back(value);
  }
}

dealii::Vector<double> Acceleration::coefficients(const ContactStep &step) const
{
  const unsigned int n = differences_.size();
  dealii::FullMatrix<double> M(n, n), inverse(n, n);
  dealii::Vector<double> rhs(n), gamma(n);
  if (n == 0)
    return gamma;
  for (unsigned int i = 0; i < n; ++i)
  {
    for (unsigned int j = 0; j < n; ++j)
      M(i, j) = products_[i][j];
    // Products of floats carry about eight digits.
    M(i, i) *= 1. + 1e-9;
    rhs[i] = product(differences_[i].z, step.r) + differences_[i].C_d * step.d;
    if (!(M(i, i) > 0.))
      return gamma;
  }
  // Two differences that point the same way tell no more than one.
  if (n > 1 && M.determinant() < 1e-8 * M(0, 0) * M(1, 1))
  {
    gamma[n - 1] = rhs[n - 1] / M(n - 1, n - 1);
    return gamma;
  }
  inverse.invert(M);
  inverse.vmult(gamma, rhs);
  return gamma;
}

void Acceleration::advance(NodalVector &U,
                           dealii::Vector<double> &P,
                           const ContactStep &step,
                           const bool same_set)
{
  if (!same_set)
    forget();
  if (has_last_)
    remember(step);
  const dealii::Vector<double> gamma = coefficients(step);
  last_r_ = step.r;
  last_z_ = step.z;
  last_increment_ = step.z;
  last_d_ = step.d;
  last_C_d_ = step.C_d;
  last_P_increment_ = P;
  P += step.d;
  for (unsigned int k = 0; k < gamma.size(); ++k)
  {
    const auto factor = static_cast<float>(-gamma[k]);
    last_increment_.add(factor, differences_[k].U, factor, differences_[k].z);
    P.add(-gamma[k], differences_[k].P, -gamma[k], differences_[k].d);
  }
  for (double &p : P)
    p = std::min(p, 0.);
  last_P_increment_.sadd(-1., 1., P);
  for (unsigned int i = 0; i < U.size(); ++i)
    U[i] += double(last_increment_[i]);
  has_last_ = true;
}
} // namespace Signorini
