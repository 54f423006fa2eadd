// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <cmath>
#include <initializer_list>
#include <vector>

namespace Signorini
{
/** The components of a point, a force or a moment: records hold answers of bodies in the plane and
 * in space. */
class AnswerVector
{
public:
  AnswerVector() = default;
  AnswerVector(const std::initializer_list<double> values)
    : values_(values)
  {
  }
  template <int dim>
  AnswerVector(const dealii::Tensor<1, dim> &x)
  {
    for (unsigned int d = 0; d < dim; ++d)
      values_.push_back(x[d]);
  }

  std::size_t size() const
  {
    return values_.size();
  }
  double operator[](const std::size_t d) const
  {
    return values_[d];
  }
  const std::vector<double> &values() const
  {
    return values_;
  }
  /** Euclidean. */
  double norm() const
  {
    double square = 0.;
    for (const double x : values_)
      square += x * x;
    return std::sqrt(square);
  }
  double distance(const AnswerVector &other) const
  {
    return (*this - other).norm();
  }
  friend AnswerVector operator-(AnswerVector a, const AnswerVector &b)
  {
    AssertDimension(a.size(), b.size());
    for (std::size_t d = 0; d < a.size(); ++d)
      a.values_[d] -= b.values_[d];
    return a;
  }

private:
  std::vector<double> values_;
};
} // namespace Signorini
