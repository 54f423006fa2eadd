// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/error_control/hp/cell_indicator.h>

#include <vector>

namespace Signorini {
/**
 * Adds the misfit of contact to the indicators: where all multipliers of a face press, u_n = g in
 * the exact solution, but u_h fulfils it in the mean only; where all stick, this holds for u_t =
 * g_t. On a face of length h and degree p the difference r has about p half-waves, and to press the
 * body flat takes about the energy
 *
 *     modulus π/2 p/h ‖r‖_0²,
 *
 * that of a half-space with waves of the number π p/h. @throws InputError where g has no value.
 */
void add_contact_misfit(const BodyInContact<2> &body, Component component,
                        std::vector<CellIndicator> &indicators);

/** Returns the active cells with a contact face on which the body penetrates the foundation
 * although no multiplier there or on a neighbouring face presses: the nodes of the multipliers have
 * missed the contact. Where nothing presses at all, every penetration counts, else those deeper
 * than a thousandth of the largest |u_n - g|. @throws InputError where g has no value. */
std::vector<unsigned int> missed_contact_cells(const BodyInContact<2> &body);
} // namespace Signorini
