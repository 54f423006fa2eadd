// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <algorithm>
#include <array>

namespace Signorini
{
/** The parabola with given means over three intervals that follow one another. */
class MeanParabola
{
public:
  /** The function at a point. */
  struct Value
  {
    double s, value;
  };
  /** @param ends of the intervals, in their order. */
  MeanParabola(const std::array<double, 4> &ends, const std::array<double, 3> &means)
    : from_(ends[1])
    , to_(ends[2])
  {
    // With the primitive's divided differences over the four ends e_0 < ... < e_3, from e_1.
    const std::array<double, 4> e = {{ends[0] - from_, 0., to_ - from_, ends[3] - from_}};
    const double first = (means[1] - means[0]) / (e[2] - e[0]);
    const double second = ((means[2] - means[1]) / (e[3] - e[1]) - first) / (e[3] - e[0]);
    // d/ds of (s-e0) m0 + (s-e0)(s-e1) first + (s-e0)(s-e1)(s-e2) second.
    curvature_ = 3. * second;
    slope_ = 2. * first - 2. * second * (e[0] + e[1] + e[2]);
    constant_ =
      means[0] - first * (e[0] + e[1]) + second * (e[0] * e[1] + e[0] * e[2] + e[1] * e[2]);
  }
  /** Its maximum if that lies in the middle interval, else the value in its middle: where the
   * parabola is monotone, a neighbour has a larger value. */
  Value maximum() const
  {
    const double top = curvature_ < 0. ? from_ - slope_ / (2. * curvature_) : from_;
    return at(top > from_ && top < to_ ? top : 0.5 * (from_ + to_));
  }
  /** The same where the maximum may lie at an end, up to rounding. */
  Value maximum_with_ends() const
  {
    const double top = curvature_ < 0. ? from_ - slope_ / (2. * curvature_) : 2. * from_ - to_;
    const double slack = 1e-9 * (to_ - from_);
    return at(top > from_ - slack && top < to_ + slack ? std::clamp(top, from_, to_)
                                                       : 0.5 * (from_ + to_));
  }

private:
  Value at(const double s) const
  {
    const double t = s - from_;
    return {s, constant_ + t * (slope_ + t * curvature_)};
  }

  double from_, to_;
  double constant_, slope_, curvature_;
};
} // namespace Signorini
