// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/pictures/gnuplot.h>

#include <optional>
#include <vector>

namespace Signorini
{
/** Load cases in the order in which curves join them; all vectors have one entry for each. */
struct TravelCurve
{
  /** How far the foundation or the plate moved (length). */
  std::vector<double> travel;
  /** The contact force (force per thickness). */
  std::vector<double> force_x, force_y;
  /** The largest contact pressure, positive in compression (force/area). */
  std::vector<double> peak;
  /** The length of the contact zones together (length). */
  std::vector<double> zone_length;
};

/**
 * travel.svg: the contact force |F| against the travel, and the largest pressure and the length of
 * the contact zones against |F|. Numbers that are not finite leave a hole in a curve.
 * @return nothing for fewer than two cases. @throws std::invalid_argument if the vectors have
 * different sizes.
 */
std::optional<Picture> travel_picture(const TravelCurve &cases);
} // namespace Signorini
