// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/postprocessing/quantities/contact_zones.h>
#include <signorini/postprocessing/quantities/peak_pressure.h>

namespace Signorini
{
/** zones_of_polynomial() and peak_of_polynomial() are contact_zones() and peak_pressure() where
 * patches have polynomials. */
std::vector<ContactZone> zones_of_polynomial(const MultiplierSpace<2> &multipliers,
                                             const Pressure &P);
std::optional<PressureMaximum> peak_of_polynomial(const MultiplierSpace<2> &multipliers,
                                                  const Pressure &P,
                                                  const std::vector<SingularPlace<2>> &outside_of);
} // namespace Signorini
