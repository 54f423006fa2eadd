// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/problem/geometry/geometry.h>
#include <signorini/problem/parameters/parameters.h>

#include <string>
#include <vector>

namespace Signorini
{
/** Reads "x, y" or "x, y, z": n numbers. @p text is all of the entry or a part of it. @throws
 * InputError */
std::vector<double> read_coordinates(const std::string &text, unsigned int n, const Entry &entry);

/** Refuses coordinates beyond largest_magnitude, whose squares would overflow before the size of
 * the body is checked. */
template <int dim>
void check_coordinates(const std::vector<dealii::Point<dim>> &points, const std::string &where);

/** Refuses a body that is too large, too small or too far away to compute with; @p where is the
 * parameter that made it. */
template <int dim>
void check_size(const Geometry<dim> &geometry, const std::string &where);

/** Refuses, with Dimension = 3, entries that exist in 2-D only. @throws InputError */
void refuse_what_is_plane(const Parameters &parameters);

/** Returns the body that the entries describe. @throws InputError */
template <int dim>
Geometry<dim> make_geometry(const GeometryParameters &given);
template <>
Geometry<2> make_geometry(const GeometryParameters &given);
template <>
Geometry<3> make_geometry(const GeometryParameters &given);
} // namespace Signorini
