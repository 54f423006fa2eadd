// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/problem/scene/scene.h>

#include <string>

namespace Signorini
{
/**
 * Says where two sides that meet prescribe a displacement that jumps, so that no displacement of
 * finite energy (with traces in H^{1/2}) obeys both, or where a side holds a plate that a force or
 * a moment has to move; empty if there is no such place.
 *
 * At a common point x a clamped or prescribed side or a plate says u = a(x) + V q, with the unknown
 * motions q of the plate, and its neighbour says N u = N (b(x) + W r): N = 1 on sides of the same
 * kind and N = n^T on rollers. Both hold for all q and r if N a = N b, N V = 0 and N W = 0. In the
 * plane the points are the corners, in space they are points of the common edges. What is below a
 * millionth of the prescribed displacements counts as rounding. Contact sides are left out: how far
 * they penetrate where a side holds the body is known to the bound of the error.
 */
template <int dim>
std::string find_contradiction(const Scene<dim> &scene);
} // namespace Signorini
