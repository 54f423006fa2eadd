// SPDX-License-Identifier: LGPL-2.1-or-later
// The largest contact pressure, as a point value and not as a mean.

#include <signorini/postprocessing/fields/forces.h>
#include <signorini/postprocessing/quantities/peak_pressure.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>

#include "peak_pressure_internal.h"

namespace Signorini
{
/** The parabola with given means over three intervals that follow one another. */
class MeanParabola
{
public:
  /** The value of the function at a point. */
  struct Value
  {
    double s, value;
  };
  /**
   * Finds the parabola.
   * @param ends of the intervals, in their order.
   */
  MeanParabola(const std::array<double, 4> &ends, const std::array<double, 3> &means)
    : from_(ends[1])
    , to_(ends[2])
  {
    // With the primitive's divided differences over the four ends e_0 < ... < e_3, from e_1.
    const std::array<double, 4> e = {{ends[0] - from_, 0., to_ - from_, ends[3] - from_}};
    const double first = (means[1] - means[0]) / (e[2] - e[0]);
    const double second = ((means[2] - means[1]) / (e[3] - e[1]) - first) / (e[3] - e[0]);
    // d/ds of (s-e0) m0 + (s-e0)(s-e1) first + (s-e0)(s-e1)(s-e2) second.
    curvature_ = 3. * second;
    slope_ = 2. * first - 2. * second * (e[0] + e[1] + e[2]);
    constant_ =
      means[0] - first * (e[0] + e[1]) + second * (e[0] * e[1] + e[0] * e[2] + e[1] * e[2]);
  }
  /** Returns its maximum if that lies in the middle interval, else the value in its middle: where
   * the parabola is monotone, a neighbour has a larger value. */
  Value maximum() const
  {
    const double top = curvature_ < 0. ? from_ - slope_ / (2. * curvature_) : from_;
    return at(top > from_ && top < to_ ? top : 0.5 * (from_ + to_));
  }
  /** Returns the maximum also where it lies at an end, up to rounding. */
  Value maximum_with_ends() const
  {
    const double top = curvature_ < 0. ? from_ - slope_ / (2. * curvature_) : 2. * from_ - to_;
    const double slack = 1e-9 * (to_ - from_);
    return at(top > from_ - slack && top < to_ + slack ? std::clamp(top, from_, to_)
                                                       : 0.5 * (from_ + to_));
  }

private:
  Value at(const double s) const
  {
    const double t = s - from_;
    return {s, constant_ + t * (slope_ + t * curvature_)};
  }

  double from_, to_;
  double constant_, slope_, curvature_;
};

std::optional<PressureMaximum> peak_pressure(const MultiplierSpace<2> &multipliers,
                                             const Pressure &P,
                                             const std::vector<SingularPlace<2>> &outside_of)
{
  if (!multipliers.is_piecewise_constant())
    return peak_of_polynomial(multipliers, P, outside_of);
  const ContactSurface<2> &surface = multipliers.surface();
  const std::vector<Patch<2>> &patches = surface.patches();
  const double threshold = pressing_threshold(P);
  const RecoveredPressure recovered(multipliers, P);
  std::vector<double> means;
  for (std::size_t tau = 0; tau < patches.size(); ++tau)
    means.push_back(-multipliers.value(P, tau, patches[tau].centre()));
  const auto presses = [&](const std::size_t tau, const unsigned int side) {
    return tau < patches.size() && patches[tau].side == side && means[tau] > -threshold;
  };
  std::optional<PressureMaximum> peak;
  for (std::size_t tau = 0; tau < patches.size(); ++tau)
  {
    const Patch<2> &patch = patches[tau];
    if (!presses(tau, patch.side))
      continue;
    // Of equal peaks (a symmetric body may have two) the first one is taken, independent of
    // rounding.
    constexpr double larger = 1. + 1e-9;
    const auto compare = [&](const MeanParabola::Value &candidate) {
      const Side<2> &side = surface.side(patch);
      const Point<2> x = side.point(candidate.s);
      if ((!peak || candidate.value > larger * peak->value) && !any_contains(outside_of, x))
        peak = {candidate.value, {side.name(), candidate.s, x}, means[tau], {}};
    };
    const bool has_corner = surface.side(patch).has_corner(patch.lower[0]) ||
                            surface.side(patch).has_corner(patch.upper[0]);
    if (tau > 0 && presses(tau - 1, patch.side) && presses(tau + 1, patch.side) && !has_corner)
      compare(
        MeanParabola(
          {{patches[tau - 1].lower[0], patch.lower[0], patch.upper[0], patches[tau + 1].upper[0]}},
          {{means[tau - 1], means[tau], means[tau + 1]}})
          .maximum());
    else
      for (const auto &s : {patch.lower, patch.centre(), patch.upper})
        compare({s[0], -recovered(tau, s)});
  }
  return peak;
}

// The largest contact pressure on rectangles.

namespace
{
/** A pressure at a point of a side. */
struct PressureAt
{
  Point<2> s;
  double value;
};

/** Returns whether a material is its own mirror image in a plane at right angles to an axis:
 * entries of Hooke's tensor with an odd number of indices of this axis vanish. */
bool is_symmetric(const SymmetricTensor<4, 3> &E, const unsigned int axis)
{
  const double negligible = 1e-12 * E.norm();
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j < 3; ++j)
      for (unsigned int k = 0; k < 3; ++k)
        for (unsigned int l = 0; l < 3; ++l)
          if (((i == axis) + (j == axis) + (k == axis) + (l == axis)) % 2 == 1 &&
              std::abs(E[i][j][k][l]) > negligible)
            return false;
  return true;
}

/** Returns whether a roller meets the contact side at a point of its edge. Then the body with its
 * mirror image is a body of twice the size, and the pressure goes on symmetrically. */
bool is_mirror(const Scene<3> &scene, const Point<3> &x)
{
  const double rounding = 1e-9 * scene.geometry.diameter();
  for (unsigned int i = 0; i < scene.boundary.size(); ++i)
  {
    const Side<3> &side = scene.geometry.sides[i];
    const Tensor<1, 3> n = side.normal(Point<2>());
    if (scene.boundary[i].role != Role::roller ||
        std::abs((x - side.point(Point<2>())) * n) > rounding)
      continue;
    unsigned int axis = 0;
    for (unsigned int d = 1; d < 3; ++d)
      if (std::abs(n[d]) > std::abs(n[axis]))
        axis = d;
    return is_symmetric(scene.material->relative_hooke(x), axis);
  }
  return false;
}

/** Whether the edges before the first and behind the last patch are mirrors, by direction. */
using Mirrors = std::array<std::array<bool, 2>, 2>;

Mirrors mirrors_of(const PatchGrid &grid, const Scene<3> &scene)
{
  const Side<3> &side = scene.geometry.sides[grid.side];
  Mirrors mirrors;
  for (unsigned int d = 0; d < 2; ++d)
    for (unsigned int end = 0; end < 2; ++end)
    {
      Point<2> s(0.5 * (grid.ends[0].front() + grid.ends[0].back()),
                 0.5 * (grid.ends[1].front() + grid.ends[1].back()));
      s[d] = end == 0 ? grid.ends[d].front() : grid.ends[d].back();
      mirrors[d][end] = is_mirror(scene, side.point(s));
    }
  return mirrors;
}

/** Returns the parabola along coordinate @p d over patch @p index with its own mean and those of
 * its neighbours, which a mirror may take the place of; none where a neighbour is missing or does
 * not press. */
std::optional<MeanParabola> parabola_along(const PatchGrid &grid,
                                           const Mirrors &mirrors,
                                           const Pressure &P,
                                           const unsigned int d,
                                           const std::array<unsigned int, 2> &index)
{
  const double threshold = pressing_threshold(P);
  const std::vector<double> &ends = grid.ends[d];
  const unsigned int i = index[d], n = grid.n(d);
  const auto mean = [&](const unsigned int k) {
    std::array<unsigned int, 2> other = index;
    other[d] = k;
    return P[grid.at(other[0], other[1])];
  };
  if ((i == 0 && !mirrors[d][0]) || (i + 1 == n && !mirrors[d][1]))
    return {};
  const double before = mean(i == 0 ? 0 : i - 1), after = mean(i + 1 == n ? i : i + 1);
  if (!(before < threshold) || !(after < threshold))
    return {};
  return MeanParabola({{i == 0 ? 2. * ends[0] - ends[1] : ends[i - 1],
                        ends[i],
                        ends[i + 1],
                        i + 1 == n ? 2. * ends[n] - ends[n - 1] : ends[i + 2]}},
                      {{-before, -mean(i), -after}});
}
/** Returns the middle and the ends of an interval. A line that is continued to a mirror would have
 * a kink there: such an end is left out. */
std::vector<double> positions_on(const PatchGrid &grid,
                                 const Mirrors &mirrors,
                                 const unsigned int d,
                                 const unsigned int i)
{
  std::vector<double> positions = {grid.middle(d, i)};
  if (i > 0 || !mirrors[d][0])
    positions.push_back(grid.ends[d][i]);
  if (i + 1 < grid.n(d) || !mirrors[d][1])
    positions.push_back(grid.ends[d][i + 1]);
  return positions;
}
} // namespace

std::optional<PressureMaximum> peak_pressure(const MultiplierSpace<3> &multipliers,
                                             const Pressure &P,
                                             const std::vector<SingularPlace<3>> &outside_of)
{
  const ContactSurface<3> &surface = multipliers.surface();
  const double threshold = pressing_threshold(P);
  const RecoveredPressure<3> recovered(multipliers, P);
  std::optional<PressureMaximum> peak;
  const auto compare = [&](const unsigned int tau, const PressureAt &candidate) {
    // Of equal peaks (a symmetric body may have two) the first one is taken, independent of
    // rounding.
    constexpr double larger = 1. + 1e-9;
    const Patch<3> &patch = surface.patches()[tau];
    const Side<3> &side = surface.side(patch);
    const Point<3> x = side.point(candidate.s);
    if ((!peak || candidate.value > larger * peak->value) && !any_contains(outside_of, x))
      peak = {candidate.value, {side.name(), 0., x}, -P[tau], {}};
  };
  for (const PatchGrid &grid : patch_grids(surface.patches()))
  {
    const Mirrors mirrors = mirrors_of(grid, surface.scene());
    for (unsigned int j = 0; j < grid.n(1); ++j)
      for (unsigned int i = 0; i < grid.n(0); ++i)
      {
        const unsigned int tau = grid.at(i, j);
        if (!(P[tau] < threshold))
          continue;
        const auto along_x = parabola_along(grid, mirrors, P, 0, {{i, j}});
        const auto along_y = parabola_along(grid, mirrors, P, 1, {{i, j}});
        if (along_x && along_y)
        {
          const MeanParabola::Value x = along_x->maximum_with_ends(),
                                    y = along_y->maximum_with_ends();
          compare(tau, {{x.s, y.s}, x.value + y.value + P[tau]});
        }
        else
          for (const double t : positions_on(grid, mirrors, 1, j))
            for (const double r : positions_on(grid, mirrors, 0, i))
              compare(tau, {{r, t}, -recovered(tau, {r, t})});
      }
  }
  return peak;
}

// Contact zones and peak of a pressure that is a polynomial on every patch.

namespace
{
/** A point of a patch with -p_H there. */
struct PointOfPressure
{
  double s, pressure;
};

/** Returns the maximum between two points, by golden sections, of a function with one maximum
 * there. */
PointOfPressure golden_maximum(const std::function<double(double)> &f, double low, double high)
{
  const double ratio = 0.5 * (std::sqrt(5.) - 1.);
  double left = high - ratio * (high - low), right = low + ratio * (high - low);
  double f_left = f(left), f_right = f(right);
  // The value is that of the maximum to rounding when the interval is shorter by the root of it.
  constexpr unsigned int n_sections = 40;
  for (unsigned int i = 0; i < n_sections; ++i)
    if (f_left < f_right)
    {
      low = left;
      left = right;
      f_left = f_right;
      right = low + ratio * (high - low);
      f_right = f(right);
    }
    else
    {
      high = right;
      right = left;
      f_right = f_left;
      left = high - ratio * (high - low);
      f_left = f(left);
    }
  return f_left > f_right ? PointOfPressure{left, f_left} : PointOfPressure{right, f_right};
}

/** Returns the maximum of -p_H on a patch outside of given places: the best of many points, then
 * between its neighbours; none where the patch lies in one of the places. */
std::optional<PointOfPressure> max_on_patch(const unsigned int patch,
                                            const MultiplierSpace<2> &multipliers,
                                            const Pressure &P,
                                            const std::vector<SingularPlace<2>> &outside_of)
{
  const Patch<2> &tau = multipliers.surface().patches()[patch];
  const Side<2> &side = multipliers.surface().side(tau);
  const auto pressure = [&](const double s) { return -multipliers.value(P, patch, Point<1>(s)); };
  const bool is_constant = multipliers.n_of(patch) == 1;
  const unsigned int n_intervals = 16 * multipliers.n_of(patch);
  const double step = tau.measure / n_intervals;
  std::optional<PointOfPressure> best;
  for (unsigned int i = 0; i <= (is_constant ? 0 : n_intervals); ++i)
  {
    const double s = is_constant        ? tau.centre()[0]
                     : i == n_intervals ? tau.upper[0]
                                        : tau.lower[0] + i * step;
    if ((!best || pressure(s) > best->pressure) && !any_contains(outside_of, side.point(s)))
      best = {s, pressure(s)};
  }
  if (!best || is_constant)
    return best;
  const PointOfPressure inner = golden_maximum(
    pressure, std::max(best->s - step, tau.lower[0]), std::min(best->s + step, tau.upper[0]));
  return inner.pressure > best->pressure && !any_contains(outside_of, side.point(inner.s)) ? inner
                                                                                           : best;
}

/** Returns -∫ p_H / |τ|. */
double mean_pressure(const unsigned int patch,
                     const MultiplierSpace<2> &multipliers,
                     const Pressure &P,
                     const dealii::Vector<double> &integrals)
{
  double force = 0.;
  for (unsigned int k = multipliers.first_of(patch); k < multipliers.first_of(patch + 1); ++k)
    force -= P[k] * integrals[k];
  return force / multipliers.surface().patches()[patch].measure;
}
} // namespace

std::vector<ContactZone> zones_of_polynomial(const MultiplierSpace<2> &multipliers,
                                             const Pressure &P)
{
  const ContactSurface<2> &surface = multipliers.surface();
  std::vector<ContactZone> zones;
  for (const PressedInterval &interval : pressed_intervals(multipliers, P))
  {
    const auto on_side = [&](const Patch<2> &patch) { return patch.side == interval.side; };
    const Side<2> &side =
      surface.side(*std::find_if(surface.patches().begin(), surface.patches().end(), on_side));
    const auto zone_end = [&](const PressedInterval::End &end) {
      // The end of a side stays its end, also where that is the start again.
      const double s = end.s > side.length() ? end.s - side.length() : end.s;
      return ZoneEnd{{side.name(), s, side.point(s)}, end.uncertainty};
    };
    zones.push_back({zone_end(interval.start), zone_end(interval.end), interval.length()});
  }
  return zones;
}

std::optional<PressureMaximum> peak_of_polynomial(const MultiplierSpace<2> &multipliers,
                                                  const Pressure &P,
                                                  const std::vector<SingularPlace<2>> &outside_of)
{
  // Of equal peaks (a symmetric body may have two) the first one is taken, independent of rounding.
  constexpr double larger = 1. + 1e-9;
  const ContactSurface<2> &surface = multipliers.surface();
  const double threshold = pressing_threshold(P);
  const dealii::Vector<double> integrals = multipliers.integrals();
  std::optional<PressureMaximum> peak;
  for (unsigned int patch = 0; patch < surface.patches().size(); ++patch)
  {
    bool presses = false;
    for (unsigned int k = multipliers.first_of(patch); k < multipliers.first_of(patch + 1); ++k)
      presses = presses || P[k] < threshold;
    if (!presses)
      continue;
    const std::optional<PointOfPressure> point = max_on_patch(patch, multipliers, P, outside_of);
    if (!point || (peak && !(point->pressure > larger * peak->value)))
      continue;
    const Patch<2> &tau = surface.patches()[patch];
    const Side<2> &side = surface.side(tau);
    peak = {point->pressure,
            {side.name(), point->s, side.point(point->s)},
            mean_pressure(patch, multipliers, P, integrals),
            {tau.measure, multipliers.n_of(patch)}};
  }
  return peak;
}
} // namespace Signorini
