// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/function.h>

#include <functional>

namespace Signorini
{
/** A vector field of the plane as a deal.II function. */
class FieldFunction final : public dealii::Function<2>
{
public:
  using Field = std::function<dealii::Tensor<1, 2>(const dealii::Point<2> &)>;

  explicit FieldFunction(Field field)
    : dealii::Function<2>(2)
    , field_(std::move(field))
  {
  }

  double value(const dealii::Point<2> &x, const unsigned int component = 0) const override
  {
    return field_(x)[component];
  }
  void vector_value(const dealii::Point<2> &x, dealii::Vector<double> &values) const override
  {
    const dealii::Tensor<1, 2> u = field_(x);
    for (unsigned int d = 0; d < 2; ++d)
      values[d] = u[d];
  }

private:
  Field field_;
};
} // namespace Signorini
