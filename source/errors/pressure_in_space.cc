// SPDX-License-Identifier: LGPL-2.1-or-later
// The left-hand sides of (15) and (25) on rectangles.

#include <signorini/errors/dual_norm_errors.h>

#include <deal.II/base/quadrature_lib.h>

#include <array>
#include <cmath>

namespace Signorini
{
namespace
{
/** Points of a composite Gauss rule on an edge. */
struct EdgePoints
{
  explicit EdgePoints(const double length)
  {
    // Two points for the half of a period of the highest mode.
    constexpr unsigned int n_intervals = RectangleNorm::n_modes / 4, n_points = 8;
    const dealii::QGauss<1> gauss(n_points);
    for (unsigned int i = 0; i < n_intervals; ++i)
      for (unsigned int q = 0; q < n_points; ++q)
      {
        positions.push_back(length * (i + gauss.point(q)[0]) / n_intervals);
        weights.push_back(length * gauss.weight(q) / n_intervals);
      }
  }

  std::vector<double> positions, weights;
};

dealii::FullMatrix<double> coefficients_on(const Side<3> &side, const dealii::Function<3> &p)
{
  const std::array<double, 2> lengths = side.lengths();
  const EdgePoints x(lengths[0]), y(lengths[1]);
  dealii::FullMatrix<double> weighted(x.positions.size(), y.positions.size());
  std::vector<dealii::Point<3>> points(y.positions.size());
  std::vector<double> values(y.positions.size());
  for (std::size_t a = 0; a < x.positions.size(); ++a)
  {
    for (std::size_t b = 0; b < points.size(); ++b)
      points[b] = side.point({x.positions[a], y.positions[b]});
    p.value_list(points, values);
    for (std::size_t b = 0; b < points.size(); ++b)
      weighted(a, b) = values[b] * x.weights[a] * y.weights[b];
  }
  return RectangleNorm(lengths).coefficients({{x.positions, y.positions}}, weighted);
}
} // namespace

template <>
ExactPressure<3>::ExactPressure(const Scene<3> &scene)
  : scene_(scene)
{
  for (const unsigned int number : scene.contact_sides())
    coefficients_[number] =
      coefficients_on(scene.geometry.sides[number], *scene.boundary[number].exact_pressure);
}

template <>
DualNormErrors ExactPressure<3>::errors(const MultiplierSpace<3> &space,
                                        const dealii::Vector<double> &P) const
{
  dealii::Vector<double> difference = project(space);
  difference -= P;
  DualNormErrors sum = {0., {}, 0., {}};
  for (const PatchGrid &grid : patch_grids(space.surface().patches()))
  {
    const RectangleNorm norm = rectangle_norm_on(grid);
    sum.spectral =
      std::hypot(sum.spectral, norm.distance(coefficients_.at(grid.side), values_on(grid, P)));
    sum.superclose_spectral =
      std::hypot(sum.superclose_spectral, norm.norm(values_on(grid, difference)));
  }
  return sum;
}
} // namespace Signorini
