// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/problem/geometry/curve.h>

#include <deal.II/base/point.h>
#include <deal.II/grid/manifold.h>

#include <array>
#include <memory>
#include <optional>

namespace Signorini {
/**
 * A quadrilateral with edges that are straight or circular arcs, as a chart over the unit square.
 * Inside it is Gordon's transfinite interpolation of its edges (Gordon and Hall, Numerische
 * Mathematik 21, 1973): S(a, b) = (1-b) e_0(a) + b e_1(a) + (1-a) e_2(b) + a e_3(b) minus the
 * bilinear map of the corners. deal.II's TransfiniteInterpolationManifold looks through all coarse
 * cells for every point, which takes too long on meshes of many cells.
 */
class ArcCell : public ChartManifold<2, 2, 2> {
public:
  /** Stores corners counter-clockwise; edge i leads from corner i to the next one. @param centres
   * of the circles of edges that are arcs. */
  ArcCell(const std::array<Point<2>, 4> &corners,
          const std::array<std::optional<Point<2>>, 4> &centres);

  std::unique_ptr<Manifold<2, 2>> clone() const override;
  /** Returns the chart point of x. @throws ComputationError if Newton's method does not find it. */
  Point<2> pull_back(const Point<2> &x) const override;
  Point<2> push_forward(const Point<2> &chart_point) const override;
  DerivativeForm<1, 2, 2> push_forward_gradient(const Point<2> &chart_point) const override;

  /** Returns whether at 9 x 9 points the determinant of the map is positive, and larger than
   * @p min_ratio times the largest one. */
  bool is_valid(double min_ratio) const;

private:
  /** The edges from corner 0 to 1, 3 to 2, 0 to 3 and 1 to 2: b = 0, b = 1, a = 0, a = 1. */
  std::array<Curve, 4> edges_;
};
} // namespace Signorini
