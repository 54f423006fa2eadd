// SPDX-License-Identifier: LGPL-2.1-or-later
// Stresses in equilibrium on one quadrilateral.

#include <signorini/error_control/loads/composite_cell.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
namespace
{
using Vector2 = Tensor<1, 2>;

/** Returns the outward normal of an edge with the direction d, counter-clockwise, times its length.
 */
Vector2 scaled_normal(const Vector2 &d)
{
  Vector2 normal;
  normal[0] = d[1];
  normal[1] = -d[0];
  return normal;
}

/**
 * The stresses on the quadrilateral (1,0), (0,1), (-p,0), (0,-q), whose diagonals are the axes,
 * without a system of equations:
 *
 * 1. Corner k lies on axis α = k mod 2; β is the other one. The tractions at both sides of
 * the corner are known. τ_ab and τ_bb there are the same on the two triangles, as tractions
 * across the axis are continuous: the β-components of both tractions determine them, the
 * α-components then τ_aa on either triangle.
 * 2. At the crossing τ_12 is the same on all triangles, and τ_bb on the two triangles at
 * half-axis j with the direction α. The difference of their two equations (div τ)_b + d_b = 0
 * determines τ_bb, any one of them τ_12: the mean of four such values is taken, which are equal
 * if moments and loads are in balance.
 */
class ReferenceStress
{
public:
  using Sides = std::array<double, CompositeCell::n_moments + CompositeCell::n_loads>;

  ReferenceStress(const double p, const double q)
    : at_({{1., 1., -p, -q}})
  {
    std::array<Vector2, 4> corners;
    for (unsigned int k = 0; k < 4; ++k)
      corners[k][k % 2] = at_[k];
    for (unsigned int k = 0; k < 4; ++k)
      normals_[k] = scaled_normal(corners[(k + 1) % 4] - corners[k]);
  }
  /** Returns the stress for the given data, moments first, then loads. */
  CompositeCell::Stresses operator()(const Sides &sides) const
  {
    // Stress (11, 22, 12) on triangle k at its corners k and k + 1 and at the crossing.
    std::array<std::array<Components, 3>, 4> values;
    for (unsigned int k = 0; k < 4; ++k)
      solve_corner(k, sides, values[(k + 3) % 4][1], values[k][0]);
    double shear = 0.;
    for (unsigned int j = 0; j < 4; ++j)
      shear += 0.25 * solve_half_axis(j, sides, values[(j + 3) % 4], values[j]);
    CompositeCell::Stresses result;
    for (unsigned int k = 0; k < 4; ++k)
    {
      values[k][2][2] = shear;
      for (unsigned int m = 0; m < 3; ++m)
        for (unsigned int i = 0; i < 3; ++i)
          result[9 * k + 3 * m + i] = 0.5 * (values[k][(m + 1) % 3][i] + values[k][(m + 2) % 3][i]);
    }
    return result;
  }

private:
  /** Returns the traction times the length of edge k at its first or second end. */
  static Vector2 traction(const Sides &sides, const unsigned int k, const unsigned int end)
  {
    Vector2 t;
    for (unsigned int c = 0; c < 2; ++c)
      t[c] = 4. * sides[4 * k + 2 * end + c] - 2. * sides[4 * k + 2 * (1 - end) + c];
    return t;
  }
  /** Does step 1 for corner k, on the triangles before and after it. */
  void solve_corner(const unsigned int k,
                    const Sides &sides,
                    Components &before,
                    Components &after) const
  {
    const unsigned int a = k % 2, b = 1 - a;
    const Vector2 &mu = normals_[(k + 3) % 4], &nu = normals_[k];
    const Vector2 s = traction(sides, (k + 3) % 4, 1), t = traction(sides, k, 0);
    const double determinant = nu[a] * mu[b] - nu[b] * mu[a];
    before[2] = after[2] = (t[b] * mu[b] - nu[b] * s[b]) / determinant;
    before[b] = after[b] = (nu[a] * s[b] - mu[a] * t[b]) / determinant;
    before[a] = (s[a] - before[2] * mu[b]) / mu[a];
    after[a] = (t[a] - after[2] * nu[b]) / nu[a];
  }
  /**
   * Does step 2 for half-axis j, on the triangles before and after it.
   * @return τ_12 at the crossing.
   */
  double solve_half_axis(const unsigned int j,
                         const Sides &sides,
                         std::array<Components, 3> &before,
                         std::array<Components, 3> &after) const
  {
    const unsigned int b = 1 - j % 2, k = (j + 3) % 4;
    const double to_before = 1. / at_[k], to_after = 1. / at_[(j + 1) % 4];
    const double d_before = sides[CompositeCell::n_moments + 2 * k + b];
    const double d_after = sides[CompositeCell::n_moments + 2 * j + b];
    const double normal = (to_after * after[1][b] - to_before * before[0][b] + d_after - d_before) /
                          (to_after - to_before);
    before[2][b] = after[2][b] = normal;
    return after[0][2] + at_[j] * (to_after * (after[1][b] - normal) + d_after);
  }

  /** The positions of the corners on their axes. */
  std::array<double, 4> at_;
  std::array<Vector2, 4> normals_;
};

/** Returns F s Fᵀ for F = (a1, a2). */
Components push_forward(const Components &s, const Vector2 &a1, const Vector2 &a2)
{
  Components result;
  result[0] = a1[0] * a1[0] * s[0] + a2[0] * a2[0] * s[1] + 2. * a1[0] * a2[0] * s[2];
  result[1] = a1[1] * a1[1] * s[0] + a2[1] * a2[1] * s[1] + 2. * a1[1] * a2[1] * s[2];
  result[2] = a1[0] * a1[1] * s[0] + a2[0] * a2[1] * s[1] + (a1[0] * a2[1] + a1[1] * a2[0]) * s[2];
  return result;
}
} // namespace

CellShape::CellShape(const std::array<Point<2>, 4> &corners)
  : corners(corners)
{
  const Vector2 first = corners[2] - corners[0], second = corners[3] - corners[1];
  const double t = cross(corners[1] - corners[0], second) / cross(first, second);
  const double s = cross(corners[1] - corners[0], first) / cross(first, second);
  crossing = corners[0] + t * first;
  p = (1. - t) / t;
  q = (1. - s) / s;
  for (unsigned int k = 0; k < 4; ++k)
    areas[k] = 0.5 * cross(corners[k] - crossing, corners[(k + 1) % 4] - crossing);
  const Vector2 difference = (corners[0] - corners[1]) + (corners[2] - corners[3]);
  affine = difference.norm() < 1e-12 * first.norm();
}

CellShape::CellShape(const EdgeCell &cell)
  : CellShape(cell.corners)
{
  bulges = cell.bulges;
  is_curved = cell.is_curved;
}

double CellShape::diameter() const
{
  double largest = 0.;
  for (const auto &a : corners)
    for (const auto &b : corners)
      largest = std::max(largest, a.distance(b));
  return largest;
}

Point<2> CellShape::centre(const unsigned int k) const
{
  return crossing + ((corners[k] - crossing) + (corners[(k + 1) % 4] - crossing)) / 3.;
}

Point<2> CellShape::centre() const
{
  Tensor<1, 2> sum;
  for (unsigned int k = 0; k < 4; ++k)
    sum += areas[k] / area() * (centre(k) - crossing);
  return crossing + sum;
}

CompositeCell::CompositeCell(const CellShape &shape)
{
  const ReferenceStress reference(shape.affine ? 1. : shape.p, shape.affine ? 1. : shape.q);
  std::array<Stresses, n_moments + n_loads> unit_columns;
  for (unsigned int j = 0; j < unit_columns.size(); ++j)
  {
    ReferenceStress::Sides side{};
    side[j] = 1.;
    unit_columns[j] = reference(side);
  }
  const Vector2 a1 = shape.corners[0] - shape.crossing, a2 = shape.corners[1] - shape.crossing;
  const double J = cross(a1, a2);
  // Pairs of columns belong to vectors: b' = F⁻¹ b / det F and d' = F⁻¹ d.
  for (unsigned int j = 0; j < n_moments + n_loads; j += 2)
  {
    const double scale = j < n_moments ? 1. / (J * J) : 1. / J;
    const std::array<Vector2, 2> inverse = {
      {scale * Vector2({a2[1], -a1[1]}), scale * Vector2({-a2[0], a1[0]})}};
    for (unsigned int c = 0; c < 2; ++c)
      for (unsigned int i = 0; i < n_stresses; i += 3)
      {
        Components s;
        for (unsigned int l = 0; l < 3; ++l)
          s[l] =
            inverse[c][0] * unit_columns[j][i + l] + inverse[c][1] * unit_columns[j + 1][i + l];
        s = push_forward(s, a1, a2);
        std::copy(s.begin(), s.end(), columns_[j + c].begin() + i);
      }
  }
}

CompositeCell::Stresses CompositeCell::stress(const CellMoments &moments) const
{
  Stresses result{};
  for (unsigned int j = 0; j < n_moments; ++j)
    for (unsigned int i = 0; i < n_stresses; ++i)
      result[i] += columns_[j][i] * moments[j];
  return result;
}

CompositeCell::Stresses CompositeCell::stress(const CellMoments &moments, const Loads &loads) const
{
  Stresses result = stress(moments);
  for (unsigned int j = 0; j < n_loads; ++j)
    for (unsigned int i = 0; i < n_stresses; ++i)
      result[i] += columns_[n_moments + j][i] * loads[j];
  return result;
}

CellMoments CompositeCell::transposed(const Stresses &values) const
{
  CellMoments result{};
  for (unsigned int i = 0; i < n_stresses; ++i)
    for (unsigned int j = 0; j < n_moments; ++j)
      result[j] += columns_[j][i] * values[i];
  return result;
}
} // namespace Signorini
