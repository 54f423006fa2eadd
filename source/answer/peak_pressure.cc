// SPDX-License-Identifier: LGPL-2.1-or-later
// The largest contact pressure, as a point value and not as a mean.

#include <signorini/answer/peak_pressure.h>
#include <signorini/postprocess/contact_pressure.h>

#include "mean_parabola.h"
#include "polynomial_answer.h"

namespace Signorini
{
std::optional<PressureMaximum> peak_pressure(const MultiplierSpace<2> &multipliers,
                                             const dealii::Vector<double> &P,
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
    // Of equal peaks (a symmetric body may have two) the first, whatever rounding makes of them.
    constexpr double larger = 1. + 1e-9;
    const auto compare = [&](const MeanParabola::Value &candidate) {
      const Side<2> &side = surface.side(patch);
      const dealii::Point<2> x = side.point(candidate.s);
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
} // namespace Signorini
