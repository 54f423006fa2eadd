// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/parameters/parameters.h>
#include <signorini/scene/geometry.h>
#include <signorini/scene/plate.h>

#include <vector>

namespace Signorini
{
/** Boundary/Plates with Load/Plate force, Plate moment and Plate travel. @throws InputError. */
std::vector<Plate> read_plates(const Given<std::string> &given,
                               const LoadParameters &load,
                               const Geometry<2> &geometry);
} // namespace Signorini
