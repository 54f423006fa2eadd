// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/elasticity/displacement_space.h>

#include <vector>

namespace Signorini
{
/**
 * The mean of tr eps(u_h) over the parent of each active cell (over the cell itself where there is
 * no T^{2h}), in the order of active cells. With StrainOperator::mean_dilatation, means over cells
 * may alternate between neighbours, as the pressure of Q1-P0 does.
 */
template <int dim>
std::vector<double> mean_dilatations(const DisplacementSpace<dim> &space, const NodalVector &U);
} // namespace Signorini
