// SPDX-License-Identifier: LGPL-2.1-or-later
// Transfinite interpolation in a cell with circular edges.

#include <signorini/base/errors.h>
#include <signorini/base/message.h>
#include <signorini/problem/geometry/arc_cell.h>

#include <algorithm>
#include <cmath>

namespace Signorini {
namespace {
/** Returns the point of an edge at the share t of its length. */
Point<2> on(const Curve &edge, const double t) {
  return edge.point(t * edge.length());
}

/** Returns d/dt of on(), less that of the chord. */
Tensor<1, 2> bend(const Curve &edge, const double t) {
  return edge.length() * edge.tangent(t * edge.length(), 0.) - (edge.end() - edge.start());
}
} // namespace

ArcCell::ArcCell(const std::array<Point<2>, 4> &x,
                 const std::array<std::optional<Point<2>>, 4> &centres)
  : edges_{{Curve::between(x[0], x[1], centres[0]), Curve::between(x[3], x[2], centres[2]),
            Curve::between(x[0], x[3], centres[3]), Curve::between(x[1], x[2], centres[1])}} {}

std::unique_ptr<Manifold<2, 2>> ArcCell::clone() const {
  return std::make_unique<ArcCell>(*this);
}

Point<2> ArcCell::push_forward(const Point<2> &chart_point) const {
  const double a = chart_point[0], b = chart_point[1];
  const auto &[bottom, top, left, right] = edges_;
  return Point<2>((1. - b) * (on(bottom, a) - (1. - a) * bottom.start() - a * bottom.end()) +
                  b * (on(top, a) - (1. - a) * top.start() - a * top.end()) +
                  (1. - a) * on(left, b) + a * on(right, b));
}

DerivativeForm<1, 2, 2> ArcCell::push_forward_gradient(const Point<2> &chart_point) const {
  const double a = chart_point[0], b = chart_point[1];
  const auto &[bottom, top, left, right] = edges_;
  const Tensor<1, 2> along_a =
    (1. - b) * bend(bottom, a) + b * bend(top, a) + (on(right, b) - on(left, b));
  const Tensor<1, 2> along_b =
    (1. - a) * bend(left, b) + a * bend(right, b) + (on(top, a) - on(bottom, a));
  DerivativeForm<1, 2, 2> gradient;
  for (unsigned int d = 0; d < 2; ++d)
    gradient[d] = Tensor<1, 2>({along_a[d], along_b[d]});
  return gradient;
}

Point<2> ArcCell::pull_back(const Point<2> &x) const {
  constexpr unsigned int max_steps = 50, n = 16;
  const Point<2> &corner = edges_[0].start(), &opposite = edges_[1].end();
  const double size = corner.distance(opposite);
  const double rounding = 1e-15 * (size + x.norm());
  const auto search_from = [&](Point<2> chart_point) -> std::optional<Point<2>> {
    double distance = HUGE_VAL;
    for (unsigned int step = 0; step < max_steps; ++step) {
      const Tensor<1, 2> residual = x - push_forward(chart_point);
      // Newton's method continues until rounding ends it.
      if (residual.norm() < rounding ||
          (residual.norm() < 1e-12 * size && residual.norm() >= distance))
        return chart_point;
      distance = residual.norm();
      const Tensor<2, 2> gradient(push_forward_gradient(chart_point));
      chart_point += invert(gradient) * residual;
      for (unsigned int d = 0; d < 2; ++d)
        chart_point[d] = std::clamp(chart_point[d], -0.5, 1.5);
    }
    return {};
  };
  if (const auto found = search_from(Point<2>(0.5, 0.5)))
    return *found;
  // In thin cells that are bent it has to begin near the point.
  Point<2> nearest;
  for (unsigned int i = 0; i <= n; ++i)
    for (unsigned int j = 0; j <= n; ++j)
      if (const Point<2> start(double(i) / n, double(j) / n);
          push_forward(start).distance(x) < push_forward(nearest).distance(x))
        nearest = start;
  if (const auto found = search_from(nearest))
    return *found;
  throw ComputationError(
    concatenate("Geometry: the point (", x, ") is not found in the coarse cell from (", corner,
                ") to (", opposite,
                "), an edge of which lies on a circle, allowed: a finer mesh there (Mesh size, or "
                "another File)."));
}

bool ArcCell::is_valid(const double min_ratio) const {
  constexpr unsigned int n = 8;
  double lowest = HUGE_VAL, highest = 0.;
  for (unsigned int i = 0; i <= n; ++i)
    for (unsigned int j = 0; j <= n; ++j) {
      const double determinant =
        push_forward_gradient(Point<2>(double(i) / n, double(j) / n)).determinant();
      lowest = std::min(lowest, determinant);
      highest = std::max(highest, determinant);
    }
  return lowest > min_ratio * highest;
}
} // namespace Signorini
