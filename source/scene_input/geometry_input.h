// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/parameters/parameters.h>
#include <signorini/scene/geometry.h>

namespace Signorini
{
/** The geometry that a parameter file describes. @throws InputError */
Geometry<2> make_geometry(const Parameters &parameters);
} // namespace Signorini
