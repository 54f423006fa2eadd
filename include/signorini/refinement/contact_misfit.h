// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/multiplier/multiplier_space.h>
#include <signorini/refinement/smoothness.h>

namespace Signorini
{
/**
 * Adds to the indicators what contact leaves open: where all multipliers of a face press, u_n = g
 * in the exact solution, but u_h fulfils it in the mean only. On a face of length h and degree p
 * the difference r has about p half-waves, and to press the body flat takes about the energy
 *
 *     modulus pi/2 p/h ‖r‖_0^2,
 *
 * that of a half-space with waves of the number pi p/h. @throws InputError where g has no value.
 */
void add_contact_misfit(const DisplacementSpace<2> &space,
                        const MultiplierSpace<2> &multipliers,
                        const Scene<2> &scene,
                        const NodalVector &U,
                        const dealii::Vector<double> &P,
                        std::vector<CellIndicator> &indicators);
} // namespace Signorini
