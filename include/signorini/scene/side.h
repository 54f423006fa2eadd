// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <optional>
#include <string>
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
 * A straight piece or a circular arc of the boundary, with its own name. Points on it are given by
 * the arc length s from its start, 0 <= s <= length().
 */
template <int dim>
class Side
{
public:
  /** A straight piece with the outward unit @p normal. */
  Side(std::string name,
       const dealii::Point<dim> &start,
       const dealii::Point<dim> &end,
       const dealii::Tensor<1, dim> &normal);

  /**
   * The arc about @p centre from the angle @p first to the angle @p last > first (radians, counted
   * from the x-axis); a whole circle where they differ by 2 pi.
   */
  static Side arc(std::string name,
                  const dealii::Point<dim> &centre,
                  double radius,
                  double first,
                  double last,
                  Body body);

  const std::string &name() const
  {
    return name_;
  }
  const dealii::Point<dim> &start() const
  {
    return start_;
  }
  /** The same as the start on a closed side. */
  const dealii::Point<dim> &end() const
  {
    return end_;
  }
  double length() const
  {
    return length_;
  }
  bool is_straight() const
  {
    return !circle_;
  }
  /** Whether it is a whole circle: s and s + length() are the same point. */
  bool is_closed() const;

  /** x(s); straight sides and circles go on beyond their ends. */
  dealii::Point<dim> point(double s) const;
  /** n(s), the outward unit normal. */
  dealii::Tensor<1, dim> normal(double s) const;
  /** s of a point on the side; on a circle from 0 (included) to its circumference. */
  double arc_length(const dealii::Point<dim> &x) const;

  /** All s in [from, to], sorted, at which the side, continued beyond its ends, meets the line
   * m.x = position with the unit normal @p m; none for a line along a straight side. */
  std::vector<double>
  crossings(const dealii::Tensor<1, dim> &m, double position, double from, double to) const;

private:
  struct Circle
  {
    dealii::Point<dim> centre;
    double radius;
    /** The angle at s = 0. */
    double first;
    /** 1 if the body lies inside, -1 outside. */
    double orientation;
  };

  std::string name_;
  dealii::Point<dim> start_;
  dealii::Point<dim> end_;
  double length_;
  /** Of a straight side; of a circle the one at s = 0. */
  dealii::Tensor<1, dim> normal_;
  std::optional<Circle> circle_;
};
} // namespace Signorini
