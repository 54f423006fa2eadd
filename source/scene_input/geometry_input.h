// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/parameters/parameters.h>
#include <signorini/scene/geometry.h>

namespace Signorini
{
/** The body that the entries describe. @throws InputError */
Geometry<2> make_geometry(const GeometryParameters &given);
} // namespace Signorini
