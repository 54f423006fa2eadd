// SPDX-License-Identifier: LGPL-2.1-or-later
// Contact zones and peak of a pressure that is a polynomial on every patch.

#include "polynomial_answer.h"

#include <signorini/postprocess/contact_pressure.h>
#include <signorini/postprocess/pressed_intervals.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

namespace Signorini
{
namespace
{
/** A point of a patch with -p_H there. */
struct PointOfPressure
{
  double s, pressure;
};

/** The maximum between two points, by golden sections: of a function with one maximum there. */
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

/** The maximum of -p_H on a patch outside of given places: the best of many points, then between
 * its neighbours. Nothing where the patch lies in one of them. */
std::optional<PointOfPressure> largest_on(const unsigned int patch,
                                          const MultiplierSpace<2> &multipliers,
                                          const dealii::Vector<double> &P,
                                          const std::vector<SingularPlace<2>> &outside_of)
{
  const Patch<2> &tau = multipliers.surface().patches()[patch];
  const Side<2> &side = multipliers.surface().side(tau);
  const auto pressure = [&](const double s) {
    return -multipliers.value(P, patch, dealii::Point<1>(s));
  };
  const bool is_constant = multipliers.unknowns_on(patch).size() == 1;
  const unsigned int n_intervals = 16 * multipliers.unknowns_on(patch).size();
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

/** -int p_H / |tau|. */
double mean_pressure(const unsigned int patch,
                     const MultiplierSpace<2> &multipliers,
                     const dealii::Vector<double> &P,
                     const dealii::Vector<double> &integrals)
{
  double force = 0.;
  for (unsigned int k = multipliers.first_of(patch); k < multipliers.first_of(patch + 1); ++k)
    force -= P[k] * integrals[k];
  return force / multipliers.surface().patches()[patch].measure;
}
} // namespace

std::vector<ContactZone> zones_of_polynomial(const MultiplierSpace<2> &multipliers,
                                             const dealii::Vector<double> &P)
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
                                                  const dealii::Vector<double> &P,
                                                  const std::vector<SingularPlace<2>> &outside_of)
{
  // Of equal peaks (a symmetric body may have two) the first, whatever rounding makes of them.
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
    const std::optional<PointOfPressure> point = largest_on(patch, multipliers, P, outside_of);
    if (!point || (peak && !(point->pressure > larger * peak->value)))
      continue;
    const Patch<2> &tau = surface.patches()[patch];
    const Side<2> &side = surface.side(tau);
    peak = {point->pressure,
            {side.name(), point->s, side.point(point->s)},
            mean_pressure(patch, multipliers, P, integrals),
            {tau.measure, static_cast<unsigned int>(multipliers.unknowns_on(patch).size())}};
  }
  return peak;
}
} // namespace Signorini
