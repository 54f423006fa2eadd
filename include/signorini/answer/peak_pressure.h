// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/answer/boundary_place.h>
#include <signorini/multiplier/multiplier_space.h>

#include <optional>

namespace Signorini
{
/** The largest contact pressure, positive in compression (force/area). */
struct PeakPressure
{
  double value = 0.;
  BoundaryPlace place;
  /** The mean of -p_H over the patch on which the peak lies. */
  double mean = 0.;
};

/**
 * The maximum of a pressure that is recovered from the means over patches; empty if nothing
 * presses. Where both neighbours of a patch press, it is the parabola with the means of the three
 * patches, elsewhere RecoveredPressure. Both are of second order. Where patches have polynomials,
 * it is the largest value of -p_H on the patches that press.
 *
 * In space, where all four neighbours press, the sum of the parabolas in both coordinates, less the
 * mean of the patch. At the edge of the side to a roller the mirror image is the neighbour, if the
 * material is its own mirror image.
 */
std::optional<PeakPressure> peak_pressure(const MultiplierSpace<2> &multipliers,
                                          const dealii::Vector<double> &P);
std::optional<PeakPressure> peak_pressure(const MultiplierSpace<3> &multipliers,
                                          const dealii::Vector<double> &P);
} // namespace Signorini
