// SPDX-License-Identifier: LGPL-2.1-or-later
// Proved constants for what stresses do not balance exactly.

#include <signorini/bound/oscillation.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
namespace
{
using dealii::numbers::PI;
using Vector2 = dealii::Tensor<1, 2>;

double cross(const Vector2 &a, const Vector2 &b)
{
  return a[0] * b[1] - a[1] * b[0];
}

/** rho/R for the discs about a point of the cell. */
double roundness(const CellShape &shape, const dealii::Point<2> &x)
{
  double rho = std::numeric_limits<double>::max(), R = 0.;
  for (unsigned int k = 0; k < 4; ++k)
  {
    const Vector2 edge = shape.corners[(k + 1) % 4] - shape.corners[k];
    rho = std::min(rho, cross(edge, x - shape.corners[k]) / edge.norm());
    R = std::max(R, x.distance(shape.corners[k]));
  }
  return rho / R;
}

/** Korn's constant, with the better of two centres. */
double korn_constant(const CellShape &shape)
{
  const double tau = std::max(roundness(shape, shape.centre()), roundness(shape, shape.crossing));
  const double beta = tau / std::sqrt(2. * (1. + std::sqrt(std::max(0., 1. - tau * tau))));
  return std::sqrt(1. + 2. / (beta * beta));
}

/** ‖v‖_e <= constant ‖grad v‖_T on the triangle of an edge from a to b and a point P. */
double trace_constant(const dealii::Point<2> &a,
                      const dealii::Point<2> &b,
                      const dealii::Point<2> &P)
{
  const double length = a.distance(b), area = 0.5 * std::abs(cross(b - a, P - a));
  const double to_P = std::max(a.distance(P), b.distance(P));
  const double poincare = std::max(to_P, length) / PI;
  return std::sqrt(length / area * (poincare * poincare + to_P * poincare));
}
} // namespace

OscillationConstants::OscillationConstants(const CellShape &shape)
  : korn(korn_constant(shape))
  , body(korn * shape.diameter() / PI)
{
  const auto &x = shape.corners;
  for (unsigned int k = 0; k < 4; ++k)
  {
    const auto &a = x[k], &b = x[(k + 1) % 4];
    edge[k] =
      korn * std::min(trace_constant(a, b, x[(k + 2) % 4]), trace_constant(a, b, x[(k + 3) % 4]));
  }
}
} // namespace Signorini
