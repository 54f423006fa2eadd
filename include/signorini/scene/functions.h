// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/scene/expression.h>

#include <deal.II/base/auto_derivative_function.h>
#include <deal.II/base/function.h>

#include <vector>

namespace Signorini
{
/**
 * A deal.II function whose components are expressions. Its gradient is given by further expressions
 * (component by component, dim each) or by fourth-order differences with the step @p h.
 */
template <int dim>
class ExpressionFunction : public dealii::AutoDerivativeFunction<dim>
{
public:
  ExpressionFunction(std::vector<Expression<dim>> values,
                     std::vector<Expression<dim>> gradients,
                     double h);

  double value(const dealii::Point<dim> &x, unsigned int component = 0) const override;
  void vector_value(const dealii::Point<dim> &x, dealii::Vector<double> &values) const override;
  dealii::Tensor<1, dim> gradient(const dealii::Point<dim> &x,
                                  unsigned int component = 0) const override;
  void vector_gradient(const dealii::Point<dim> &x,
                       std::vector<dealii::Tensor<1, dim>> &gradients) const override;
  void gradient_list(const std::vector<dealii::Point<dim>> &points,
                     std::vector<dealii::Tensor<1, dim>> &gradients,
                     unsigned int component = 0) const override;
  void
  vector_gradient_list(const std::vector<dealii::Point<dim>> &points,
                       std::vector<std::vector<dealii::Tensor<1, dim>>> &gradients) const override;

private:
  std::vector<Expression<dim>> values_;
  std::vector<Expression<dim>> gradients_;
};
} // namespace Signorini
