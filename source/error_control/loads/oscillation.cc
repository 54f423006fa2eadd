// SPDX-License-Identifier: LGPL-2.1-or-later
// Proved constants for the loads that stresses do not balance exactly.

#include <signorini/error_control/loads/oscillation.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Signorini {
namespace {
using numbers::PI;

/** Returns ρ/R for the discs about a point of the cell. */
double roundness(const CellShape &shape, const Point<2> &x) {
  double rho = std::numeric_limits<double>::max(), R = 0.;
  for (unsigned int k = 0; k < 4; ++k) {
    const Tensor<1, 2> edge = shape.corners[(k + 1) % 4] - shape.corners[k];
    rho = std::min(rho, cross(edge, x - shape.corners[k]) / edge.norm());
    R = std::max(R, x.distance(shape.corners[k]));
  }
  return rho / R;
}

/** Returns Korn's constant, with the better of two centres. */
double korn_constant(const CellShape &shape) {
  const double tau = std::max(roundness(shape, shape.centre()), roundness(shape, shape.crossing));
  const double beta = tau / std::sqrt(2. * (1. + std::sqrt(std::max(0., 1. - tau * tau))));
  return std::sqrt(1. + 2. / (beta * beta));
}

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
  constexpr double rounding = 1e-12;
  if (left * along > rounding * left.norm() || right * along < -rounding * right.norm())
    return 0.;
  return std::min(cross(along, left), cross(along, right));
}

/** Returns the constant of Airy's function on a rectangle. */
double beam_constant(const double L, const double max_depth) {
  const double d = std::min(max_depth, 0.73 * L);
  return std::sqrt(13. / 35. * d + 12. / (5. * d) * L * L / (4. * PI * PI) +
                   12. / std::pow(d, 3) * std::pow(L, 4) / 500.56);
}
} // namespace

double turning_constant(const double L, const double max_depth) {
  const double d = std::min(L, max_depth);
  return std::sqrt(4. * L * L * L / (30. * d) + 4. * L * d / 45. + 4. * d * d * d / (105. * L));
}

OscillationConstants::OscillationConstants(const CellShape &shape, const unsigned int degree)
  : korn(korn_constant(shape))
  , body(korn * shape.diameter() / PI) {
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
    edge[k] =
      korn * std::min(trace_constant(a, b, x[(k + 2) % 4]), trace_constant(a, b, x[(k + 3) % 4]));
    const double d = depth(shape, k);
    normal[k] = d > 0. ? std::min(edge[k], beam_constant(a.distance(b), d)) : edge[k];
  }
}
} // namespace Signorini
