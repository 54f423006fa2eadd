// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>

#include <deal.II/base/table.h>
#include <deal.II/grid/manifold_lib.h>

#include <cmath>
#include <memory>

namespace Signorini {
/** A circle, on which points between two others have their share of the angle, rounded like points.
 * deal.II's takes the angle by acos: on arcs of 1e-7 of the radius such points are off by a
 * hundredth, and differ by the direction in which an edge runs. */
class CircleManifold : public SphericalManifold<2> {
public:
  using SphericalManifold<2>::SphericalManifold;

  std::unique_ptr<Manifold<2>> clone() const override {
    return std::make_unique<CircleManifold>(center);
  }
  Point<2> get_intermediate_point(const Point<2> &a, const Point<2> &b,
                                  const double share) const override {
    const Tensor<1, 2> from = a - center, to = b - center, left = -1. * cross_product_2d(from);
    const double angle = share * std::atan2(left * (b - a), from * to);
    return center + std::cos(angle) * from + std::sin(angle) * left;
  }
  Point<2> get_new_point(const ArrayView<const Point<2>> &points,
                         const ArrayView<const double> &weights) const override {
    return points.size() == 2 ? get_intermediate_point(points[0], points[1], weights[1])
                              : SphericalManifold<2>::get_new_point(points, weights);
  }
  void get_new_points(const ArrayView<const Point<2>> &points, const Table<2, double> &weights,
                      ArrayView<Point<2>> found) const override {
    if (points.size() != 2)
      SphericalManifold<2>::get_new_points(points, weights, found);
    else
      for (unsigned int i = 0; i < weights.size(0); ++i)
        found[i] = get_intermediate_point(points[0], points[1], weights(i, 1));
  }
};
} // namespace Signorini
