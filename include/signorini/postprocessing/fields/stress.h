// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/problem/scene/material.h>
#include <signorini/problem/scene/strain.h>

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>

#include <array>

namespace Signorini {
/** The stress with all its components, also those of a 2-D body that point out of the plane
 * (force/area). */
using Stress3D = SymmetricTensor<2, 3>;

/** Computes stresses of a material. */
template <int dim>
class StressIn3D {
public:
  /** @param material must outlive the object. */
  explicit StressIn3D(const Material<dim> &material)
    : material_(material) {}

  /**
   * Returns σ = E : ε at @p x, a point of the cell with the middle @p middle. E is that of the cell
   * where it jumps from cell to cell. In 2-D σ_xz = σ_yz = 0, and σ_zz is
   * the stress across the plane; in bodies of revolution it is that around the axis.
   * @throws InputError where the material's data has no value.
   */
  Stress3D operator()(const Point<dim> &x, const Point<dim> &middle, const Strain<dim> &strain);

private:
  const Material<dim> &material_;
  /** The law at the last point. */
  HookesLaw<dim> law_;
  /** Whether Hooke's tensor is the same at all points. */
  bool is_known_ = false;
};

/** Returns the von Mises stress sqrt(3/2 s:s), s = σ - tr σ/3 I. */
double von_mises(const Stress3D &stress);

/** Returns the three eigenvalues of σ, the largest (the most tensile) first. */
std::array<double, 3> principal_stresses(const Stress3D &stress);
} // namespace Signorini
