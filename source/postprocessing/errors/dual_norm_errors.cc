// SPDX-License-Identifier: LGPL-2.1-or-later
// The left-hand sides of (15), (25) and (32).

#include <signorini/discretization/mesh/cut_quadrature.h>
#include <signorini/postprocessing/errors/dual_norm_errors.h>
#include <signorini/postprocessing/norms/slobodeckij_norm.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace Signorini
{
namespace
{
/** A function at quadrature points of a side, by value times weight. */
struct SampledFunction
{
  std::vector<double> arc_lengths;
  std::vector<double> weighted_values;
};

/** Samples p between consecutive @p cuts, sorted arc lengths, with n points on each interval. */
SampledFunction sample(const dealii::Function<2> &p,
                       const Side<2> &side,
                       const std::vector<double> &cuts,
                       const unsigned int n_points)
{
  const dealii::Quadrature<1> rule = split_quadrature(dealii::QGauss<1>(n_points), cuts);
  SampledFunction samples;
  std::vector<dealii::Point<2>> points;
  for (const dealii::Point<1> &s : rule.get_points())
  {
    samples.arc_lengths.push_back(s[0]);
    points.push_back(side.point(s[0]));
  }
  samples.weighted_values.resize(points.size());
  p.value_list(points, samples.weighted_values);
  for (std::size_t q = 0; q < points.size(); ++q)
    samples.weighted_values[q] *= rule.weight(q);
  return samples;
}

/** Returns the ends of n equal intervals of a side and of its pieces, with the kinks and intervals
 * that shrink towards them. */
std::vector<double> cut_side(const Side<2> &side,
                             const Kinks<2> &kinks,
                             const unsigned int n_intervals)
{
  std::vector<double> cuts;
  for (unsigned int i = 0; i <= n_intervals; ++i)
    cuts.push_back(i * side.length() / n_intervals);
  for (unsigned int k = 1; k < side.n_pieces(); ++k)
    cuts.push_back(side.start_of(k));
  for (const double s : kinks.cut(side, 0., side.length()))
  {
    cuts.push_back(s);
    for (const double sign : {-1., 1.})
      for (const double near : graded_positions(s, sign * side.length() / n_intervals))
        if (near > 0. && near < side.length())
          cuts.push_back(near);
  }
  std::sort(cuts.begin(), cuts.end());
  return cuts;
}

/** Samples p - p_H (or R^H p - p_H) on the patches [first, last) of a side, at points of every
 * patch and of every cell of the grid. */
SampledFunction sample_difference(const MultiplierSpace<2> &space,
                                  const dealii::Function<2> &p,
                                  const Kinks<2> &kinks,
                                  const Pressure &P,
                                  const dealii::Vector<double> *projected_p,
                                  const unsigned int first,
                                  const unsigned int last,
                                  const unsigned int n_cells)
{
  const std::vector<Patch<2>> &patches = space.surface().patches();
  const Side<2> &side = space.surface().side(patches[first]);
  std::vector<double> cuts = cut_side(side, kinks, n_cells);
  for (unsigned int tau = first; tau < last; ++tau)
    cuts.push_back(patches[tau].upper[0]);
  std::sort(cuts.begin(), cuts.end());
  SampledFunction samples = projected_p == nullptr
                              ? sample(p, side, cuts, 6)
                              : sample(dealii::Functions::ZeroFunction<2>(), side, cuts, 2);
  const SampledFunction ones =
    sample(dealii::Functions::ConstantFunction<2>(1.), side, cuts, projected_p == nullptr ? 6 : 2);
  unsigned int tau = first;
  for (std::size_t q = 0; q < samples.arc_lengths.size(); ++q)
  {
    while (tau + 1 < last && samples.arc_lengths[q] > patches[tau].upper[0])
      ++tau;
    const double constant = (projected_p == nullptr ? 0. : (*projected_p)[tau]) - P[tau];
    samples.weighted_values[q] += constant * ones.weighted_values[q];
  }
  return samples;
}

/** Returns the root of the sum of squares, none if one of them is unknown. */
std::optional<double> hypot(const std::optional<double> &a, const std::optional<double> &b)
{
  return a && b ? std::optional<double>(std::hypot(*a, *b)) : std::nullopt;
}

/** The number of patches above which a side does not get the paper's norm: its cost grows like m³.
 */
constexpr unsigned int largest_slobodeckij = 128;

/** Returns Richardson's extrapolation of the error's h² on grids of 8 m and 16 m cells. */
double extrapolate(const std::array<double, 2> &norms)
{
  return norms[1] + (norms[1] - norms[0]) / 3.;
}
} // namespace

template <>
ExactPressure<2>::ExactPressure(const Scene<2> &scene)
  : scene_(scene)
{
  for (const unsigned int number : scene.contact_sides())
  {
    const Side<2> &side = scene.geometry.sides[number];
    const SampledFunction p =
      sample(*scene.boundary[number].exact_pressure, side, cut_side(side, scene.kinks, 4096), 8);
    coefficients_[number] = spectral_norm_on(side).coefficients(p.arc_lengths, p.weighted_values);
  }
}

template <int dim>
dealii::Vector<double> ExactPressure<dim>::project(const MultiplierSpace<dim> &space) const
{
  constexpr unsigned int n_points = dim == 2 ? 10 : 4;
  const auto p_on = [&](const Piece<dim> &piece, const SurfaceRule<dim> &rule) {
    std::vector<double> p(rule.size());
    space.surface().condition(piece).exact_pressure->value_list(rule.points, p);
    return p;
  };
  return space.project(
    integrate_against_multipliers(space, n_points, Grading::towards_kinks, p_on));
}
template dealii::Vector<double> ExactPressure<2>::project(const MultiplierSpace<2> &) const;
template dealii::Vector<double> ExactPressure<3>::project(const MultiplierSpace<3> &) const;

template <>
DualNormErrors ExactPressure<2>::errors_on_side(const MultiplierSpace<2> &space,
                                                const Pressure &P,
                                                const dealii::Vector<double> &projected_p,
                                                const unsigned int first,
                                                const unsigned int last) const
{
  const std::vector<Patch<2>> &patches = space.surface().patches();
  const unsigned int number = patches[first].side, m = last - first;
  const Side<2> &side = scene_.geometry.sides[number];
  const std::vector<double> ends = patch_ends(patches, first, last);
  dealii::Vector<double> P_side(m), difference(m);
  for (unsigned int i = 0; i < m; ++i)
  {
    P_side[i] = P[first + i];
    difference[i] = projected_p[first + i] - P[first + i];
  }
  const SpectralNorm norm = spectral_norm_on(side);
  const dealii::Vector<double> &p = coefficients_.at(number);
  DualNormErrors errors;
  errors.spectral = norm.distance(p, ends, P_side);
  errors.superclose_spectral = norm.distance(dealii::Vector<double>(p.size()), ends, difference);
  if (m > largest_slobodeckij || !side.is_flat())
    return errors;

  std::array<double, 2> norms, superclose_norms;
  for (unsigned int g = 0; g < 2; ++g)
  {
    const SlobodeckijNorm grid(side.length(), (g + 1) * 8 * m);
    const auto dual_norm = [&](const dealii::Vector<double> *projection) {
      const SampledFunction q = sample_difference(space,
                                                  *scene_.boundary[number].exact_pressure,
                                                  scene_.kinks,
                                                  P,
                                                  projection,
                                                  first,
                                                  last,
                                                  grid.n_cells());
      return grid.dual_norm(q.arc_lengths, q.weighted_values);
    };
    norms[g] = dual_norm(nullptr);
    superclose_norms[g] = dual_norm(&projected_p);
  }
  errors.slobodeckij = extrapolate(norms);
  errors.superclose_slobodeckij = extrapolate(superclose_norms);
  return errors;
}

template <>
DualNormErrors ExactPressure<2>::errors(const MultiplierSpace<2> &space, const Pressure &P) const
{
  const dealii::Vector<double> projected_p = project(space);
  DualNormErrors sum = {0., 0., 0., 0.};
  for_each_side(space.surface().patches(), [&](const unsigned int first, const unsigned int last) {
    const DualNormErrors side = errors_on_side(space, P, projected_p, first, last);
    sum.spectral = std::hypot(sum.spectral, side.spectral);
    sum.superclose_spectral = std::hypot(sum.superclose_spectral, side.superclose_spectral);
    sum.slobodeckij = hypot(sum.slobodeckij, side.slobodeckij);
    sum.superclose_slobodeckij = hypot(sum.superclose_slobodeckij, side.superclose_slobodeckij);
  });
  return sum;
}

Columns<DualNormErrors> DualNormErrors::columns()
{
  return {{"p_dual", &DualNormErrors::slobodeckij},
          {"p_dual_spectral", &DualNormErrors::spectral},
          {"p_superclose_dual", &DualNormErrors::superclose_slobodeckij},
          {"p_superclose_dual_spectral", &DualNormErrors::superclose_spectral}};
}
} // namespace Signorini
