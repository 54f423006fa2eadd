// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/discretization/space/displaced_body.h>

namespace Signorini {
/** Returns a modulus for the energy of all strains but those that incompressible bodies avoid, the
 * softer one of pressing and shearing (force/area). */
template <int dim>
double softer_modulus(const Scene<dim> &scene, const Point<dim> &x);

/**
 * Returns the share of an error in contact in the energy norm: u_n <= g holds in the mean over
 * patches only, and where contact is smaller than a patch, or hides between the nodes, no recovered
 * pressure shows it. It is about the contact part of the bound (doc/bound.md), the least of
 *
 *     |||w|||² + 2 ∫ p_H (d - w_n),   d = u_{h,n} - g <= w_n on Γ_c.
 *
 * Γ_c consists of stretches between corners on which d has one sign. Where d > 0, w_n = d. Where d
 * < 0 and p_H presses, w_n is d or zero, whichever costs less. On a stretch of length l, w has
 * about the energy of a half-space with waves of the number π/(2 l),
 *
 *     |||w|||² = modulus π/(4 l) ‖w_n‖_0².
 *
 * A rigid parabola that nothing has stopped at the depth d has ‖d‖² = 8 l d²/15, which gives 0.42
 * modulus d². Hertz' theory has π modulus d²/(2 Λ + 1), Λ = ln(4 L/l) up to a constant for a body
 * of size L: 0.63 for Λ = 2 and 0.35 for Λ = 4. A sphere has 0.82 by this rule, and 0.75 modulus l
 * d² by Hertz. In a pair the modulus is 1/(1/E_1 + 1/E_2). In 3-D the part of a patch where d has
 * one sign replaces a stretch, and the root of its area that of l.
 * @throws InputError where g has no value. Collective.
 */
template <int dim>
double contact_part(const BodyInContact<dim> &body);
} // namespace Signorini
