// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/problem/geometry/geometry.h>

#include <deal.II/base/function.h>
#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

namespace Signorini {
/** Returns a gap, or zero where it is rounding of lengths of the given size: a body that fits its
 * foundation has no gap, and no noise that presses it. */
inline double without_rounding(const double gap, const double size) {
  constexpr double rounding = 8. * std::numeric_limits<double>::epsilon();
  return std::abs(gap) <= rounding * size ? 0. : gap;
}

/** A rigid obstacle: the set of points that a body cannot enter. */
template <int dim>
class Obstacle {
public:
  using Vector = Tensor<1, dim>;

  /** Returns the half-space (x - point).normal <= 0; @p normal (not zero, of any length) points out
   * of it, towards the body. */
  static Obstacle plane(const Point<dim> &point, const Vector &normal);

  /** Returns the region behind the curve x(t) = point + t tau + (curvature/2) t² nu, where nu is
   * normal/|normal| and tau is perpendicular to it (t: length, curvature: 1/length). It bends away
   * from the body where curvature < 0. In 2-D. */
  static Obstacle parabola(const Point<dim> &point, const Vector &normal, double curvature);

  /** Returns a disc or a ball if the body lies outside of it, or its complement if the body lies
   * inside. */
  static Obstacle circle(const Point<dim> &centre, double radius, Body body);

  /** Returns a round cylinder about the axis through a point (@p axis not zero, of any length), or
   * its complement. In space. */
  static Obstacle cylinder(const Point<dim> &point, const Vector &axis, double radius, Body body);

  /**
   * Returns the t (length) at which the line x + t n, |n| = 1, enters the obstacle: positive for a
   * point ahead, negative where x lies inside already.
   *
   * Where x lies outside of a round thing or of a parabola that bends away, and no point of it lies
   * ahead, t is sqrt(t_1 t_2) with the (complex) t_i at which the line meets its boundary; for a
   * disc, the length of the tangent from x. So the distance is continuous. It is empty where a line
   * from outside does not lead to a plane or runs along a cylinder, and where n points out of an
   * obstacle other than a round thing or such a parabola from inside.
   */
  std::optional<double> distance(const Point<dim> &x, const Vector &n) const;

  /** Returns whether a line with the direction n, |n| = 1, can enter the obstacle, wherever that is
   * moved. */
  bool can_be_hit_along(const Vector &n) const;

  /** Returns whether the line x + t n, |n| = 1, enters the obstacle at t < @p reach (length), or x
   * lies in it. A line that misses does not count, although distance() has a value for it. */
  bool is_hit_by_line(const Point<dim> &x, const Vector &n, double reach) const;

  /** Returns the direction into a plane, along which it acts whatever the body's normal is; none
   * for others. */
  std::optional<Vector> direction() const;

  /** Returns the unit normal, out of the obstacle, where the line x + t n, |n| = 1, enters it; none
   * where distance() is empty. */
  std::optional<Vector> normal_at_entry(const Point<dim> &x, const Vector &n) const;

  /** Returns a point of a plane, a parabola or an axis, or the centre. */
  const Point<dim> &anchor() const;

private:
  /** A parabola, or a plane, which has the curvature 0. */
  struct Parabola {
    Point<dim> point;
    Vector normal;
    double curvature;
  };
  /** A circle or a sphere, or a cylinder, which has an axis that is not zero. */
  struct Round {
    Point<dim> centre;
    Vector axis;
    double radius;
    Body body;

    /** Returns a vector without its part along the axis. */
    Vector across(const Vector &v) const {
      return v - (v * axis) * axis;
    }
  };

  struct LinePolynomial;

  explicit Obstacle(std::variant<Parabola, Round> shape);

  LinePolynomial along(const Point<dim> &x, const Vector &n) const;

  std::variant<Parabola, Round> shape_;
};

/** The rigid obstacles that a side of a body may touch. */
template <int dim>
class Foundation {
public:
  /** Stores the obstacles. @param max_gap the gap (length) where the normal meets no obstacle,
   * or one that is farther away. */
  Foundation(std::vector<Obstacle<dim>> things, double max_gap);

  /** Returns the smallest distance of the obstacles from x along n, at most max_gap() (length).
   */
  double gap(const Point<dim> &x, const Tensor<1, dim> &n) const;

  /**
   * Returns the direction m of contact at a point of a body with the outward normal n: that of the
   * obstacle with the smallest distance, which is measured into a plane that n faces, and along n
   * for others. None stands for n itself. Where n faces nothing, a plane that it faces elsewhere on
   * a round side goes on acting, unless the point lies behind it: a gap that jumps to a large
   * number has moments of both signs.
   */
  std::optional<Tensor<1, dim>> direction(const Point<dim> &x, const Tensor<1, dim> &n) const;

  /** Returns the unit normal of the obstacle to which gap() is the distance; none where that is
   * max_gap(). */
  std::optional<Tensor<1, dim>> normal_at_entry(const Point<dim> &x, const Tensor<1, dim> &n) const;

  double max_gap() const {
    return max_gap_;
  }
  const std::vector<Obstacle<dim>> &things() const {
    return obstacles_;
  }

private:
  /** Returns the smallest distance and its obstacle; none where that is max_gap(). */
  std::pair<double, const Obstacle<dim> *> nearest(const Point<dim> &x,
                                                   const Tensor<1, dim> &n) const;

  std::vector<Obstacle<dim>> obstacles_;
  double max_gap_;
};

/**
 * The directions m along which contact acts on a side: u.m <= g and sigma n = p m. On each of the
 * parts of the side m is constant, a plane's direction, or it is the outward normal n of the body;
 * in a pair of bodies it is the mean normal.
 */
template <int dim>
class ContactDirections;

template <>
class ContactDirections<2> {
public:
  /** Makes those of the paper, n everywhere. */
  ContactDirections() = default;
  /**
   * Makes the mean normals m = (n - n_2) / |n - n_2| of two sides that touch each other, n at x and
   * n_2 where the line along n meets the second side; n where it meets none. One side's normals
   * would cost an error of the first order in the width of contact where the materials differ, and
   * the mean normals cost one of the second order.
   */
  ContactDirections(const Side<2> &first, const Side<2> &second);
  /** Makes those of a foundation that was moved by @p position. Parts end where another obstacle is
   * the nearest one, found by samples: on a part that they miss m is that of its neighbours, and
   * the gap along that still counts all obstacles. */
  ContactDirections(const Side<2> &side, const Foundation<2> &foundation,
                    const Tensor<1, 2> &position);

  /** Returns the constant m of the part with the arc length s; none stands for n, or for the mean
   * normal. */
  std::optional<Tensor<1, 2>> at(double s) const;
  /** Returns m at a point @p x of the side with the outward normal @p n on the part with the arc
   * length @p s. */
  Tensor<1, 2> at(double s, const Point<2> &x, const Tensor<1, 2> &n) const;
  /** Returns the arc lengths at which parts end, without the ends of the side. */
  const std::vector<double> &changes() const {
    return changes_;
  }
  /** Returns whether a part ends between two arc lengths. */
  bool change_between(double from, double to) const;
  /** Returns whether contact acts along n everywhere. */
  bool are_normals() const;

private:
  std::vector<double> changes_;
  /** Those of the parts, one more than changes; empty: normals. */
  std::vector<std::optional<Tensor<1, 2>>> of_parts_;
  /** The second side of a pair with mean normals. */
  std::optional<Side<2>> second_;
};

/** In space m is that of the nearest obstacle at every point. */
template <>
class ContactDirections<3> {
public:
  /** Makes n everywhere. */
  ContactDirections() = default;
  /** Makes those of a foundation that was moved by @p position. */
  ContactDirections(const Side<3> &side, const Foundation<3> &foundation,
                    const Tensor<1, 3> &position);

  /** Returns m at a point @p x of the side with the outward normal @p n. */
  Tensor<1, 3> at(const Point<3> &x, const Tensor<1, 3> &n) const;
  /** Returns whether contact acts along n everywhere. */
  bool are_normals() const {
    return foundation_ == nullptr;
  }

private:
  /** Empty: normals. */
  std::shared_ptr<const Foundation<3>> foundation_;
  Tensor<1, 3> position_;
};

/**
 * Returns the gap g(x) of (1) on a side (length): the distance along the direction of contact to
 * the foundation that was moved by @p position, without_rounding(). Points beside a curved side
 * count as the nearest ones of the side. Thread-safe.
 */
template <int dim>
std::shared_ptr<const Function<dim>>
foundation_gap(const Side<dim> &side, const std::shared_ptr<const Foundation<dim>> &foundation,
               const Tensor<1, dim> &position, const ContactDirections<dim> &directions = {});

/**
 * Returns the gap of a pair of sides: @p given in addition to (y - x).m, where the line along the
 * outward normal at x meets the second side as drawn in y (length); @p given alone beside the
 * second side. The sum is without_rounding().
 */
std::shared_ptr<const Function<2>> gap_of_pair(const Side<2> &first, const Side<2> &second,
                                               const ContactDirections<2> &directions,
                                               const std::shared_ptr<const Function<2>> &given);
} // namespace Signorini
