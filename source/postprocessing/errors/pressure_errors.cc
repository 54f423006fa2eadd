// SPDX-License-Identifier: LGPL-2.1-or-later
// The left-hand side of (14) and (33).

#include <signorini/base/errors.h>
#include <signorini/postprocessing/errors/dual_norm_errors.h>
#include <signorini/postprocessing/errors/pressure_errors.h>
#include <signorini/postprocessing/fields/contact_pressure.h>
#include <signorini/postprocessing/quantities/contact_zones.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace Signorini
{
template <int dim>
PressureErrors compute_pressure_errors(const MultiplierSpace<dim> &space,
                                       const Pressure &P,
                                       const unsigned int n_points)
{
  const RecoveredPressure<dim> recovered(space, P);
  double l2 = 0.;
  double post_l2 = 0.;
  std::vector<double> p;
  for (const Piece<dim> &piece : space.surface().pieces())
  {
    const SurfaceRule<dim> rule = space.surface().rule(
      piece, n_points + space.unknowns_on(piece.patch).size() - 1, Grading::towards_kinks);
    p.resize(rule.size());
    space.surface().condition(piece).exact_pressure->value_list(rule.points, p);
    for (std::size_t q = 0; q < rule.size(); ++q)
    {
      const double difference = p[q] - space.value(P, piece.patch, rule.on_side[q]);
      const double post = p[q] - recovered(piece.patch, rule.on_side[q]);
      l2 += difference * difference * rule.weights[q];
      post_l2 += post * post * rule.weights[q];
    }
  }
  if (!std::isfinite(l2))
    throw InputError(
      "the exact pressure has no finite value at a quadrature point, allowed: finite "
      "values inside the contact sides.");
  return {std::sqrt(l2), std::sqrt(post_l2)};
}

Columns<PressureErrors> PressureErrors::columns()
{
  return {{"p_l2", &PressureErrors::l2}, {"p_post_l2", &PressureErrors::post_l2}};
}

template PressureErrors compute_pressure_errors(const MultiplierSpace<2> &,
                                                const Pressure &,
                                                unsigned int);
template PressureErrors compute_pressure_errors(const MultiplierSpace<3> &,
                                                const Pressure &,
                                                unsigned int);

// The left-hand sides of (15) and (25) on rectangles.

namespace
{
/** The points of a composite Gauss rule on an edge. */
struct EdgePoints
{
  explicit EdgePoints(const double length)
  {
    // These are two points for the half of a period of the highest mode.
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
DualNormErrors ExactPressure<3>::errors(const MultiplierSpace<3> &space, const Pressure &P) const
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

// The ends of contact, in the exact and in the discrete solution.

namespace
{
/** Returns the arc lengths at which the sign of the exact pressure changes from 0 to negative or
 * back. */
std::vector<double> exact_ends(const Scene<2> &scene, const unsigned int number)
{
  const Side<2> &side = scene.geometry.sides[number];
  const dealii::Function<2> &p = *scene.boundary[number].exact_pressure;
  const std::vector<double> cuts = scene.kinks.cut(side, 0., side.length());
  std::vector<double> ends;
  for (std::size_t i = 1; i + 1 < cuts.size(); ++i)
  {
    const double s = cuts[i], step = 1e-6 * side.length();
    const bool before = p.value(side.point(s - step)) < 0.;
    const bool after = p.value(side.point(s + step)) < 0.;
    if (before != after)
      ends.push_back(s);
  }
  return ends;
}

/** Returns the arc lengths between a pressing patch and one that does not press; where patches have
 * several nodes, the middle between a pressing node and one that does not. */
std::vector<double> discrete_ends(const MultiplierSpace<2> &space,
                                  const unsigned int number,
                                  const Pressure &P)
{
  const std::vector<Patch<2>> &patches = space.surface().patches();
  const double threshold = pressing_threshold(P);
  std::vector<double> ends;
  if (!space.is_piecewise_constant())
  {
    for (const ContactBracket &bracket : contact_brackets(space, P))
      if (bracket.side == number)
        ends.push_back(0.5 * (bracket.from + bracket.to));
    return ends;
  }
  for (std::size_t tau = 0; tau + 1 < patches.size(); ++tau)
    if (patches[tau].side == number && patches[tau + 1].side == number &&
        (P[tau] < threshold) != (P[tau + 1] < threshold))
      ends.push_back(patches[tau].upper[0]);
  return ends;
}

/** Returns the largest distance of a point of @p from to the nearest of @p to. */
double one_sided_distance(const std::vector<double> &from, const std::vector<double> &to)
{
  double largest = 0.;
  for (const double s : from)
  {
    double nearest = std::abs(s - to.front());
    for (const double t : to)
      nearest = std::min(nearest, std::abs(s - t));
    largest = std::max(largest, nearest);
  }
  return largest;
}
} // namespace

std::optional<double> contact_end_error(const MultiplierSpace<2> &space,
                                        const Scene<2> &scene,
                                        const Pressure &P)
{
  std::optional<double> largest;
  for (const unsigned int number : scene.contact_sides())
  {
    const std::vector<double> exact = exact_ends(scene, number);
    const std::vector<double> discrete = discrete_ends(space, number, P);
    if (exact.empty() != discrete.empty())
      return {};
    if (!exact.empty())
      largest = std::max({largest.value_or(0.),
                          one_sided_distance(exact, discrete),
                          one_sided_distance(discrete, exact)});
  }
  return largest;
}
} // namespace Signorini
