// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/problem/geometry/curve.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <array>
#include <string>
#include <type_traits>
#include <utility>

namespace Signorini {
/**
 * A plane rectangle on the boundary of a 3-D body. Its coordinates are the distances from a corner
 * along the two edges that begin there.
 */
class Rectangle {
public:
  /** @param first, second the edges from @p corner, at right angles. @param normal the outward unit
   * normal. */
  Rectangle(const Point<3> &corner, const Tensor<1, 3> &first, const Tensor<1, 3> &second,
            const Tensor<1, 3> &normal)
    : corner_(corner)
    , edges_{first, second}
    , normal_(normal) {}

  bool is_flat() const {
    return true;
  }
  /** Returns x(s), also beyond the edges. */
  Point<3> point(const Point<2> &s) const {
    return corner_ + s[0] * edges_[0] / edges_[0].norm() + s[1] * edges_[1] / edges_[1].norm();
  }
  Tensor<1, 3> normal(const Point<2> & /*s*/) const {
    return normal_;
  }
  Point<2> coordinates(const Point<3> &x) const {
    return {(x - corner_) * edges_[0] / edges_[0].norm(),
            (x - corner_) * edges_[1] / edges_[1].norm()};
  }
  /** Returns the lengths of the edges. */
  std::array<double, 2> lengths() const {
    return {{edges_[0].norm(), edges_[1].norm()}};
  }
  Point<3> centre() const {
    return corner_ + 0.5 * (edges_[0] + edges_[1]);
  }

private:
  Point<3> corner_;
  std::array<Tensor<1, 3>, 2> edges_;
  Tensor<1, 3> normal_;
};

/** A smooth piece of the boundary with coordinates of its own: point(s), normal(s), coordinates(x).
 */
template <int dim>
using SideManifold = std::conditional_t<dim == 2, Curve, Rectangle>;

/** A named piece of the boundary: a name and the manifold that the piece is. */
template <int dim>
class Side : public SideManifold<dim> {
public:
  Side(std::string name, SideManifold<dim> manifold)
    : SideManifold<dim>(std::move(manifold))
    , name_(std::move(name)) {}

  const std::string &name() const {
    return name_;
  }

private:
  std::string name_;
};

} // namespace Signorini
