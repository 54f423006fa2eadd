// SPDX-License-Identifier: LGPL-2.1-or-later
// Transfinite interpolation in a cell with circular edges.

#include <signorini/base/errors.h>
#include <signorini/problem/geometry/arc_cell.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Signorini
{
dealii::Point<2> ArcCell::Edge::point(const double t) const
{
  if (!centre)
    return start + t * (end - start);
  const double radius = centre->distance(start), at = angle + t * turn;
  return *centre + radius * dealii::Tensor<1, 2>({std::cos(at), std::sin(at)});
}

dealii::Tensor<1, 2> ArcCell::Edge::derivative(const double t) const
{
  if (!centre)
    return end - start;
  const double speed = centre->distance(start) * turn, at = angle + t * turn;
  return speed * dealii::Tensor<1, 2>({-std::sin(at), std::cos(at)});
}

ArcCell::ArcCell(const std::array<dealii::Point<2>, 4> &corners,
                 const std::array<std::optional<dealii::Point<2>>, 4> &centres)
{
  for (unsigned int i = 0; i < 4; ++i)
  {
    Edge &edge = edges_[i];
    edge.start = corners[i];
    edge.end = corners[(i + 1) % 4];
    edge.centre = centres[i];
    if (!edge.centre)
      continue;
    const dealii::Tensor<1, 2> a = edge.start - *edge.centre, b = edge.end - *edge.centre;
    edge.angle = std::atan2(a[1], a[0]);
    edge.turn = std::atan2(a[0] * b[1] - a[1] * b[0], a * b);
  }
}

std::unique_ptr<dealii::Manifold<2, 2>> ArcCell::clone() const
{
  return std::make_unique<ArcCell>(*this);
}

dealii::Point<2> ArcCell::push_forward(const dealii::Point<2> &chart_point) const
{
  const double a = chart_point[0], b = chart_point[1];
  dealii::Tensor<1, 2> x;
  x += (1. - b) * edges_[0].point(a) + b * edges_[2].point(1. - a);
  x += a * edges_[1].point(b) + (1. - a) * edges_[3].point(1. - b);
  x -= (1. - a) * (1. - b) * edges_[0].start + a * (1. - b) * edges_[1].start;
  x -= a * b * edges_[2].start + (1. - a) * b * edges_[3].start;
  return dealii::Point<2>(x);
}

dealii::DerivativeForm<1, 2, 2>
ArcCell::push_forward_gradient(const dealii::Point<2> &chart_point) const
{
  const double a = chart_point[0], b = chart_point[1];
  const dealii::Tensor<1, 2> bottom = edges_[1].start - edges_[0].start,
                             top = edges_[2].start - edges_[3].start,
                             left = edges_[3].start - edges_[0].start,
                             right = edges_[2].start - edges_[1].start;
  const dealii::Tensor<1, 2> along_a = (1. - b) * (edges_[0].derivative(a) - bottom) -
                                       b * (edges_[2].derivative(1. - a) + top) +
                                       (edges_[1].point(b) - edges_[3].point(1. - b));
  const dealii::Tensor<1, 2> along_b = a * (edges_[1].derivative(b) - right) -
                                       (1. - a) * (edges_[3].derivative(1. - b) + left) +
                                       (edges_[2].point(1. - a) - edges_[0].point(a));
  dealii::DerivativeForm<1, 2, 2> gradient;
  for (unsigned int d = 0; d < 2; ++d)
  {
    gradient[d][0] = along_a[d];
    gradient[d][1] = along_b[d];
  }
  return gradient;
}

dealii::Point<2> ArcCell::pull_back(const dealii::Point<2> &x) const
{
  constexpr unsigned int most_steps = 50;
  const double size = edges_[0].start.distance(edges_[2].start);
  const double rounding = 1e-15 * (size + x.norm());
  dealii::Point<2> chart_point(0.5, 0.5);
  double distance = HUGE_VAL;
  for (unsigned int step = 0; step < most_steps; ++step)
  {
    const dealii::Tensor<1, 2> residual = x - push_forward(chart_point);
    // Newton's method continues until rounding ends it.
    if (residual.norm() < rounding ||
        (residual.norm() < 1e-12 * size && residual.norm() >= distance))
      return chart_point;
    distance = residual.norm();
    const dealii::Tensor<2, 2> gradient(push_forward_gradient(chart_point));
    chart_point += invert(gradient) * residual;
    for (unsigned int d = 0; d < 2; ++d)
      chart_point[d] = std::min(std::max(chart_point[d], -0.5), 1.5);
  }
  std::ostringstream text;
  text
    << "Geometry: the point (" << x << ") is not found in the coarse cell from (" << edges_[0].start
    << ") to (" << edges_[2].start
    << "), an edge of which lies on a circle, allowed: a finer mesh there (Mesh size, or another "
       "File).";
  throw ComputationError(text.str());
}

bool ArcCell::is_valid(const unsigned int n, const double smallest_ratio) const
{
  double lowest = HUGE_VAL, highest = 0.;
  for (unsigned int i = 0; i <= n; ++i)
    for (unsigned int j = 0; j <= n; ++j)
    {
      const double determinant =
        push_forward_gradient(dealii::Point<2>(double(i) / n, double(j) / n)).determinant();
      lowest = std::min(lowest, determinant);
      highest = std::max(highest, determinant);
    }
  return lowest > smallest_ratio * highest;
}
} // namespace Signorini
