// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace Signorini {
/** The part of a round body in space: planes of symmetry cut it into halves. */
enum class Sector { whole, half, quarter, octant };

/** The direction of the axis of a cylinder. */
enum class Axis { x, y, z };
} // namespace Signorini
