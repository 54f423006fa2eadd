// SPDX-License-Identifier: LGPL-2.1-or-later
// Triangles and quadrilaterals of degree two with exact arcs.

#include <signorini/discretization/space/foreign_field.h>

namespace Signorini {
namespace {
using Derivatives = std::array<double, 2>;

/** The polynomials of degree two at 0, 1/2 and 1, and their derivatives. */
struct LinePolynomials {
  explicit LinePolynomials(const double r)
    : value{{(1. - r) * (1. - 2. * r), 4. * r * (1. - r), r * (2. * r - 1.)}}
    , derivative{{4. * r - 3., 4. - 8. * r, 4. * r - 1.}} {}

  std::array<double, 3> value, derivative;
};

struct Barycentric {
  Barycentric(const double s, const double t)
    : value{{(1. - s) * (1. - t), s * (1. - t), t}}
    , derivatives{{{{t - 1., s - 1.}}, {{1. - t, -s}}, {{0., 1.}}}} {}

  std::array<double, 3> value;
  std::array<Derivatives, 3> derivatives;
};

/** The basis polynomials at a point; those that a triangle lacks are zero. */
struct Basis {
  Basis(const bool is_triangle, const double s, const double t) {
    if (is_triangle)
      set(Barycentric(s, t));
    else
      set(LinePolynomials(s), LinePolynomials(t));
  }

  CellNodes<double> value = {};
  CellNodes<Derivatives> derivatives = {};

private:
  void set(const Barycentric &at) {
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
  void set(const LinePolynomials &s, const LinePolynomials &t) {
    constexpr CellNodes<std::array<unsigned int, 2>> positions = {
      {{{0, 0}}, {{2, 0}}, {{2, 2}}, {{0, 2}}, {{1, 0}}, {{2, 1}}, {{1, 2}}, {{0, 1}}, {{1, 1}}}};
    for (unsigned int i = 0; i < 9; ++i) {
      const auto [j, k] = positions[i];
      value[i] = s.value[j] * t.value[k];
      derivatives[i] = {{s.derivative[j] * t.value[k], s.value[j] * t.derivative[k]}};
    }
  }
};

/** The weight w and the position r of an edge, with dw and w dr. */
struct EdgeCoordinates {
  EdgeCoordinates(const bool is_triangle, const unsigned int k, const double s, const double t) {
    if (is_triangle) {
      const Barycentric at(s, t);
      const unsigned int b = (k + 1) % 3, c = (k + 2) % 3;
      w = 1. - at.value[c];
      r = w > 0. ? at.value[b] / w : 0.;
      for (unsigned int d = 0; d < 2; ++d) {
        dw[d] = -at.derivatives[c][d];
        w_dr[d] = at.derivatives[b][d] - r * dw[d];
      }
      return;
    }
    // The edges t = 0, s = 1, t = 1, s = 0.
    const unsigned int along = k % 2;
    const double first = k < 2 ? 1. : -1., depth = along == 0 ? t : s;
    const bool is_upper = k == 1 || k == 2;
    r = k < 2 ? (along == 0 ? s : t) : 1. - (along == 0 ? s : t);
    w = is_upper ? depth : 1. - depth;
    dw[1 - along] = is_upper ? 1. : -1.;
    w_dr[along] = w * first;
  }

  double w, r;
  Derivatives dw = {{0., 0.}}, w_dr = {{0., 0.}};
};
} // namespace

ForeignCell::Values ForeignCell::at(const double s, const double t) const {
  const Basis basis(is_triangle, s, t);
  const unsigned int n = n_corners(), n_nodes = is_triangle ? 6 : 9;
  Values values;
  values.x = x[0];
  values.v = v[0];
  Tensor<2, 2> derivatives;
  // From differences, so that large translations leave no rounding.
  for (unsigned int i = 1; i < n_nodes; ++i) {
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
    const EdgeCoordinates edge(is_triangle, k, s, t);
    const LinePolynomials line(edge.r);
    const Curve &arc = *arcs[k];
    const double length = arc.length(), on_arc = edge.r * length;
    const Tensor<1, 2> middle = x[n + k] - x[k], end = x[(k + 1) % n] - x[k],
                       delta =
                         (arc.point(on_arc) - x[k]) - line.value[1] * middle - line.value[2] * end,
                       slope = length * arc.tangent(on_arc, 0.5 * length) -
                               line.derivative[1] * middle - line.derivative[2] * end;
    values.x += edge.w * delta;
    for (unsigned int c = 0; c < 2; ++c)
      for (unsigned int d = 0; d < 2; ++d)
        values.jacobian[c][d] += edge.dw[d] * delta[c] + edge.w_dr[d] * slope[c];
  }
  values.determinant = determinant(values.jacobian);
  values.gradient = derivatives * invert(values.jacobian);
  return values;
}

Tensor<1, 2> ForeignCell::gradient(const CellNodes<double> &nodal, const Values &values,
                                   const double s, const double t) const {
  const Basis basis(is_triangle, s, t);
  Tensor<1, 2> derivatives;
  for (unsigned int i = 0; i < nodal.size(); ++i)
    for (unsigned int d = 0; d < 2; ++d)
      derivatives[d] += nodal[i] * basis.derivatives[i][d];
  return derivatives * invert(values.jacobian);
}

double ForeignCell::value(const CellNodes<double> &nodal, const double s, const double t) const {
  const Basis basis(is_triangle, s, t);
  double sum = 0.;
  for (unsigned int i = 0; i < nodal.size(); ++i)
    sum += nodal[i] * basis.value[i];
  return sum;
}

template <typename T>
T ForeignCell::on_edge(const CellNodes<T> &nodal, const unsigned int k, const double r) const {
  const LinePolynomials line(r);
  const unsigned int n = n_corners();
  return line.value[0] * nodal[k] + line.value[1] * nodal[n + k] +
         line.value[2] * nodal[(k + 1) % n];
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

template double ForeignCell::on_edge(const CellNodes<double> &, unsigned int, double) const;
template Tensor<1, 2> ForeignCell::on_edge(const CellNodes<Tensor<1, 2>> &, unsigned int,
                                           double) const;
template void ForeignCell::complete(CellNodes<double> &) const;
template void ForeignCell::complete(CellNodes<Point<2>> &) const;
template void ForeignCell::complete(CellNodes<Tensor<1, 2>> &) const;
} // namespace Signorini
