// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/multiplier/multiplier_space.h>

namespace Signorini
{
/** The values of p_H at the nodes of other multipliers on the same sides, cut off at zero: a start
 * for an active set. */
dealii::Vector<double> transfer_pressure(const MultiplierSpace<2> &from,
                                         const dealii::Vector<double> &P,
                                         const MultiplierSpace<2> &to);
} // namespace Signorini
