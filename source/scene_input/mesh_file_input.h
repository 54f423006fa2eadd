// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/parameters/parameters.h>
#include <signorini/scene/geometry.h>

namespace Signorini
{
/** The body of Geometry/File. @throws InputError */
Geometry<2> read_mesh_file(const GeometryParameters &given);
} // namespace Signorini
