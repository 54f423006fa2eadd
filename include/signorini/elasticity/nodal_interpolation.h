// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/elasticity/displacement_space.h>

#include <deal.II/base/function.h>

namespace Signorini
{
/** I^h u: the values of u at the nodes of V^h, all of them on every rank. */
template <int dim>
NodalVector interpolate_at_nodes(const DisplacementSpace<dim> &space,
                                 const dealii::Function<dim> &u);
} // namespace Signorini
