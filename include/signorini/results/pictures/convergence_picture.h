// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/results/pictures/pictures.h>
#include <signorini/results/record/level_record.h>

#include <optional>
#include <vector>

namespace Signorini
{
/**
 * Makes convergence.svg: the relative error in the energy norm over the number of unknowns, double
 * logarithmic: its estimate, its bound, and the error itself where the exact solution is known. On
 * nested meshes the key has the order in h, the slope over the last four levels, and a triangle
 * shows order 1.
 * @return nothing if no level has an error above rounding.
 */
std::optional<Picture> convergence_picture(const std::vector<LevelRecord> &levels);

/** Load cases in the order in which curves join them; all vectors have one entry for each. */
struct TravelCurve
{
  /** The travel of the foundation or of the plate (length). */
  std::vector<double> travel;
  /** The contact force (force per thickness). */
  std::vector<double> force_x, force_y;
  /** The largest contact pressure, positive in compression (force/area). */
  std::vector<double> peak;
  /** The length of the contact zones together (length). */
  std::vector<double> zone_length;
};

/**
 * Makes travel.svg: the contact force |F| against the travel, and the largest pressure and the
 * length of the contact zones against |F|. Numbers that are not finite leave a hole in a curve.
 * @return nothing for fewer than two cases.
 * @throws std::invalid_argument if the vectors have different sizes.
 */
std::optional<Picture> travel_picture(const TravelCurve &cases);
} // namespace Signorini
