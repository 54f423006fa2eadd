// SPDX-License-Identifier: LGPL-2.1-or-later
// The left-hand sides of (15), (25) and (32): the exact pressure against p_H.

#include <signorini/base/instantiate.h>
#include <signorini/discretization/mesh/cut_quadrature.h>
#include <signorini/verification/norms/cosine_norm.h>
#include <signorini/verification/norms/exact_pressure.h>
#include <signorini/verification/norms/slobodeckij_norm.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace Signorini {
namespace {
/** A function at quadrature points of a side, by value times weight. */
struct SampledFunction {
  std::vector<double> arc_lengths;
  std::vector<double> weighted_values;
};

/** Samples a function f(s) between consecutive @p cuts, sorted arc lengths, with n points on each
 * interval. */
template <typename Values>
SampledFunction sample(const std::vector<double> &cuts, const unsigned int n_points,
                       const Values &f) {
  const Quadrature<1> rule = split_quadrature(QGauss<1>(n_points), cuts);
  SampledFunction samples;
  for (unsigned int q = 0; q < rule.size(); ++q) {
    samples.arc_lengths.push_back(rule.point(q)[0]);
    samples.weighted_values.push_back(f(rule.point(q)[0]) * rule.weight(q));
  }
  return samples;
}

/** Returns the ends of n equal intervals of a side and of its pieces, with the kinks and intervals
 * that shrink towards them. */
std::vector<double> cut_side(const Side<2> &side, const Kinks<2> &kinks,
                             const unsigned int n_intervals) {
  std::vector<double> cuts;
  for (unsigned int i = 0; i <= n_intervals; ++i)
    cuts.push_back(i * side.length() / n_intervals);
  for (unsigned int k = 1; k < side.n_pieces(); ++k)
    cuts.push_back(side.start_of(k));
  for (const double s : kinks.crossings(side, 0., side.length())) {
    cuts.push_back(s);
    for (const double sign : {-1., 1.})
      for (const double near : graded_positions(s, sign * side.length() / n_intervals))
        if (near > 0. && near < side.length())
          cuts.push_back(near);
  }
  std::sort(cuts.begin(), cuts.end());
  return cuts;
}

/** Returns the root of the sum of squares, none if one of them is unknown. */
std::optional<double> hypot(const std::optional<double> &a, const std::optional<double> &b) {
  return a && b ? std::optional<double>(std::hypot(*a, *b)) : std::nullopt;
}

/** The number of patches above which a side does not get the paper's norm: its cost grows like m³.
 */
constexpr unsigned int max_slobodeckij_patches = 128;

/** Returns Richardson's extrapolation of the error's h² on grids of 8 m and 16 m cells. */
double extrapolate(const std::array<double, 2> &norms) {
  return norms[1] + (norms[1] - norms[0]) / 3.;
}

CosineNorm<2>::Modes coefficients_on(const Scene<2> &scene, const ContactCondition<2> &contact) {
  const Side<2> &side = scene.geometry.sides[contact.side];
  const Function<2> &exact = *contact.exact_pressure;
  const SampledFunction p = sample(cut_side(side, scene.kinks, 4096), 8,
                                   [&](const double s) { return exact.value(side.point(s)); });
  return CosineNorm<2>(side).coefficients(p.arc_lengths, p.weighted_values);
}

FullMatrix<double> coefficients_on(const Scene<3> &scene, const ContactCondition<3> &contact) {
  const Side<3> &side = scene.geometry.sides[contact.side];
  // Two points for the half of a period of the highest mode.
  const QIterated<1> rule(QGauss<1>(8), CosineNorm<3>::n_modes / 4);
  const std::array<double, 2> lengths = side.rectangle();
  std::array<std::vector<double>, 2> positions;
  for (unsigned int d = 0; d < 2; ++d)
    for (const Point<1> &s : rule.get_points())
      positions[d].push_back(lengths[d] * s[0]);
  FullMatrix<double> weighted(rule.size(), rule.size());
  std::vector<Point<3>> points(rule.size());
  std::vector<double> values(rule.size());
  for (unsigned int a = 0; a < rule.size(); ++a) {
    for (unsigned int b = 0; b < rule.size(); ++b)
      points[b] = point_on(side.faces().front(),
                           {positions[0][a] / lengths[0], positions[1][b] / lengths[1]});
    contact.exact_pressure->value_list(points, values);
    for (unsigned int b = 0; b < rule.size(); ++b)
      weighted(a, b) = values[b] * lengths[0] * rule.weight(a) * lengths[1] * rule.weight(b);
  }
  return CosineNorm<3>(lengths).coefficients(positions, weighted);
}

/** Adds the paper's norm on a side with few patches. @param differences those between the means of
 * the exact pressure and P. */
void add_slobodeckij(const Scene<2> &scene, const PatchGrid &grid, const Pressure &P,
                     const dealii::Vector<double> &differences, DualNormErrors &errors) {
  const unsigned int m = grid.n(0);
  const Side<2> &side = scene.geometry.sides[grid.side];
  const std::vector<double> &ends = grid.ends[0];
  if (m > max_slobodeckij_patches || !side.is_flat())
    return;
  const Function<2> &exact = *scene.contacts[grid.contact].exact_pressure;
  const auto on_patch = [&](const dealii::Vector<double> &values, const double s) {
    return values[grid.patches[std::lower_bound(ends.begin() + 1, ends.end() - 1, s) -
                               ends.begin() - 1]];
  };
  std::array<double, 2> norms, superclose_norms;
  for (unsigned int g = 0; g < 2; ++g) {
    // Points on every patch and on every cell of the grid.
    const SlobodeckijNorm uniform(side.length(), (g + 1) * 8 * m);
    std::vector<double> cuts = cut_side(side, scene.kinks, uniform.n_cells());
    cuts.insert(cuts.end(), ends.begin() + 1, ends.end());
    std::sort(cuts.begin(), cuts.end());
    const SampledFunction error =
      sample(cuts, 6, [&](const double s) { return exact.value(side.point(s)) - on_patch(P, s); });
    const SampledFunction superclose =
      sample(cuts, 2, [&](const double s) { return on_patch(differences, s); });
    norms[g] = uniform.dual_norm(error.arc_lengths, error.weighted_values);
    superclose_norms[g] = uniform.dual_norm(superclose.arc_lengths, superclose.weighted_values);
  }
  errors.slobodeckij = extrapolate(norms);
  errors.superclose_slobodeckij = extrapolate(superclose_norms);
}
} // namespace

template <int dim>
std::vector<double> exact_pressure_on(const ContactSurface<dim> &surface, const Piece<dim> &piece,
                                      const SurfaceRule<dim> &rule) {
  std::vector<double> p(rule.size());
  surface.condition(piece).exact_pressure->value_list(rule.points, p);
  return p;
}
INSTANTIATE_FUNCTION(exact_pressure_on);

template <int dim>
dealii::Vector<double> ExactPressure<dim>::project(const MultiplierSpace<dim> &space) const {
  constexpr unsigned int n_points = dim == 2 ? 10 : 4;
  return space.project(integrate_against_multipliers(
    space, n_points, Grading::towards_kinks, [&](const auto &piece, const auto &rule) {
      return exact_pressure_on(space.surface(), piece, rule);
    }));
}

template <int dim>
ExactPressure<dim>::ExactPressure(const Scene<dim> &scene)
  : scene_(scene) {
  for (const ContactCondition<dim> &contact : scene.contacts)
    coefficients_.push_back(coefficients_on(scene, contact));
}

template <int dim>
DualNormErrors ExactPressure<dim>::errors(const MultiplierSpace<dim> &space,
                                          const Pressure &P) const {
  dealii::Vector<double> differences = project(space);
  differences -= P;
  DualNormErrors sum = {0., 0., 0., 0.};
  for (const PatchGrid &grid : patch_grids(space.surface())) {
    const CosineNorm<dim> norm(scene_.geometry.sides[grid.side]);
    DualNormErrors side;
    side.spectral = norm.distance(coefficients_[grid.contact], grid, P);
    side.superclose_spectral = norm.distance(typename CosineNorm<dim>::Modes(), grid, differences);
    if constexpr (dim == 2)
      add_slobodeckij(scene_, grid, P, differences, side);
    sum.spectral = std::hypot(sum.spectral, side.spectral);
    sum.superclose_spectral = std::hypot(sum.superclose_spectral, side.superclose_spectral);
    sum.slobodeckij = hypot(sum.slobodeckij, side.slobodeckij);
    sum.superclose_slobodeckij = hypot(sum.superclose_slobodeckij, side.superclose_slobodeckij);
  }
  return sum;
}
template class ExactPressure<2>;
template class ExactPressure<3>;
} // namespace Signorini
