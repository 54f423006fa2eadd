// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "block_grid.h"

namespace Signorini
{
/** x += P x_H: functions that are linear along the edges of the coarse cells, at the nodes of the
 * fine level. */
template <int dim>
void prolongate(LevelVector<dim, float> &x,
                const LevelVector<dim, float> &x_H,
                const BlockGrid<dim> &fine,
                const BlockGrid<dim> &coarse);

/** b_H = P^T (b - y). */
template <int dim>
void restrict_residual(LevelVector<dim, float> &b_H,
                       const LevelVector<dim, float> &b,
                       const LevelVector<dim, float> &y,
                       const BlockGrid<dim> &fine,
                       const BlockGrid<dim> &coarse);
} // namespace Signorini
