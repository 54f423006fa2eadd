// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/problem/scene/scene.h>
#include <signorini/problem/scene/strain.h>

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/fe/fe_values.h>

namespace Signorini {
/** Returns dx at a point of a rule on a cell, or ds at one on a face: the one function that says
 * which integrals over the body and its boundary measure. The maps of bodies of revolution contain
 * the circumference. */
template <int dim>
double measure_at(const FEValuesBase<dim> &values, const unsigned int q) {
  return values.JxW(q);
}

/** Integrates energies, twice the elastic ones: ε:C:ε with Hooke's law C. */
template <int dim>
class EnergyMeasure {
public:
  /** The scene must outlive the object. */
  explicit EnergyMeasure(const Scene<dim> &scene)
    : scene_(scene)
    , is_constant_(scene.material->is_constant()) {
    if (is_constant_)
      set_law(Point<dim>());
  }

  /** Moves to a point. */
  EnergyMeasure &at(const Point<dim> &x) {
    x_ = x;
    if (!is_constant_)
      set_law(x);
    return *this;
  }
  /** Returns ε:C:ε at the last point, for a strain in the plane or in space. */
  double density(const SymmetricTensor<2, dim> &strain) const {
    return (law_.in_body * strain) * strain;
  }
  /** Returns the same for a displacement with this value and gradient. */
  double density(const Tensor<1, dim> &value, const Tensor<2, dim> &gradient) const {
    if (!scene_.geometry.axisymmetric)
      return density(strain_of(gradient));
    const Strain<dim> strain = strain_at(scene_.geometry, x_, value, gradient);
    return law_.stress(strain) * strain.in_body + law_.stress_across(strain) * *strain.hoop;
  }

private:
  void set_law(const Point<dim> &x) {
    const Material<dim> &material = *scene_.material;
    law_.in_body = material.hooke(x);
    if (scene_.geometry.axisymmetric)
      law_.across = material.across(x);
  }

  const Scene<dim> &scene_;
  bool is_constant_;
  Point<dim> x_;
  HookesLaw<dim> law_;
};
} // namespace Signorini
