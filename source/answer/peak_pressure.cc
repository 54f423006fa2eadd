// SPDX-License-Identifier: LGPL-2.1-or-later
// The largest contact pressure, as a point value and not as a mean.

#include <signorini/answer/peak_pressure.h>
#include <signorini/postprocess/contact_pressure.h>

#include <array>

#include "polynomial_answer.h"

namespace Signorini
{
namespace
{
/** A function at a point. */
struct Value
{
  double s, value;
};

/** The parabola with given means over three intervals that follow one another. */
class Parabola
{
public:
  /** @param patches in the order of arc length. */
  Parabola(const std::array<const Patch<2> *, 3> &patches, const std::array<double, 3> &means)
    : from_(patches[1]->lower[0])
    , to_(patches[1]->upper[0])
  {
    // With the primitive's divided differences over the four ends e_0 < ... < e_3, from e_1.
    const std::array<double, 4> e = {
      {patches[0]->lower[0] - from_, 0., to_ - from_, patches[2]->upper[0] - from_}};
    const double first = (means[1] - means[0]) / (e[2] - e[0]);
    const double second = ((means[2] - means[1]) / (e[3] - e[1]) - first) / (e[3] - e[0]);
    // d/ds of (s-e0) m0 + (s-e0)(s-e1) first + (s-e0)(s-e1)(s-e2) second.
    curvature_ = 3. * second;
    slope_ = 2. * first - 2. * second * (e[0] + e[1] + e[2]);
    constant_ =
      means[0] - first * (e[0] + e[1]) + second * (e[0] * e[1] + e[0] * e[2] + e[1] * e[2]);
  }
  /** Its maximum if that lies in the middle interval, else the value in its middle: where the
   * parabola is monotone, a neighbour has a larger value. */
  Value maximum() const
  {
    const double top = curvature_ < 0. ? from_ - slope_ / (2. * curvature_) : from_;
    return at(top > from_ && top < to_ ? top : 0.5 * (from_ + to_));
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
} // namespace

std::optional<PeakPressure> peak_pressure(const MultiplierSpace<2> &multipliers,
                                          const dealii::Vector<double> &P)
{
  if (!multipliers.is_piecewise_constant())
    return peak_of_polynomial(multipliers, P);
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
  std::optional<PeakPressure> peak;
  for (std::size_t tau = 0; tau < patches.size(); ++tau)
  {
    const Patch<2> &patch = patches[tau];
    if (!presses(tau, patch.side))
      continue;
    // Of equal peaks (a symmetric body may have two) the first, whatever rounding makes of them.
    constexpr double larger = 1. + 1e-9;
    const auto compare = [&](const Value &candidate) {
      if (!peak || candidate.value > larger * peak->value)
      {
        const Side<2> &side = surface.side(patch);
        peak = {candidate.value, {side.name(), candidate.s, side.point(candidate.s)}, means[tau]};
      }
    };
    const bool has_corner = surface.side(patch).has_corner(patch.lower[0]) ||
                            surface.side(patch).has_corner(patch.upper[0]);
    if (tau > 0 && presses(tau - 1, patch.side) && presses(tau + 1, patch.side) && !has_corner)
      compare(Parabola({{&patches[tau - 1], &patch, &patches[tau + 1]}},
                       {{means[tau - 1], means[tau], means[tau + 1]}})
                .maximum());
    else
      for (const auto &s : {patch.lower, patch.centre(), patch.upper})
        compare({s[0], -recovered(tau, s)});
  }
  return peak;
}
} // namespace Signorini
