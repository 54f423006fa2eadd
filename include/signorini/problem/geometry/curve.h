// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <memory>
#include <optional>
#include <vector>

namespace Signorini {
/** The position of the body relative to a circle, a sphere or a cylinder. */
enum class Body { inside, outside };

/** A point of a side with the outward unit normal. */
template <int dim>
struct SurfacePoint {
  Point<dim> x;
  Tensor<1, dim> n;
};

/**
 * A segment, a circular arc or a chain of them on the boundary of a 2-D body. Its coordinate is the
 * arc length s from its start, 0 <= s <= length(). The cost of lookups in a chain grows like the
 * logarithm of the number of its pieces.
 */
class Curve {
public:
  /** Makes a segment with the outward unit @p normal. */
  Curve(const Point<2> &start, const Point<2> &end, const Tensor<1, 2> &normal);
  /** Makes a segment with the body on its left. */
  Curve(const Point<2> &start, const Point<2> &end);

  /**
   * Returns the arc about @p centre from the angle @p first to the angle @p last (radians, counted
   * from the x-axis), clockwise if last < first; a whole circle where they differ by 2 pi.
   */
  static Curve arc(const Point<2> &centre, double radius, double first, double last, Body body);

  /** Returns the arc between two points, which are equally far from the centre, with the body on
   * its left; a whole circle where they are the same. */
  static Curve arc_between(const Point<2> &start, const Point<2> &end, const Point<2> &centre,
                           bool counter_clockwise);

  /** Returns the centre of the circle through three points, @p a and others that differ from it by
   * @p u and @p v, which are not parallel. */
  static Point<2> circumcentre(const Point<2> &a, const Tensor<1, 2> &u, const Tensor<1, 2> &v);

  /** Returns the segment between two points, or the shorter arc about a centre, with the body on
   * its left. */
  static Curve between(const Point<2> &start, const Point<2> &end,
                       const std::optional<Point<2>> &centre);

  /**
   * Returns the chain of segments and arcs, each of which begins where the one before it ends, all
   * with the body on the same hand. Segments in a row on one line become one.
   */
  static Curve chain(const std::vector<Curve> &pieces);

  /** The smallest angle (radians) by which two pieces of a chain turn in a corner. Pieces that turn
   * less are parts of a smooth side, which a polygon may approximate. */
  static constexpr double min_corner_turn = 0.1;

  const Point<2> &start() const {
    return start_;
  }
  /** Returns the end, which is the start on a closed curve. */
  const Point<2> &end() const {
    return end_;
  }
  double length() const {
    return length_;
  }
  /** Returns whether the normal is the same everywhere. */
  bool is_flat() const {
    return !circle_ && !chain_;
  }
  /** Returns whether this is a whole circle, or a chain that returns to its start: s and s +
   * length() are the same point. */
  bool is_closed() const;

  /** Returns the radius of an arc; 0 for segments and chains. */
  double radius() const {
    return circle_ ? circle_->radius : 0.;
  }
  /** Returns the centre of the circle of an arc. */
  const Point<2> &centre_of_circle() const {
    return circle_->centre;
  }

  /** Returns the number of pieces, 1 unless this is a chain. */
  unsigned int n_pieces() const;
  /** Returns piece k, which is the curve itself unless this is a chain. */
  const Curve &piece(unsigned int k) const;
  /** Returns s where a piece begins; for k = n_pieces() the length. */
  double start_of(unsigned int k) const;
  /** Returns s of the corners, sorted: inside of a chain, and at 0 if it is closed with a corner
   * there. */
  const std::vector<double> &corners() const;
  /** Returns whether there is a corner at s, but for rounding. */
  bool has_corner(double s) const;
  /** Returns the numbers of the pieces that are not farther than @p distance from a point. */
  std::vector<unsigned int> pieces_near(const Point<2> &x, double distance) const;
  /** Returns the centre of the circle on which the piece at a point lies; none on a segment. */
  std::optional<Point<2>> centre_at(const Point<2> &x) const;
  /** Returns the segment or the shorter arc of the curve between two of its points, with the body
   * on its left or right. */
  Curve between(const Point<2> &start, const Point<2> &end) const {
    return between(start, end, centre_at(start + 0.5 * (end - start)));
  }
  /** Returns the box around the curve. */
  BoundingBox<2> box() const;

  /** Returns x(s); segments and circles go on beyond their ends, and so do the outer pieces of a
   * chain. */
  Point<2> point(double s) const;
  /** Returns n(s), the outward unit normal; where pieces of a chain meet, that of the piece behind.
   */
  Tensor<1, 2> normal(double s) const;
  /** Returns n(s) on the piece that lies in the direction of @p towards; these two are different
   * points. */
  Tensor<1, 2> normal(double s, double towards) const;
  /** Returns n at a point @p x of the curve, on the piece to which @p inside belongs. */
  Tensor<1, 2> normal_at(const Point<2> &x, const Point<2> &inside) const;
  /** Returns x'(s), on the piece that lies in the direction of @p towards. */
  Tensor<1, 2> tangent(double s, double towards) const;
  /** Returns x(s) for s as a point of the real line. */
  Point<2> point(const Point<1> &s) const {
    return point(s[0]);
  }
  Tensor<1, 2> normal(const Point<1> &s) const {
    return normal(s[0]);
  }
  Point<1> coordinates(const Point<2> &x) const {
    return Point<1>(arc_length(x));
  }
  /** Returns the point of the curve with the arc length of @p x. */
  Point<2> project(const Point<2> &x) const {
    return point(arc_length(x));
  }
  /** Returns n at project(x). */
  Tensor<1, 2> normal_at(const Point<2> &x) const {
    return normal(arc_length(x));
  }
  Point<2> centre() const {
    return point(0.5 * length_);
  }
  /** Returns s of a point on the curve; on a closed one from 0 (included) to its length. */
  double arc_length(const Point<2> &x) const;

  /** Returns the smallest distance, by its size, at which the line through @p x along the unit
   * vector @p n meets the curve; negative behind x. Segments and circles go on beyond their ends.
   * None where it does not meet it. */
  std::optional<double> distance_along(const Point<2> &x, const Tensor<1, 2> &n) const;
  /** Returns the point at that distance; x where the line misses the curve. */
  Point<2> across(const Point<2> &x, const Tensor<1, 2> &n) const {
    return x + distance_along(x, n).value_or(0.) * n;
  }

  /** Returns all s in [from, to], sorted, at which the curve, continued beyond its ends, meets the
   * line m.x = position with the unit normal @p m; none for a line along a segment. */
  std::vector<double> crossings(const Tensor<1, 2> &m, double position, double from,
                                double to) const;

private:
  struct Circle {
    Point<2> centre;
    double radius;
    /** The angle at s = 0. */
    double first;
    /** 1 if the body lies inside, -1 outside. */
    double orientation;
    /** 1 if the angle grows with s, -1 if it falls. */
    double turn;

    /** Returns the unit vector from the centre to the point at s. */
    Tensor<1, 2> direction(double s) const;
  };
  struct Chain;
  /** A piece and an arc length on it. */
  struct Location {
    const Curve &piece;
    double s;
  };

  /** Returns the location of s; between two pieces on the one behind. */
  Location locate(double s) const;
  /** Returns the location of s; between two pieces on the one in the direction of @p towards. */
  Location locate(double s, double towards) const;

  Point<2> start_;
  Point<2> end_;
  double length_;
  /** The normal of a segment; of other curves the one at s = 0. */
  Tensor<1, 2> normal_;
  std::optional<Circle> circle_;
  std::shared_ptr<const Chain> chain_;
};

} // namespace Signorini
