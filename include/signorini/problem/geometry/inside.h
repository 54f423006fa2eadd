// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/problem/geometry/geometry.h>

namespace Signorini {
/** Returns the distance of a point from the sides [first, last), which bound one body; negative
 * inside of it. */
double signed_distance(const std::vector<Side<2>> &sides, std::size_t first, std::size_t last,
                       const Point<2> &x);

/** Returns the distance of a point from the body, or from the nearest of several; not positive
 * inside. */
double distance_from_body(const Geometry<2> &geometry, const Point<2> &x);
double distance_from_body(const Geometry<3> &geometry, const Point<3> &x);
} // namespace Signorini
