// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/scene/material.h>

#include <deal.II/base/symmetric_tensor.h>

#include <array>

namespace Signorini
{
/** The stress with all its components, also those of a plane body that point out of the plane
 * (force/area). */
using SpatialStress = dealii::SymmetricTensor<2, 3>;

/**
 * sigma = E : eps at @p x. In the plane sigma_xz = sigma_yz = 0, and sigma_zz is
 * Material::out_of_plane_stress().
 * @throws InputError where the material's data has no value.
 */
template <int dim>
SpatialStress stress_in_space(const Material<dim> &material,
                              const dealii::Point<dim> &x,
                              const dealii::SymmetricTensor<2, dim> &strain);

/** sqrt(3/2 s:s), s = sigma - tr sigma/3 I. */
double von_mises(const SpatialStress &stress);

/** The three eigenvalues of sigma, the largest (the most tensile) first. */
std::array<double, 3> principal_stresses(const SpatialStress &stress);
} // namespace Signorini
