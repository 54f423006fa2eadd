// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/solvers/contact/contact_iteration.h>

namespace Signorini {
/** Returns the unit roundoff times |A x|/|x| for a rough x. */
double rounding_of(const StiffnessOperator &A);

/**
 * Sets kkt_residual, stationarity and complementarity of U and P, and whether they are small
 * enough.
 * @return f + D P - A U.
 */
NodalVector measure(const ContactSystem &system, const ContactIterationOptions &options,
                    ContactIterationResult &result);
} // namespace Signorini
