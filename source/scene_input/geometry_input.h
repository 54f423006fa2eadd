// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/parameters/parameters.h>
#include <signorini/scene/geometry.h>

namespace Signorini
{
/** The body that the entries describe. @throws InputError */
template <int dim>
Geometry<dim> make_geometry(const GeometryParameters &given);
template <>
Geometry<2> make_geometry(const GeometryParameters &given);
template <>
Geometry<3> make_geometry(const GeometryParameters &given);
} // namespace Signorini
