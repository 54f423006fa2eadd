// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/problem/scene/material.h>

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/fe/fe_values.h>

#include <vector>

namespace Signorini {
/** Returns dx at a point of a rule on a cell, or ds at one on a face: the one place that says what
 * integrals over the body and its boundary measure. */
template <int dim>
double measure_at(const FEValuesBase<dim> &values, const unsigned int q) {
  return values.JxW(q);
}

/** Returns the strain of a displacement with this gradient. */
template <int dim>
SymmetricTensor<2, dim> strain_of(const Tensor<2, dim> &gradient) {
  return symmetrize(gradient);
}

/** Returns the strain of a shape function of V^h at a point. */
template <int dim>
SymmetricTensor<2, dim> shape_strain(const FEValuesBase<dim> &values, const unsigned int i,
                                     const unsigned int q) {
  return values[FEValuesExtractors::Vector(0)].symmetric_gradient(i, q);
}

/** Integrates energies, twice the elastic ones: ε:C:ε with Hooke's law C. */
template <int dim>
class EnergyMeasure {
public:
  /** The material must outlive the object. */
  explicit EnergyMeasure(const Material<dim> &material)
    : material_(material)
    , is_constant_(material.is_constant()) {
    if (is_constant_)
      hooke_ = material.hooke(Point<dim>());
  }

  /** Moves to a point. */
  EnergyMeasure &at(const Point<dim> &x) {
    if (!is_constant_)
      hooke_ = material_.hooke(x);
    return *this;
  }
  /** Returns ε:C:ε at the last point. */
  double density(const SymmetricTensor<2, dim> &strain) const {
    return (hooke_ * strain) * strain;
  }
  /** Returns the integral over the points of a rule, for a displacement with these gradients. */
  double energy(const FEValuesBase<dim> &values, const std::vector<Tensor<2, dim>> &gradients) {
    double sum = 0.;
    for (const unsigned int q : values.quadrature_point_indices())
      sum +=
        at(values.quadrature_point(q)).density(strain_of(gradients[q])) * measure_at(values, q);
    return sum;
  }

private:
  const Material<dim> &material_;
  bool is_constant_;
  SymmetricTensor<4, dim> hooke_;
};
} // namespace Signorini
