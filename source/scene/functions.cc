// SPDX-License-Identifier: LGPL-2.1-or-later
// Expressions as deal.II functions.

#include <signorini/scene/functions.h>

namespace Signorini
{
template <int dim>
ExpressionFunction<dim>::ExpressionFunction(std::vector<Expression<dim>> values,
                                            std::vector<Expression<dim>> gradients,
                                            const double h)
  : dealii::AutoDerivativeFunction<dim>(h, values.size())
  , values_(std::move(values))
  , gradients_(std::move(gradients))
{
  Assert(gradients_.empty() || gradients_.size() == dim * values_.size(),
         dealii::ExcDimensionMismatch(gradients_.size(), dim * values_.size()));
  this->set_formula(dealii::AutoDerivativeFunction<dim>::FourthOrder);
}

template <int dim>
double ExpressionFunction<dim>::value(const dealii::Point<dim> &x,
                                      const unsigned int component) const
{
  return values_[component](x);
}

template <int dim>
void ExpressionFunction<dim>::vector_value(const dealii::Point<dim> &x,
                                           dealii::Vector<double> &values) const
{
  for (unsigned int c = 0; c < values_.size(); ++c)
    values[c] = values_[c](x);
}

template <int dim>
dealii::Tensor<1, dim> ExpressionFunction<dim>::gradient(const dealii::Point<dim> &x,
                                                         const unsigned int component) const
{
  if (gradients_.empty())
    return dealii::AutoDerivativeFunction<dim>::gradient(x, component);
  dealii::Tensor<1, dim> gradient;
  for (unsigned int d = 0; d < dim; ++d)
    gradient[d] = gradients_[dim * component + d](x);
  return gradient;
}

// The base class would take differences in all of these, whether or not gradients are given.
template <int dim>
void ExpressionFunction<dim>::vector_gradient(const dealii::Point<dim> &x,
                                              std::vector<dealii::Tensor<1, dim>> &gradients) const
{
  for (unsigned int c = 0; c < values_.size(); ++c)
    gradients[c] = gradient(x, c);
}

template <int dim>
void ExpressionFunction<dim>::gradient_list(const std::vector<dealii::Point<dim>> &points,
                                            std::vector<dealii::Tensor<1, dim>> &gradients,
                                            const unsigned int component) const
{
  for (std::size_t q = 0; q < points.size(); ++q)
    gradients[q] = gradient(points[q], component);
}

template <int dim>
void ExpressionFunction<dim>::vector_gradient_list(
  const std::vector<dealii::Point<dim>> &points,
  std::vector<std::vector<dealii::Tensor<1, dim>>> &gradients) const
{
  for (std::size_t q = 0; q < points.size(); ++q)
    vector_gradient(points[q], gradients[q]);
}

template class ExpressionFunction<2>;
} // namespace Signorini
