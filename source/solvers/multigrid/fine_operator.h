// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/discretization/elasticity/displacement_space.h>
#include <signorini/problem/scene/scene.h>
#include <signorini/solvers/multigrid/cell_operator.h>

namespace Signorini {
/** Returns K on the finest level, with the matrices that would be assembled. The identities of
 * nodes are their degrees of freedom divided by dim. */
template <int dim>
CellOperator<dim, double> make_fine_operator(const DisplacementSpace<dim> &space,
                                             const Scene<dim> &scene);
} // namespace Signorini
