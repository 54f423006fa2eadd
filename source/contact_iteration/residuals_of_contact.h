// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/contact_iteration/contact_iteration.h>

namespace Signorini
{
/** vector += D P. */
void add_product(const Coupling &D, const dealii::Vector<double> &P, NodalVector &vector);

/** Sets kkt_residual and stationarity of U and P. @return f + D P - A U. */
NodalVector measure(const ContactSystem &system, ContactIterationResult &result);
} // namespace Signorini
