// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/pictures/gnuplot.h>
#include <signorini/record/level_record.h>

#include <optional>

namespace Signorini
{
/**
 * convergence.svg: the relative error in the energy norm over the number of unknowns, double
 * logarithmic: its estimate, its bound, and the error itself where the exact solution is known. On
 * nested meshes the key has the order in h, the slope over the last four levels, and a triangle
 * shows order 1.
 * @return nothing if no level has an error above rounding.
 */
std::optional<Picture> convergence_picture(const std::vector<LevelRecord> &levels);
} // namespace Signorini
