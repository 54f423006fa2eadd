// SPDX-License-Identifier: LGPL-2.1-or-later
// Maps of one quadrilateral.

#include <signorini/error_control/equilibration/cell_shape.h>

#include <algorithm>
#include <cmath>

namespace Signorini {
CellFunctions::CellFunctions(const Point<2> &at) {
  for (unsigned int i = 0; i < 4; ++i) {
    // Corners counter-clockwise.
    const bool right = i == 1 || i == 2, upper = i > 1;
    const double x = right ? at[0] : 1. - at[0], y = upper ? at[1] : 1. - at[1];
    values[i] = x * y;
    gradients[i] = Tensor<1, 2>({right ? y : -y, upper ? x : -x});
  }
}

CellShape shape_of(const Triangulation<2>::cell_iterator &cell, const std::vector<Side<2>> &sides) {
  const ArcCentres by_face = arc_centres(sides, cell);
  return CellShape(corners_of(cell), {{by_face[2], by_face[1], by_face[3], by_face[0]}});
}

CellShape::CellShape(const std::array<Point<2>, 4> &corners, const ArcCentres &centres)
  : corners(corners)
  , centres(centres) {
  const Tensor<1, 2> first = corners[2] - corners[0], second = corners[3] - corners[1];
  crossing = corners[0] + cross(corners[1] - corners[0], second) / cross(first, second) * first;
  for (unsigned int k = 0; k < 4; ++k)
    areas[k] = 0.5 * twice_area(triangle(k));
  const Tensor<1, 2> difference = (corners[0] - corners[1]) + (corners[2] - corners[3]);
  affine = difference.norm() < 1e-12 * first.norm() && !has_arcs();
}

Tensor<2, 2> CellShape::half_diagonals() const {
  const Tensor<1, 2> a = corners[0] - crossing, b = corners[1] - crossing;
  return Tensor<2, 2>({{a[0], b[0]}, {a[1], b[1]}});
}

double CellShape::diameter() const {
  double largest = 0.;
  for (const auto &a : corners)
    for (const auto &b : corners)
      largest = std::max(largest, a.distance(b));
  return largest;
}

Point<2> CellShape::centre() const {
  Tensor<1, 2> sum;
  for (unsigned int k = 0; k < 4; ++k)
    sum += areas[k] / area() * (centre(k) - crossing);
  return crossing + sum;
}

Tensor<1, 2> CellShape::offset(const CellFunctions &functions) const {
  Tensor<1, 2> sum;
  for (unsigned int c = 1; c < 4; ++c)
    sum += functions.values[c] * (corners[c] - corners[0]);
  return sum;
}

Tensor<2, 2> CellShape::jacobian(const CellFunctions &functions) const {
  Tensor<2, 2> sum;
  for (unsigned int c = 1; c < 4; ++c)
    sum += outer_product(corners[c] - corners[0], functions.gradients[c]);
  return sum;
}

Point<2> CellShape::reference(const Tensor<1, 2> &offset) const {
  const Tensor<1, 2> a = corners[1] - corners[0], b = corners[3] - corners[0],
                     g = (corners[2] - corners[1]) - b;
  // The offset s a + t (b + s g) minus t b is parallel to a + t g: a quadratic equation, whose
  // discriminant is the square of the Jacobian's determinant.
  const double A = cross(g, b), B = cross(a, b) + cross(offset, g), C = cross(offset, a);
  const double t = -2. * C / (B + std::sqrt(B * B - 4. * A * C));
  const Tensor<1, 2> d_s = a + t * g;
  return {(offset - t * b) * d_s / d_s.norm_square(), t};
}
} // namespace Signorini
