// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/driver/sequence/sequence.h>
#include <signorini/problem/scene/scene.h>

#include <array>

namespace Signorini {
/** Returns the levels from the first one that can begin to the last one with less than half a
 * million unknowns: not above the usual ones, and two at least, since one has no estimate. */
std::array<unsigned int, 2> levels_of_pairs(const Scene<2> &scene);
} // namespace Signorini
