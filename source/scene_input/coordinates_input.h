// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/parameters/given.h>
#include <signorini/scene/geometry.h>

#include <string>
#include <vector>

namespace Signorini
{
/** "x, y" or "x, y, z": n numbers. @p text is all of the entry or a part of it. @throws InputError
 */
std::vector<double> read_coordinates(const std::string &text, unsigned int n, const Entry &entry);

/** Beyond largest_magnitude, squares of lengths would overflow before the size of the body could be
 * judged. */
template <int dim>
void check_coordinates(const std::vector<dealii::Point<dim>> &points, const std::string &where);

/** Whether the body can be computed with at all; @p where is the parameter that made it. */
template <int dim>
void check_size(const Geometry<dim> &geometry, const std::string &where);
} // namespace Signorini
