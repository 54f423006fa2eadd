// SPDX-License-Identifier: LGPL-2.1-or-later
// Triangles and quadrilaterals of degree two with exact arcs.

#include <signorini/discretization/space/foreign_field.h>

namespace Signorini {
namespace {
using Derivatives = std::array<double, 2>;

/** The polynomials of degree two at 0, 1/2 and 1, and their derivatives. */
struct ThreeNodes {
  explicit ThreeNodes(const double r)
    : value{{(1. - r) * (1. - 2. * r), 4. * r * (1. - r), r * (2. * r - 1.)}}
    , derivative{{4. * r - 3., 4. - 8. * r, 4. * r - 1.}} {}

  std::array<double, 3> value, derivative;
};

/** The functions that are one at a corner and zero at the others, linear or bilinear. */
struct CornerFunctions {
  CornerFunctions(const bool is_triangle, const double s, const double t)
    : value{{(1. - s) * (1. - t), s * (1. - t), is_triangle ? t : s * t, (1. - s) * t}}
    , derivatives{{{{t - 1., s - 1.}},
                   {{1. - t, -s}},
                   {{is_triangle ? 0. : t, is_triangle ? 1. : s}},
                   {{-t, 1. - s}}}} {}

  std::array<double, 4> value;
  std::array<Derivatives, 4> derivatives;
};

/** The basis polynomials at a point; those that a triangle lacks are zero. */
struct Basis {
  Basis(const bool is_triangle, const double s, const double t) {
    if (is_triangle)
      set(CornerFunctions(true, s, t));
    else
      set(ThreeNodes(s), ThreeNodes(t));
  }

  CellNodes<double> value = {};
  CellNodes<Derivatives> derivatives = {};

private:
  void set(const CornerFunctions &at) {
    for (unsigned int k = 0; k < 3; ++k) {
      const unsigned int next = (k + 1) % 3;
      const double a = at.value[k], b = at.value[next];
      value[k] = a * (2. * a - 1.);
      value[3 + k] = 4. * a * b;
      for (unsigned int d = 0; d < 2; ++d) {
        derivatives[k][d] = (4. * a - 1.) * at.derivatives[k][d];
        derivatives[3 + k][d] = 4. * (a * at.derivatives[next][d] + b * at.derivatives[k][d]);
      }
    }
  }
  void set(const ThreeNodes &s, const ThreeNodes &t) {
    constexpr CellNodes<unsigned int> along_s = {{0, 2, 2, 0, 1, 2, 1, 0, 1}},
                                      along_t = {{0, 0, 2, 2, 0, 1, 2, 1, 1}};
    for (unsigned int i = 0; i < 9; ++i) {
      const unsigned int j = along_s[i], k = along_t[i];
      value[i] = s.value[j] * t.value[k];
      derivatives[i] = {{s.derivative[j] * t.value[k], s.value[j] * t.derivative[k]}};
    }
  }
};
} // namespace

ForeignCell::Values ForeignCell::at(const double s, const double t) const {
  const Basis basis(is_triangle, s, t);
  const CornerFunctions corners(is_triangle, s, t);
  const unsigned int n = n_corners(), n_basis = is_triangle ? 6 : 9;
  Values values;
  values.x = x[0];
  values.v = v[0];
  Tensor<2, 2> derivatives;
  // From differences, so that large translations leave no rounding.
  for (unsigned int i = 1; i < n_basis; ++i) {
    const Tensor<1, 2> dx = x[i] - x[0], dv = v[i] - v[0];
    values.x += basis.value[i] * dx;
    values.v += basis.value[i] * dv;
    for (unsigned int c = 0; c < 2; ++c)
      for (unsigned int d = 0; d < 2; ++d) {
        values.jacobian[c][d] += dx[c] * basis.derivatives[i][d];
        derivatives[c][d] += dv[c] * basis.derivatives[i][d];
      }
  }
  for (unsigned int k = 0; k < n; ++k) {
    if (!arcs[k])
      continue;
    const Curve &arc = *arcs[k];
    const unsigned int next = (k + 1) % n;
    const double w = corners.value[k] + corners.value[next],
                 r = w > 0. ? corners.value[next] / w : 0., length = arc.length();
    const ThreeNodes line(r);
    const Tensor<1, 2> middle = x[n + k] - x[k], end = x[next] - x[k],
                       delta = (arc.point(r * length) - x[k]) - line.value[1] * middle -
                               line.value[2] * end,
                       slope = length * arc.tangent(r * length, 0.5 * length) -
                               line.derivative[1] * middle - line.derivative[2] * end;
    values.x += w * delta;
    for (unsigned int d = 0; d < 2; ++d) {
      const double dw = corners.derivatives[k][d] + corners.derivatives[next][d];
      for (unsigned int c = 0; c < 2; ++c)
        values.jacobian[c][d] += dw * delta[c] + (corners.derivatives[next][d] - r * dw) * slope[c];
    }
  }
  values.determinant = determinant(values.jacobian);
  values.gradient = derivatives * invert(values.jacobian);
  return values;
}

Tensor<1, 2> ForeignCell::on_edge(const unsigned int k, const double r) const {
  const ThreeNodes line(r);
  const unsigned int n = n_corners();
  return line.value[0] * v[k] + line.value[1] * v[n + k] + line.value[2] * v[(k + 1) % n];
}

Point<2> ForeignCell::middle() const {
  Point<2> middle = x[0];
  for (unsigned int k = 1; k < n_corners(); ++k)
    middle += (x[k] - x[0]) / n_corners();
  return middle;
}

template <typename T>
void ForeignCell::complete(CellNodes<T> &nodes_of) const {
  const unsigned int n = n_corners();
  for (unsigned int k = 0; k < n && !has_middles; ++k)
    nodes_of[n + k] = nodes_of[k] + 0.5 * (nodes_of[(k + 1) % n] - nodes_of[k]);
  if (is_triangle || has_centre)
    return;
  // The polynomials of eight nodes.
  const T first = nodes_of[0];
  nodes_of[8] = first;
  for (unsigned int k = 0; k < n; ++k)
    nodes_of[8] += 0.5 * (nodes_of[n + k] - first) - 0.25 * (nodes_of[k] - first);
}

template void ForeignCell::complete(CellNodes<Point<2>> &) const;
template void ForeignCell::complete(CellNodes<Tensor<1, 2>> &) const;
} // namespace Signorini
