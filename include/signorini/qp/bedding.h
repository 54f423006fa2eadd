// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/qp/pressing_patches.h>

namespace Signorini
{
/**
 * The dual problem with separate springs, C = diag(c): P_i = -(B_i z - F_i)_+/c_i, where z
 * minimises
 *
 *   1/2 sum_i (B_i z - F_i)_+^2/c_i + 1/2 z.K z - b.z
 *
 * (Winkler's bedding). Newton's method with a line search; a start for the true compliance. It
 * carries the load b, so patches that press in it can.
 */
MotionState solve_on_bedding(const SeenMotions &motions,
                             const dealii::Vector<double> &F,
                             const dealii::Vector<double> &c);
} // namespace Signorini
