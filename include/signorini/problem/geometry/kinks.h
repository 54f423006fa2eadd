// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/problem/geometry/box_tree.h>
#include <signorini/problem/geometry/side.h>

#include <deal.II/base/point.h>

#include <array>
#include <memory>
#include <vector>

namespace Signorini {
/** Returns the lines x_d = positions[d][k] for all d and k. */
template <int dim>
std::vector<KinkLine<dim>> lines_at(const std::array<std::vector<double>, dim> &positions);

/**
 * Where data is not smooth: the lines on which it has kinks or jumps, the points where they meet
 * contact sides, and where it varies too fast for the plain rules: breaks on sides and boxes in the
 * body. Contact may end where a line meets a contact side, and derivatives of the solution may be
 * unbounded there.
 */
template <int dim>
class Kinks {
public:
  /** The share of an edge within which a line touches an end and cuts nothing. */
  static constexpr double tolerance = 1e-10;
  /** The smallest distance of two lines, as a share of the body, that meshes and rules are graded
   * to. Closer ones cut off slivers, each of which would be graded. */
  static constexpr double min_distance = 1e-3;

  /**
   * @param breaks points of sides between which a few points show their data.
   * @param boxes the same in the body.
   */
  Kinks(std::vector<KinkLine<dim>> lines = {}, std::vector<Point<dim>> breaks = {},
        BoxTree boxes = {});

  /** Finds the points where the lines meet a contact side. */
  void add_ends_on(const Side<dim> &contact_side);

  /** Returns the same lines without their ends. Meshes that are graded to the ends of contact need
   * no quadrature rules that are graded there. */
  Kinks without_ends() const;
  /** Returns the same with more lines. */
  Kinks with_lines(const std::vector<KinkLine<dim>> &more) const;

  const std::vector<KinkLine<dim>> &lines() const {
    return lines_;
  }
  /** Returns the possible ends of contact zones. */
  const std::vector<Point<dim>> &ends() const {
    return ends_;
  }
  const BoxTree &boxes() const {
    return *boxes_;
  }

  /** Returns whether there are breaks inside of the segment between two points of a side. */
  bool has_breaks(const Point<dim> &a, const Point<dim> &b) const {
    return !breaks_on(a, b).empty();
  }

  /**
   * Returns the parameters t in [0,1], sorted, at which the segment from @p a to @p b is cut: 0,
   * the crossings and breaks, 1.
   */
  std::vector<double> cut(const Point<dim> &a, const Point<dim> &b) const;

  /**
   * Returns the arc lengths, sorted, at which the part [from, to] of a side (or of its
   * continuation) is cut: from, the crossings and breaks, to.
   */
  std::vector<double> cut(const Side<dim> &side, double from, double to) const;

  /** Returns the same without breaks. */
  std::vector<double> crossings(const Side<dim> &side, double from, double to) const;

  /** Returns the crossings inside of a side that are not too close to each other. */
  std::vector<double> separate_crossings(const Side<dim> &side) const;

  /** Returns whether a line passes through an end of the part [from, to] of a side. */
  bool touch(const Side<dim> &side, double from, double to) const;

private:
  /** Returns the parameters of the breaks inside of a segment. */
  std::vector<double> breaks_on(const Point<dim> &a, const Point<dim> &b) const;

  std::vector<KinkLine<dim>> lines_;
  std::vector<Point<dim>> ends_, breaks_;
  std::shared_ptr<const BoxTree> boxes_;
};
} // namespace Signorini
