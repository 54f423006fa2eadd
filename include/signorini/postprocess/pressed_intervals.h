// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/multiplier/multiplier_space.h>

#include <vector>

namespace Signorini
{
/** A part of a side that is pressed, as far as the nodes of the multipliers tell. */
struct PressedInterval
{
  struct End
  {
    /** Arc length; around a closed side the end of an interval may exceed the length (length). */
    double s = 0.;
    /** How far the exact end may be away, in order of magnitude (length). */
    double uncertainty = 0.;
  };
  /** Number of the side in the geometry. */
  unsigned int side = 0;
  End start, end;

  double length() const
  {
    return end.s - start.s;
  }
};

/**
 * The pressed intervals, side after side in the order of arc length.
 *
 * The nodes of the multipliers are points at which p_H presses or does not. Contact ends between
 * two neighbours that differ: the end is their middle, its uncertainty half of their distance.
 * Where pressing and open nodes alternate, contact ends only once between the first and the last
 * one of them, or, if these are of the same kind, there is a single gap or a single interval
 * between them. Where the first or the last node of a side presses, the interval ends with the
 * side, without uncertainty. A closed side that is pressed everywhere is an interval from 0 to its
 * length.
 */
std::vector<PressedInterval> pressed_intervals(const MultiplierSpace<2> &multipliers,
                                               const dealii::Vector<double> &P);
} // namespace Signorini
