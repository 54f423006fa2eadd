// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/problem/scene/scene.h>
#include <signorini/results/files/contact_files.h>
#include <signorini/results/pictures/gnuplot.h>

namespace Signorini
{
/**
 * Returns the contact boundary for pressure_picture(), with so many points on each of its pieces
 * that curves are smooth.
 */
std::vector<ContactSegment> trace_for_pictures(const DisplacementSpace<2> &space,
                                               const MultiplierSpace<2> &multipliers,
                                               const Displacement &U,
                                               const Pressure &P);

/**
 * Makes pressure.svg: for every contact side the contact pressure -p (positive in compression; p_H,
 * the recovered pressure, and the exact one where it is known), and below it the opening g - u_n,
 * over arc length. Where p_H presses, the ground is coloured.
 * @param line not empty.
 */
Picture pressure_picture(const Scene<2> &scene, const std::vector<ContactSegment> &line);
} // namespace Signorini
