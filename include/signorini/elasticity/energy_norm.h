// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/elasticity/displacement_space.h>

#include <optional>

namespace Signorini
{
/**
 * |||u_h||| = a(u_h, u_h)^{1/2} with the strain of the element (root of force x length^{dim-1}),
 * from displacements relative to a corner of each cell: a rigid translation, however large, has no
 * energy. Collective.
 */
template <int dim>
double energy_norm(const DisplacementSpace<dim> &space,
                   const Scene<dim> &scene,
                   const NodalVector &U);

/**
 * Where the body moves as a whole, the energy norm that such a displacement has if it strains the
 * body: max|u_h| E_0^{1/2} l^{(dim-2)/2} with the unit of stiffness_unit(). |||u_h|||, forces and
 * their errors are nothing but rounding then, or what the linear solver leaves. None where the body
 * is strained. Collective.
 */
template <int dim>
std::optional<double> norm_of_rigid_motion(const DisplacementSpace<dim> &space,
                                           const Scene<dim> &scene,
                                           const NodalVector &U);

/**
 * What an error in the energy norm is compared with: |||u_h|||. Where the body moves rigidly,
 * |||u_h||| is rounding; an error that is rounding, too, is compared with norm_of_rigid_motion(),
 * and a larger one is all of |||u|||. Collective.
 *
 * @param norm |||u_h|||
 */
template <int dim>
double energy_scale(double norm,
                    double error,
                    const DisplacementSpace<dim> &space,
                    const Scene<dim> &scene,
                    const NodalVector &U);
} // namespace Signorini
