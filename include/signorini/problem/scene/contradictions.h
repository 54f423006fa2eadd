// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/problem/scene/scene.h>

#include <string>

namespace Signorini {
/**
 * Returns a sentence about a point where two sides that meet prescribe a displacement that jumps,
 * so that no displacement of finite energy (with traces in H^{1/2}) obeys both, or where a side
 * holds a plate that a force or a moment has to move; empty if there is no such point.
 *
 * At a common point x a clamped or prescribed side or a plate prescribes u = a(x) + V q, with the
 * unknown motions q of the plate, and its neighbour prescribes N u = N (b(x) + W r): N = 1 on sides
 * of the same kind and N = n^T on rollers. Both hold for all q and r if N a = N b, N V = 0 and N
 * W = 0. In 2-D the points are the corners, in 3-D they are points of the common edges. Jumps below
 * a millionth of the prescribed displacements count as rounding. A contact
 * side beside a prescribed one, or a roller with its normal, needs a.n <= g at the common point. In
 * a pair of bodies only displacements count that both sides prescribe at points across from each
 * other: (a_1 - a_2).n <= g; else the other body gives way.
 */
template <int dim>
std::string find_contradiction(const Scene<dim> &scene);
} // namespace Signorini
