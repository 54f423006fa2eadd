// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/grid/manifold.h>

#include <array>
#include <memory>
#include <optional>

namespace Signorini
{
/**
 * A quadrilateral with edges that are straight or circular arcs, as a chart over the unit square.
 * Inside it is Gordon's transfinite interpolation of its edges (Gordon and Hall, Numerische
 * Mathematik 21, 1973): S(a, b) = (1-b) e_0(a) + b e_2(1-a) + a e_1(b) + (1-a) e_3(1-b) minus the
 * bilinear map of the corners. deal.II's TransfiniteInterpolationManifold looks through all coarse
 * cells for every point, which takes too long on meshes of many cells.
 */
class ArcCell : public dealii::ChartManifold<2, 2, 2>
{
public:
  /** Stores corners counter-clockwise; edge i leads from corner i to the next one. @param centres
   * of the circles of edges that are arcs. */
  ArcCell(const std::array<dealii::Point<2>, 4> &corners,
          const std::array<std::optional<dealii::Point<2>>, 4> &centres);

  std::unique_ptr<dealii::Manifold<2, 2>> clone() const override;
  /** Returns the chart point of x. @throws ComputationError if Newton's method does not find it. */
  dealii::Point<2> pull_back(const dealii::Point<2> &x) const override;
  dealii::Point<2> push_forward(const dealii::Point<2> &chart_point) const override;
  dealii::DerivativeForm<1, 2, 2>
  push_forward_gradient(const dealii::Point<2> &chart_point) const override;

  /** Returns whether at (n + 1) x (n + 1) points the determinant of the map is positive, and larger
   * than @p smallest_ratio times the largest one. */
  bool is_valid(unsigned int n, double smallest_ratio) const;

private:
  struct Edge
  {
    dealii::Point<2> start, end;
    /** The centre of an arc, the angle of its start and how far it turns (radians); empty for a
     * straight edge. */
    std::optional<dealii::Point<2>> centre;
    double angle = 0., turn = 0.;

    dealii::Point<2> point(double t) const;
    dealii::Tensor<1, 2> derivative(double t) const;
  };

  std::array<Edge, 4> edges_;
};
} // namespace Signorini
