// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <array>

namespace Signorini
{
/**
 * A plane rectangle on the boundary of a body in space. Its coordinates are the distances from a
 * corner along the two edges that begin there.
 */
class Rectangle
{
public:
  /** @param first, second the edges from @p corner, at right angles. @param normal the outward unit
   * normal. */
  Rectangle(const dealii::Point<3> &corner,
            const dealii::Tensor<1, 3> &first,
            const dealii::Tensor<1, 3> &second,
            const dealii::Tensor<1, 3> &normal)
    : corner_(corner)
    , edges_{first, second}
    , normal_(normal)
  {
  }

  bool is_flat() const
  {
    return true;
  }
  /** x(s): the plane goes on beyond the edges. */
  dealii::Point<3> point(const dealii::Point<2> &s) const
  {
    return corner_ + s[0] * edges_[0] / edges_[0].norm() + s[1] * edges_[1] / edges_[1].norm();
  }
  dealii::Tensor<1, 3> normal(const dealii::Point<2> & /*s*/) const
  {
    return normal_;
  }
  dealii::Point<2> coordinates(const dealii::Point<3> &x) const
  {
    return {(x - corner_) * edges_[0] / edges_[0].norm(),
            (x - corner_) * edges_[1] / edges_[1].norm()};
  }
  /** Of the edges (length). */
  std::array<double, 2> lengths() const
  {
    return {{edges_[0].norm(), edges_[1].norm()}};
  }
  dealii::Point<3> centre() const
  {
    return corner_ + 0.5 * (edges_[0] + edges_[1]);
  }

private:
  dealii::Point<3> corner_;
  std::array<dealii::Tensor<1, 3>, 2> edges_;
  dealii::Tensor<1, 3> normal_;
};
} // namespace Signorini
