// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/problem/geometry/geometry.h>
#include <signorini/problem/parameters/parameters.h>

#include <string>
#include <vector>

namespace Signorini
{
/** Reads the body of Shape = polygon. */
Geometry<2> read_polygon(const GeometryParameters &given);
} // namespace Signorini
