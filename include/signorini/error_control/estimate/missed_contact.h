// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/discretization/space/displacement_space.h>
#include <signorini/discretization/space/multiplier_space.h>

namespace Signorini {
/**
 * Returns the energy norm of a w that removes the penetration of open patches which touch no
 * pressing one. There u_h may be deep in the foundation while u_n - g has a mean that is not
 * positive, and no recovered pressure shows it. With d = (u_n - g)_+ on a patch of length H, w has
 * about the energy of a half-space with waves of the length 4 H,
 *
 *     |||w|||² = modulus π/(2 H) ‖d‖_0².
 *
 * The function is for 3-D only: in 2-D the guaranteed bound has the energy of a true w.
 * @throws InputError where g has no value. Collective.
 */
double energy_of_missed_contact(const DisplacementSpace<3> &space,
                                const MultiplierSpace<3> &multipliers, const Scene<3> &scene,
                                const Displacement &U, const Pressure &P);
} // namespace Signorini
