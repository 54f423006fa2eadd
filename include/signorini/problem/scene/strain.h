// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/problem/geometry/geometry.h>
#include <signorini/problem/scene/material.h>

#include <deal.II/base/symmetric_tensor.h>

#include <cmath>
#include <optional>

namespace Signorini {
/** Returns the strain in the plane, or in space, of a displacement with this gradient. */
template <int dim>
SymmetricTensor<2, dim> strain_of(const Tensor<2, dim> &gradient) {
  return symmetrize(gradient);
}

/** A strain: in the plane or in space, and in bodies of revolution that around the axis. */
template <int dim>
struct Strain {
  SymmetricTensor<2, dim> in_body;
  /** The hoop strain u_x / x; empty in other bodies. */
  std::optional<double> hoop = {};

  double trace() const {
    return dealii::trace(in_body) + hoop.value_or(0.);
  }
  /** Replaces the trace and keeps the deviator. */
  void replace_trace(const double dilatation) {
    const double change = (dilatation - trace()) / (hoop ? dim + 1 : dim);
    in_body += change * unit_symmetric_tensor<dim>();
    if (hoop)
      *hoop += change;
  }
};

/** Returns the strain at a point of a displacement with this value and gradient. On the axis of a
 * body of revolution u_x / x is its limit. */
template <int dim>
Strain<dim> strain_at(const Geometry<dim> &geometry, const Point<dim> &x,
                      const Tensor<1, dim> &value, const Tensor<2, dim> &gradient) {
  Strain<dim> strain = {strain_of(gradient)};
  if (geometry.axisymmetric)
    strain.hoop = x[0] > 1e-12 * geometry.upper[0] ? value[0] / x[0] : gradient[0][0];
  return strain;
}

/** Returns |grad v|² in space: that of a body of revolution contains (v_x / x)². */
template <int dim>
double gradient_square(const Geometry<dim> &geometry, const Point<dim> &x,
                       const Tensor<1, dim> &value, const Tensor<2, dim> &gradient) {
  return gradient.norm_square() +
         (geometry.axisymmetric ? std::pow(*strain_at(geometry, x, value, gradient).hoop, 2) : 0.);
}

/** Hooke's law at a point, C in the body and the law across the plane. */
template <int dim>
struct HookesLaw {
  SymmetricTensor<4, dim> in_body;
  AcrossLaw<dim> across;

  /** Returns the stress in the body. */
  SymmetricTensor<2, dim> stress(const Strain<dim> &strain) const {
    return strain.hoop ? in_body * strain.in_body + *strain.hoop * across.coupling
                       : in_body * strain.in_body;
  }
  /** Returns the stress around the axis, or across the plane. */
  double stress_across(const Strain<dim> &strain) const {
    return across.coupling * strain.in_body + across.modulus * strain.hoop.value_or(0.);
  }
};
} // namespace Signorini
