// SPDX-License-Identifier: LGPL-2.1-or-later
// Proved constants for the loads that stresses do not balance exactly.

#include <signorini/error_control/equilibration/oscillation.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Signorini {
namespace {
using numbers::PI;

/** The discs about a point of the cell: inside of the one with the radius ρ all points see the
 * whole cell, and the one with the radius R contains it. */
struct Discs {
  Discs(const CellShape &shape, const Point<2> &x) {
    for (unsigned int k = 0; k < 4; ++k) {
      const Curve edge = shape.edge(k);
      // Between so many points of an arc the distances change by less than the margin.
      const unsigned int n = edge.is_flat() ? 1 : 32;
      const double margin = edge.is_flat() ? 0. : 1e-3 * edge.length();
      for (unsigned int i = 0; i <= n; ++i) {
        const double s = i * edge.length() / n;
        rho = std::min(rho, cross(edge.tangent(s, 0.), x - edge.point(s)) - margin);
        R = std::max(R, x.distance(edge.point(s)) + margin);
      }
    }
  }
  double beta() const {
    const double tau = std::max(0., rho / R);
    return tau / std::sqrt(2. * (1. + std::sqrt(std::max(0., 1. - tau * tau))));
  }

  double rho = std::numeric_limits<double>::max(), R = 0.;
};

/** Returns the constant in ‖v‖_e ≤ constant ‖grad v‖_T on the triangle of an edge from a to b and
 * a point P. */
double trace_constant(const Point<2> &a, const Point<2> &b, const Point<2> &P) {
  const double length = a.distance(b), area = 0.5 * std::abs(cross(b - a, P - a));
  const double to_P = std::max(a.distance(P), b.distance(P));
  const double poincare = std::max(to_P, length) / PI;
  return std::sqrt(length / area * (poincare * poincare + to_P * poincare));
}

/** Returns the depth of the largest rectangle on edge k that lies in the cell; 0 if there is none.
 */
double depth(const CellShape &shape, const unsigned int k) {
  const auto &a = shape.corners[k], &b = shape.corners[(k + 1) % 4];
  const Tensor<1, 2> along = (b - a) / a.distance(b);
  const Tensor<1, 2> left = shape.corners[(k + 3) % 4] - a, right = shape.corners[(k + 2) % 4] - b;
  // Corners of the smallest cells are as far off as coordinates round.
  const double rounding = 1e-12 * a.distance(b) + 1e-15 * std::max(a.norm(), b.norm());
  if (left * along > rounding || right * along < -rounding)
    return 0.;
  return std::min(cross(along, left), cross(along, right));
}
} // namespace

TractionRest TractionRest::of_norm(const double norm, const double length) {
  return {norm, length / (2. * PI) * norm, length * length / std::sqrt(500.56) * norm};
}

double OscillationConstants::normal(const unsigned int k, const TractionRest &rest) const {
  const double in_any_direction = edge[k] * rest.norm;
  if (depths_[k] == 0. || rest.norm == 0.)
    return in_any_direction;
  const double a = 13. / 35. * rest.norm * rest.norm, b = 12. / 5. * rest.slope * rest.slope,
               c = 12. * rest.primitive * rest.primitive,
               best = std::sqrt((b + std::sqrt(b * b + 12. * a * c)) / (2. * a)),
               d = std::min(best, depths_[k]);
  return std::min(in_any_direction, std::sqrt(a * d + b / d + c / (d * d * d)));
}

OscillationConstants::OscillationConstants(const CellShape &shape, const unsigned int degree) {
  // The better of two centres.
  const Discs of_centre(shape, shape.centre()), of_crossing(shape, shape.crossing);
  const Discs &discs = of_centre.beta() > of_crossing.beta() ? of_centre : of_crossing;
  const double beta = discs.beta();
  korn = std::sqrt(1. + 2. / (beta * beta));
  body = korn * (shape.has_arcs() ? 2. * discs.R / beta : shape.diameter()) / PI;
  const auto &x = shape.corners;
  if (shape.affine) {
    // |J|_2² is the larger eigenvalue of Jᵀ J.
    const Tensor<1, 2> a = x[1] - x[0], b = x[3] - x[0];
    const double sum = a.norm_square() + b.norm_square(), area = cross(a, b);
    const double largest = 0.5 * (sum + std::sqrt(std::max(0., sum * sum - 4. * area * area)));
    const unsigned int m = degree / 2;
    body = std::min(body, korn * 0.5 * std::sqrt(largest / ((m + 1.) * (m + 2.))));
  }
  for (unsigned int k = 0; k < 4; ++k) {
    const auto &a = x[k], &b = x[(k + 1) % 4];
    // Triangles with another corner, and rectangles, may leave a cell with an arc.
    edge[k] = korn * (shape.has_arcs() ? trace_constant(a, b, shape.crossing)
                                       : std::min(trace_constant(a, b, x[(k + 2) % 4]),
                                                  trace_constant(a, b, x[(k + 3) % 4])));
    depths_[k] = shape.has_arcs() ? 0. : depth(shape, k);
  }
}
} // namespace Signorini
