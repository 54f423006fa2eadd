// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace Signorini
{
/**
 * Lengths and moduli of a described scene lie between these bounds, loads and displacements below
 * the upper one: far enough from the ends of the double precision for products such as an energy
 * f² L⁴/E or a determinant of moduli. Other units bring every real body into this range.
 */
constexpr double smallest_magnitude = 1e-30;
constexpr double largest_magnitude = 1e30;

/** How many times its own size a body may lie away from the origin: x - y loses that much. */
constexpr double largest_distance = 1e6;

/** How many times longer than thick a body may be, and longer than its shortest side. */
constexpr double largest_slenderness = 1e6;
} // namespace Signorini
