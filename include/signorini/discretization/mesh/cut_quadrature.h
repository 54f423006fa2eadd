// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/problem/geometry/kinks.h>

#include <deal.II/base/quadrature.h>
#include <deal.II/fe/mapping_q1.h>
#include <deal.II/grid/tria.h>

#include <array>
#include <vector>

namespace Signorini {
using Polygon = std::vector<Point<2>>;

/** A part of a convex polygon. */
struct PolygonPart {
  Polygon corners;
  /** How often boxes halved it, in both directions together; none if one direction is not halved.
   */
  unsigned int halvings;
  /** Whether data in its box varies faster than a few points show. */
  bool is_rough;
};

/** Returns the parts into which lines and boxes cut a convex polygon. */
std::vector<PolygonPart> cut_polygon(const Kinks<2> &kinks, const Polygon &polygon);

/** Returns whether a line crosses a cell. */
template <int dim>
bool crosses(const KinkLine<dim> &line, const typename Triangulation<dim>::cell_iterator &cell);

/** Returns whether the plain rule is not enough on a cell: a line crosses it or meets a contact
 * side near it, or data varies too fast in it. */
template <int dim>
bool needs_cuts(const Kinks<dim> &kinks, const typename Triangulation<dim>::cell_iterator &cell);

/** Returns whether data varies faster on a cell than a plain rule shows: a line crosses it, or its
 * boxes are smaller than the cell. */
bool varies_fast(const Kinks<2> &kinks, const Triangulation<2>::cell_iterator &cell);

/** Returns whether data may jump in a cell: a line crosses it, or it meets one of the smallest
 * boxes in which data still varies faster than a few points show. */
bool may_jump(const Kinks<2> &kinks, const Triangulation<2>::cell_iterator &cell);

/** Points of the body with weights. */
struct PlaneRule {
  std::vector<Point<2>> points;
  std::vector<double> weights;
};

/** Returns the rule of cut_quadrature() on a cell with straight edges itself.
 * @param corners counter-clockwise. */
PlaneRule cut_rule(const Kinks<2> &kinks, const std::array<Point<2>, 4> &corners,
                   unsigned int n_points);

/**
 * Returns a rule on the reference cell that integrates on the pieces into which lines and boxes
 * cut a cell: Gauss' rule on rectangles, Duffy's on the triangles of other pieces, each with
 * @p n_points points per direction. Near a possible end of contact all pieces are triangles, which
 * shrink towards it. A curved cell is cut like the quadrilateral of its vertices; where this moves
 * points by more than a tenth of the size of a piece, its quarters are, and so on. Where data does
 * not jump, its smooth_parts() have Gauss' rule.
 * @param mapping the map of the cell, in any unit of length.
 */
Quadrature<2> cut_quadrature(const Kinks<2> &kinks, const Triangulation<2>::cell_iterator &cell,
                             unsigned int n_points,
                             const Mapping<2> &mapping = StaticMappingQ1<2>::mapping);

/** Returns the parameters t in [0,1], sorted, at which lines and breaks cut the edge of a cell from
 * @p a to @p b on a side: 0, the cuts, 1. On an arc the edge is a parabola. */
std::vector<double> cut_edge(const Kinks<2> &kinks, const Side<2> &side, const Point<2> &a,
                             const Point<2> &b);

/** Returns the rule from the first to the last of the sorted @p cuts that applies @p rule, a rule
 * on [0,1], between consecutive ones. */
Quadrature<1> split_quadrature(const Quadrature<1> &rule, const std::vector<double> &cuts);

/** The number of divisions of the distance from a singular point by four: down to 4e-9 of the
 * first. */
constexpr unsigned int n_graded_layers = 14;

/** Returns the positions s + distance 4^-k, k = 0, ..., n_graded_layers - 1; @p distance may be
 * negative. Between them a function like |x - s|^{1/2} is smooth. */
std::vector<double> graded_positions(double s, double distance);
} // namespace Signorini
