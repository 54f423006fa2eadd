// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/problem/formulas/expression.h>

#include <deal.II/base/function.h>
#include <deal.II/lac/vector.h>

#include <functional>
#include <vector>

namespace Signorini {
/** A vector field as a deal.II function. */
template <int dim>
class FieldFunction final : public Function<dim> {
public:
  using Field = std::function<Tensor<1, dim>(const Point<dim> &)>;

  explicit FieldFunction(Field field)
    : Function<dim>(dim)
    , field_(std::move(field)) {}

  double value(const Point<dim> &x, const unsigned int component = 0) const override {
    return field_(x)[component];
  }
  void vector_value(const Point<dim> &x, dealii::Vector<double> &values) const override {
    field_(x).unroll(values.begin(), values.end());
  }

private:
  Field field_;
};

/**
 * A deal.II function whose components are expressions. Its gradient is given by further expressions
 * (component by component, dim each), or else is the exact one. Thread-safe; the functions for
 * lists of points are the fast ones.
 */
template <int dim>
class ExpressionFunction : public Function<dim> {
public:
  using Points = std::vector<Point<dim>>;
  using Gradients = std::vector<Tensor<1, dim>>;

  /** Makes data of the problem: values must be finite and not beyond max_magnitude (scene.h), or
   * InputError is thrown. */
  explicit ExpressionFunction(std::vector<Expression<dim>> values);
  /** Makes data that has components of its own in each region. */
  ExpressionFunction(const std::vector<std::vector<Expression<dim>>> &values_by_region,
                     std::function<unsigned int(const Point<dim> &)> region_at);
  /** Makes a part of the exact solution, with given derivatives or none. */
  ExpressionFunction(std::vector<Expression<dim>> values, std::vector<Expression<dim>> gradients);

  /** Returns whether no component uses a coordinate or depends on the region. */
  bool is_constant() const;

  /** Returns the derivatives of a component by its own formula. */
  Tensor<1, dim> exact_gradient(const Point<dim> &x, const unsigned int component) const {
    return values_[component].formula().gradient(x);
  }
  const std::vector<Expression<dim>> &components() const {
    return values_;
  }

  double value(const Point<dim> &x, unsigned int component = 0) const override;
  void value_list(const Points &points, std::vector<double> &values,
                  unsigned int component = 0) const override;
  void vector_value_list(const Points &points,
                         std::vector<dealii::Vector<double>> &values) const override;
  Tensor<1, dim> gradient(const Point<dim> &x, unsigned int component = 0) const override;
  void gradient_list(const Points &points, Gradients &gradients,
                     unsigned int component = 0) const override;
  void vector_gradient_list(const Points &points, std::vector<Gradients> &gradients) const override;

private:
  /** Checks a value. @throws InputError if this is data and a value of a component cannot be used.
   */
  void check(double value, unsigned int component, const Point<dim> &x) const;

  std::vector<Expression<dim>> values_;
  std::vector<Expression<dim>> gradients_;
  bool is_data_;
  std::function<unsigned int(const Point<dim> &)> region_at_;
};

/** The gap of a contact side by a formula. It is zero where rounding of the coordinates changes it
 * by as much as its value: a formula of a foundation that the body fits leaves no noise. */
template <int dim>
class GapFunction final : public ExpressionFunction<dim> {
public:
  using ExpressionFunction<dim>::ExpressionFunction;

  double value(const Point<dim> &x, unsigned int component = 0) const override;
  void value_list(const std::vector<Point<dim>> &points, std::vector<double> &values,
                  unsigned int component = 0) const override;

private:
  /** Returns a value without_rounding() of the coordinates. */
  double rounded(double gap, const Point<dim> &x) const;
};

/** Refuses a value that is not finite or beyond max_magnitude. @throws InputError */
template <int dim>
void check_magnitude(double value, unsigned int component, const Point<dim> &x,
                     const std::string &where);

/** Returns whether a function is known to be the same everywhere. */
template <int dim>
bool is_constant(const Function<dim> &function);
} // namespace Signorini
