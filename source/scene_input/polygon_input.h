// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/parameters/parameters.h>
#include <signorini/scene/geometry.h>

#include <string>
#include <vector>

namespace Signorini
{
/** Shape = polygon. */
Geometry<2> read_polygon(const GeometryParameters &given);
} // namespace Signorini
