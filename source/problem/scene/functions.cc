// SPDX-License-Identifier: LGPL-2.1-or-later
// Expressions as deal.II functions.

#include <signorini/base/instantiate.h>
#include <signorini/problem/scene/functions.h>
#include <signorini/problem/scene/scene.h>

#include <deal.II/lac/vector.h>

#include <algorithm>
#include <cmath>

namespace Signorini {
template <int dim>
ExpressionFunction<dim>::ExpressionFunction(std::vector<Expression<dim>> values)
  : Function<dim>(values.size())
  , values_(std::move(values))
  , is_data_(true) {}

template <int dim>
ExpressionFunction<dim>::ExpressionFunction(
  const std::vector<std::vector<Expression<dim>>> &values_by_region,
  std::function<unsigned int(const Point<dim> &)> region_at)
  : Function<dim>(values_by_region.front().size())
  , is_data_(true)
  , region_at_(std::move(region_at)) {
  for (const std::vector<Expression<dim>> &values : values_by_region)
    values_.insert(values_.end(), values.begin(), values.end());
}

template <int dim>
ExpressionFunction<dim>::ExpressionFunction(std::vector<Expression<dim>> values,
                                            std::vector<Expression<dim>> gradients)
  : Function<dim>(values.size())
  , values_(std::move(values))
  , gradients_(std::move(gradients))
  , is_data_(false) {
  Assert(gradients_.empty() || gradients_.size() == dim * values_.size(),
         ExcDimensionMismatch(gradients_.size(), dim * values_.size()));
}

template <int dim>
void ExpressionFunction<dim>::check(const double value, const unsigned int component,
                                    const Point<dim> &x) const {
  if (is_data_)
    check_magnitude(value, component, x, values_[component].where());
}

template <int dim>
double GapFunction<dim>::rounded(const double gap, const Point<dim> &x) const {
  // Slopes are computed only where they may matter.
  constexpr double small = 1e-9;
  const double size = x.norm();
  return !(std::abs(gap) <= small * size)
           ? gap
           : without_rounding(gap, size * this->exact_gradient(x, 0).norm());
}

template <int dim>
double GapFunction<dim>::value(const Point<dim> &x, const unsigned int component) const {
  return rounded(ExpressionFunction<dim>::value(x, component), x);
}

template <int dim>
void GapFunction<dim>::value_list(const std::vector<Point<dim>> &points,
                                  std::vector<double> &values, const unsigned int component) const {
  ExpressionFunction<dim>::value_list(points, values, component);
  for (std::size_t q = 0; q < points.size(); ++q)
    values[q] = rounded(values[q], points[q]);
}

template <int dim>
void check_magnitude(const double value, const unsigned int component, const Point<dim> &x,
                     const std::string &where) {
  if (!(std::abs(value) <= max_magnitude))
    refuse_value(
      where, "the value " + number_text(value) + " of component " + std::to_string(component + 1),
      x, "values up to " + number_text(max_magnitude) + " on the whole body");
}

template <int dim>
bool ExpressionFunction<dim>::is_constant() const {
  return !region_at_ &&
         std::all_of(values_.begin(), values_.end(),
                     [](const Expression<dim> &value) { return value.is_constant(); });
}

template <int dim>
double ExpressionFunction<dim>::value(const Point<dim> &x, const unsigned int component) const {
  AssertIndexRange(component, this->n_components);
  const unsigned int first = region_at_ ? region_at_(x) * this->n_components : 0;
  const double value = values_[first + component](x);
  check(value, component, x);
  return value;
}

template <int dim>
void ExpressionFunction<dim>::value_list(const Points &points, std::vector<double> &values,
                                         const unsigned int component) const {
  AssertDimension(values.size(), points.size());
  if (region_at_) {
    for (std::size_t q = 0; q < points.size(); ++q)
      values[q] = value(points[q], component);
    return;
  }
  values_[component].evaluate(points, values);
  for (std::size_t q = 0; q < points.size(); ++q)
    check(values[q], component, points[q]);
}

template <int dim>
void ExpressionFunction<dim>::vector_value_list(const Points &points,
                                                std::vector<dealii::Vector<double>> &values) const {
  std::vector<double> component(points.size());
  for (unsigned int c = 0; c < this->n_components; ++c) {
    value_list(points, component, c);
    for (std::size_t q = 0; q < points.size(); ++q)
      values[q][c] = component[q];
  }
}

template <int dim>
Tensor<1, dim> ExpressionFunction<dim>::gradient(const Point<dim> &x,
                                                 const unsigned int component) const {
  Gradients gradient(1);
  gradient_list({x}, gradient, component);
  return gradient[0];
}

template <int dim>
void ExpressionFunction<dim>::gradient_list(const Points &points, Gradients &gradients,
                                            const unsigned int component) const {
  AssertDimension(gradients.size(), points.size());
  if (gradients_.empty())
    values_[component].formula().gradients(points.data(), points.size(), gradients.data());
  std::vector<double> derivatives(points.size());
  for (unsigned int d = 0; d < dim && !gradients_.empty(); ++d) {
    gradients_[dim * component + d].evaluate(points, derivatives);
    for (std::size_t q = 0; q < points.size(); ++q)
      gradients[q][d] = derivatives[q];
  }
}

template <int dim>
void ExpressionFunction<dim>::vector_gradient_list(const Points &points,
                                                   std::vector<Gradients> &gradients) const {
  Gradients component(points.size());
  for (unsigned int c = 0; c < values_.size(); ++c) {
    gradient_list(points, component, c);
    for (std::size_t q = 0; q < points.size(); ++q)
      gradients[q][c] = component[q];
  }
}

template <int dim>
bool is_constant(const Function<dim> &function) {
  const auto *expressions = dynamic_cast<const ExpressionFunction<dim> *>(&function);
  return dynamic_cast<const Functions::ConstantFunction<dim> *>(&function) != nullptr ||
         (expressions != nullptr && expressions->is_constant());
}

template class ExpressionFunction<2>;
template class ExpressionFunction<3>;
template class GapFunction<2>;
template class GapFunction<3>;
INSTANTIATE_FUNCTION(is_constant);
INSTANTIATE_FUNCTION(check_magnitude);
} // namespace Signorini
