// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/contact_iteration/contact_iteration.h>

namespace Signorini
{
/**
 * The primal-dual active set method for (5), continued from the U, P and t of @p result. On a set S
 * MINRES solves
 *
 *     ( A     -D_S) (U  )   (f   )
 *     (-D_S^T   0 ) (P_S) = (-G_S),    P = 0 elsewhere,
 *
 * with the preconditioner diag(V, (t C^_1)_SS^{-1}), to a hundredth of the residual or to the
 * tolerance. Then S is {P < 0} within S and {W > 0} outside.
 */
void solve_by_minres(const ContactSystem &system,
                     const ContactIterationOptions &options,
                     ContactIterationResult &result);
} // namespace Signorini
