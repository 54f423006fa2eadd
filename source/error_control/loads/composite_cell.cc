// SPDX-License-Identifier: LGPL-2.1-or-later
// Maps, and stresses in equilibrium, on one quadrilateral.

#include <signorini/error_control/loads/composite_cell.h>

#include <algorithm>
#include <cmath>

namespace Signorini {
CellFunctions::CellFunctions(const Point<2> &at) {
  // The factors along an axis: those of its two ends, and the bubble.
  std::array<std::array<double, 3>, 2> f, slope;
  for (unsigned int d = 0; d < 2; ++d) {
    f[d] = {{1. - at[d], at[d], 4. * at[d] * (1. - at[d])}};
    slope[d] = {{-1., 1., 4. - 8. * at[d]}};
  }
  constexpr std::array<std::array<unsigned int, 2>, n_functions> factors = {
    {{{0, 0}}, {{1, 0}}, {{1, 1}}, {{0, 1}}, {{2, 0}}, {{1, 2}}, {{2, 1}}, {{0, 2}}, {{2, 2}}}};
  for (unsigned int i = 0; i < n_functions; ++i) {
    const auto [a, b] = factors[i];
    values[i] = f[0][a] * f[1][b];
    gradients[i] = Tensor<1, 2>({slope[0][a] * f[1][b], f[0][a] * slope[1][b]});
  }
}

CellShape::CellShape(const std::array<Point<2>, 4> &corners, const Bulges &bulges)
  : corners(corners)
  , bulges(bulges)
  , is_curved(std::any_of(bulges.begin(), bulges.end(),
                          [](const Tensor<1, 2> &bulge) { return bulge.norm_square() > 0.; })) {
  const Tensor<1, 2> first = corners[2] - corners[0], second = corners[3] - corners[1];
  crossing = corners[0] + cross(corners[1] - corners[0], second) / cross(first, second) * first;
  for (unsigned int k = 0; k < 4; ++k)
    areas[k] = 0.5 * twice_area(triangle(k));
  const Tensor<1, 2> difference = (corners[0] - corners[1]) + (corners[2] - corners[3]);
  affine = !is_curved && difference.norm() < 1e-12 * first.norm();
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

Tensor<2, 2> CellShape::half_edges() const {
  const Tensor<1, 2> a = 0.5 * (corners[1] - corners[0]), b = 0.5 * (corners[3] - corners[0]);
  return Tensor<2, 2>({{a[0], b[0]}, {a[1], b[1]}});
}

Tensor<1, 2> CellShape::offset(const CellFunctions &functions, const bool with_bulges) const {
  Tensor<1, 2> sum;
  for (unsigned int c = 1; c < CellFunctions::n_corners; ++c)
    sum += functions.values[c] * (corners[c] - corners[0]);
  for (unsigned int i = 0; i < bulges.size() && with_bulges; ++i)
    sum += functions.values[CellFunctions::n_corners + i] * bulges[i];
  return sum;
}

Tensor<2, 2> CellShape::jacobian(const CellFunctions &functions, const bool with_bulges) const {
  Tensor<2, 2> sum;
  for (unsigned int c = 1; c < CellFunctions::n_corners; ++c)
    sum += outer_product(corners[c] - corners[0], functions.gradients[c]);
  for (unsigned int i = 0; i < bulges.size() && with_bulges; ++i)
    sum += outer_product(bulges[i], functions.gradients[CellFunctions::n_corners + i]);
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

namespace {
/** The position of component @p c of the moment that edge k has at its first or second end. */
constexpr unsigned int moment_at(const unsigned int k, const unsigned int end,
                                 const unsigned int c) {
  return 4 * k + 2 * end + c;
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
 *
 * Distorted meshes have as many shapes as cells: this takes 2 µs, a dense system of the same
 * equations 50 µs.
 */
class ReferenceStress {
public:
  using Data = std::array<double, CompositeCell::n_data>;
  /** The stress (11, 22, 12) on triangle k at its corners k and k + 1 and at the crossing. */
  using Stress = std::array<std::array<Components, 3>, 4>;

  ReferenceStress(const double p, const double q)
    : at_({{1., 1., -p, -q}}) {
    std::array<Tensor<1, 2>, 4> corners;
    for (unsigned int k = 0; k < 4; ++k)
      corners[k][k % 2] = at_[k];
    for (unsigned int k = 0; k < 4; ++k) {
      const Tensor<1, 2> edge = corners[(k + 1) % 4] - corners[k];
      normals_[k] = Tensor<1, 2>({edge[1], -edge[0]});
    }
  }
  Stress operator()(const Data &data) const {
    Stress values;
    for (unsigned int k = 0; k < 4; ++k)
      solve_corner(k, data, values[(k + 3) % 4][1], values[k][0]);
    double shear = 0.;
    for (unsigned int j = 0; j < 4; ++j)
      shear += 0.25 * solve_half_axis(j, data, values[(j + 3) % 4], values[j]);
    for (auto &triangle : values)
      triangle[2][2] = shear;
    return values;
  }

private:
  /** Returns the traction times the length of edge k at its first or second end. */
  static Tensor<1, 2> traction(const Data &data, const unsigned int k, const unsigned int end) {
    Tensor<1, 2> t;
    for (unsigned int c = 0; c < 2; ++c)
      t[c] = 4. * data[moment_at(k, end, c)] - 2. * data[moment_at(k, 1 - end, c)];
    return t;
  }
  /** Does step 1 for corner k, on the triangles before and after it. */
  void solve_corner(const unsigned int k, const Data &data, Components &before,
                    Components &after) const {
    const unsigned int a = k % 2, b = 1 - a;
    const Tensor<1, 2> &mu = normals_[(k + 3) % 4], &nu = normals_[k];
    const Tensor<1, 2> s = traction(data, (k + 3) % 4, 1), t = traction(data, k, 0);
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
  double solve_half_axis(const unsigned int j, const Data &data, std::array<Components, 3> &before,
                         std::array<Components, 3> &after) const {
    const unsigned int b = 1 - j % 2, k = (j + 3) % 4;
    const double to_before = 1. / at_[k], to_after = 1. / at_[(j + 1) % 4];
    const double d_before = data[CompositeCell::n_moments + 2 * k + b];
    const double d_after = data[CompositeCell::n_moments + 2 * j + b];
    const double normal = (to_after * after[1][b] - to_before * before[0][b] + d_after - d_before) /
                          (to_after - to_before);
    before[2][b] = after[2][b] = normal;
    return after[0][2] + at_[j] * (to_after * (after[1][b] - normal) + d_after);
  }

  /** The positions of the corners on their axes. */
  std::array<double, 4> at_;
  /** The outward normals of the edges times their lengths. */
  std::array<Tensor<1, 2>, 4> normals_;
};
} // namespace

CompositeCell::CompositeCell(const CellShape &shape) {
  const auto &x = shape.corners;
  const Tensor<1, 2> a1 = x[0] - shape.crossing, a2 = x[1] - shape.crossing;
  const ReferenceStress reference(x[2].distance(shape.crossing) / a1.norm(),
                                  x[3].distance(shape.crossing) / a2.norm());
  const Tensor<2, 2> F({{a1[0], a2[0]}, {a1[1], a2[1]}}), inverse = invert(F);
  // τ = F τ' Fᵀ by components.
  const Tensor<2, 3> push_forward({{a1[0] * a1[0], a2[0] * a2[0], 2. * a1[0] * a2[0]},
                                   {a1[1] * a1[1], a2[1] * a2[1], 2. * a1[1] * a2[1]},
                                   {a1[0] * a1[1], a2[0] * a2[1], a1[0] * a2[1] + a1[1] * a2[0]}});
  for (unsigned int j = 0; j < n_data; ++j) {
    // b' = F⁻¹ b / det F and d' = F⁻¹ d.
    const double scale = j < n_moments ? 1. / determinant(F) : 1.;
    ReferenceStress::Data data{};
    for (unsigned int c = 0; c < 2; ++c)
      data[j - j % 2 + c] = scale * inverse[c][j % 2];
    const ReferenceStress::Stress values = reference(data);
    for (unsigned int k = 0; k < 4; ++k)
      for (unsigned int m = 0; m < 3; ++m) {
        const Components s = push_forward * values[k][m];
        for (unsigned int c = 0; c < 3; ++c)
          matrix_[9 * k + 3 * m + c][j] = s[c];
      }
  }
}
} // namespace Signorini
