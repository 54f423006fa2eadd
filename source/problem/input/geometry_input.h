// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/problem/geometry/geometry.h>
#include <signorini/problem/parameters/parameters.h>

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

/** With Dimension = 3: refuses entries for which there is mathematics in the plane only.
 * @throws InputError */
void refuse_what_is_plane(const Parameters &parameters);

/** The body that the entries describe. @throws InputError */
template <int dim>
Geometry<dim> make_geometry(const GeometryParameters &given);
template <>
Geometry<2> make_geometry(const GeometryParameters &given);
template <>
Geometry<3> make_geometry(const GeometryParameters &given);
} // namespace Signorini
