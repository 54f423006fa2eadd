// SPDX-License-Identifier: LGPL-2.1-or-later
// What every C^ can do: entries, and solves on sets of multipliers.

#include <signorini/boundary_model/boundary_model.h>

#include <cmath>

namespace Signorini
{
namespace
{
using Vector = ComplianceOperator::Vector;
using Indices = ComplianceOperator::Indices;

/** Zero outside of the set. */
Vector extended(const Vector &x, const Indices &set, const unsigned int n)
{
  Vector all(n);
  for (unsigned int r = 0; r < set.size(); ++r)
    all[set[r]] = x[r];
  return all;
}

Vector restricted(const Vector &all, const Indices &set)
{
  Vector x(set.size());
  for (unsigned int r = 0; r < set.size(); ++r)
    x[r] = all[set[r]];
  return x;
}
} // namespace

BoundaryModel::BoundaryModel(const unsigned int largest_factorised)
  : largest_factorised_(largest_factorised)
{
}

Vector BoundaryModel::solve(const Indices &set, const Vector &rhs) const
{
  if (set.empty())
    return Vector();
  return set.size() <= largest_factorised_ ? solve_by_factor(set, rhs)
                                           : solve_by_gradients(set, rhs);
}

Vector BoundaryModel::solve_by_factor(const Indices &set, const Vector &rhs) const
{
  if (set != factorised_set_)
  {
    const auto n = static_cast<unsigned int>(set.size());
    factorised_set_.clear();
    factor_.reinit(n, n);
    for (unsigned int r = 0; r < n; ++r)
      for (unsigned int c = 0; c <= r; ++c)
      {
        const double value = entry(set[r], set[c]);
        factor_(r, c) = value;
        factor_(c, r) = value;
      }
    factor_.set_property(dealii::LAPACKSupport::symmetric);
    factor_.compute_cholesky_factorization();
    factorised_set_ = set;
  }
  Vector x(rhs);
  factor_.solve(x);
  return x;
}

Vector BoundaryModel::solve_by_gradients(const Indices &set, const Vector &rhs) const
{
  constexpr unsigned int most_steps = 500;
  constexpr double tolerance = 1e-10;
  const auto inverse = [&](const Vector &r) {
    return restricted(apply_inverse(extended(r, set, size())), set);
  };
  Vector x(rhs.size()), r(rhs), z = inverse(r), direction(z);
  const double wanted = tolerance * r.l2_norm();
  double r_z = r * z;
  for (unsigned int k = 0; k < most_steps && r.l2_norm() > wanted; ++k)
  {
    const Vector product = restricted(apply(extended(direction, set, size())), set);
    const double step = r_z / (direction * product);
    x.add(step, direction);
    r.add(-step, product);
    z = inverse(r);
    const double next = r * z;
    direction.sadd(next / r_z, 1., z);
    r_z = next;
  }
  return x;
}

Vector BoundaryModel::diagonal() const
{
  Vector values(size());
  for (unsigned int k = 0; k < size(); ++k)
    values[k] = entry(k, k);
  return values;
}

BoundaryModel::Matrix BoundaryModel::columns(const Indices &numbers) const
{
  Matrix values(size(), numbers.size());
  for (unsigned int i = 0; i < size(); ++i)
    for (unsigned int j = 0; j < numbers.size(); ++j)
      values(i, j) = entry(i, numbers[j]);
  return values;
}

const BoundaryModel::Matrix &BoundaryModel::dense() const
{
  if (dense_.m() != size())
  {
    dense_.reinit(size(), size());
    for (unsigned int i = 0; i < size(); ++i)
      for (unsigned int j = 0; j < size(); ++j)
        dense_(i, j) = entry(i, j);
  }
  return dense_;
}

bool BoundaryModel::is_explicit() const
{
  return true;
}
} // namespace Signorini
