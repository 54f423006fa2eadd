// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <optional>
#include <vector>

namespace Signorini
{
/** Where the body lies as seen from a circle. */
enum class Body
{
  inside,
  outside
};

/**
 * A segment or a circular arc on the boundary of a plane body. Its coordinate is the arc length s
 * from its start, 0 <= s <= length().
 */
class Curve
{
public:
  /** A segment with the outward unit @p normal. */
  Curve(const dealii::Point<2> &start,
        const dealii::Point<2> &end,
        const dealii::Tensor<1, 2> &normal);

  /**
   * The arc about @p centre from the angle @p first to the angle @p last > first (radians, counted
   * from the x-axis); a whole circle where they differ by 2 pi.
   */
  static Curve
  arc(const dealii::Point<2> &centre, double radius, double first, double last, Body body);

  const dealii::Point<2> &start() const
  {
    return start_;
  }
  /** The same as the start on a closed curve. */
  const dealii::Point<2> &end() const
  {
    return end_;
  }
  double length() const
  {
    return length_;
  }
  /** Whether the normal is the same everywhere. */
  bool is_flat() const
  {
    return !circle_;
  }
  /** Whether this is a whole circle: s and s + length() are the same point. */
  bool is_closed() const;

  /** x(s); segments and circles go on beyond their ends. */
  dealii::Point<2> point(double s) const;
  /** n(s), the outward unit normal. */
  dealii::Tensor<1, 2> normal(double s) const;
  /** The same with s as a point of the real line. */
  dealii::Point<2> point(const dealii::Point<1> &s) const
  {
    return point(s[0]);
  }
  dealii::Tensor<1, 2> normal(const dealii::Point<1> &s) const
  {
    return normal(s[0]);
  }
  dealii::Point<1> coordinates(const dealii::Point<2> &x) const
  {
    return dealii::Point<1>(arc_length(x));
  }
  dealii::Point<2> centre() const
  {
    return point(0.5 * length_);
  }
  /** s of a point on the curve; on a circle from 0 (included) to its circumference. */
  double arc_length(const dealii::Point<2> &x) const;

  /** All s in [from, to], sorted, at which the curve, continued beyond its ends, meets the line
   * m.x = position with the unit normal @p m; none for a line along a segment. */
  std::vector<double>
  crossings(const dealii::Tensor<1, 2> &m, double position, double from, double to) const;

private:
  struct Circle
  {
    dealii::Point<2> centre;
    double radius;
    /** The angle at s = 0. */
    double first;
    /** 1 if the body lies inside, -1 outside. */
    double orientation;
  };

  dealii::Point<2> start_;
  dealii::Point<2> end_;
  double length_;
  /** Of a segment; of a circle the one at s = 0. */
  dealii::Tensor<1, 2> normal_;
  std::optional<Circle> circle_;
};
} // namespace Signorini
