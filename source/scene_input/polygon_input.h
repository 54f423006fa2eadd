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

/** "x, y". */
std::vector<double> two_numbers(const std::string &text, const Entry &entry);

/** Beyond largest_magnitude, squares of lengths would overflow before the size of the body could be
 * judged. */
void check_coordinates(const std::vector<dealii::Point<2>> &points, const std::string &where);

/** Whether the body can be computed with at all; @p where is the parameter that made it. */
void check_size(const Geometry<2> &geometry, const std::string &where);
} // namespace Signorini
