// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/qp/pressing_patches.h>

#include <optional>

namespace Signorini
{
/**
 * The dual problem with free motions by a primal active set method, for problems on which proximal
 * iteration does not settle: bodies that are nearly rigid beside the gaps that they close.
 *
 * It begins with a pressure in balance, on as few patches as there are motions, and solves exactly
 * on the patches that press (solve_on_pressing()). Where a patch would pull, the way there ends at
 * the first zero, and the patch leaves; where the exact solution presses everywhere, the patch with
 * the largest penetration joins. The energy 1/2 P^T C P - P^T F falls in every step, so no set
 * comes back (J. Nocedal, S. Wright: Numerical Optimization, 2006, section 16.5).
 *
 * @param most_solves before giving up; @param n_solves counts them.
 * @return nothing if there is no pressure in balance or the steps do not end.
 */
std::optional<MotionState> descend(const ComplianceOperator &C,
                                   const dealii::Vector<double> &F,
                                   const SeenMotions &motions,
                                   unsigned int most_solves,
                                   unsigned int &n_solves);
} // namespace Signorini
