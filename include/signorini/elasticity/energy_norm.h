// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/elasticity/displacement_space.h>

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
 * What errors in the energy norm are compared with: |||u_h|||, or what rounding makes of it where
 * that is larger. Where a body moves as a whole, |||u_h||| and its error are nothing but rounding.
 *
 * @param norm |||u_h|||
 */
template <int dim>
double energy_scale(double norm,
                    const DisplacementSpace<dim> &space,
                    const Scene<dim> &scene,
                    const NodalVector &U);

/** The same, with the norm computed. Collective. */
template <int dim>
double energy_scale(const DisplacementSpace<dim> &space,
                    const Scene<dim> &scene,
                    const NodalVector &U);
} // namespace Signorini
