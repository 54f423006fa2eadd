// SPDX-License-Identifier: LGPL-2.1-or-later
// The largest contact pressure on rectangles.

#include <signorini/answer/peak_pressure.h>
#include <signorini/postprocess/contact_pressure.h>

#include <array>

#include "mean_parabola.h"

namespace Signorini
{
namespace
{
/** A pressure at a point of a side. */
struct PressureAt
{
  dealii::Point<2> s;
  double value;
};

/** The parabola over interval i of a coordinate with the means of its neighbours and its own. */
MeanParabola parabola_along(const PatchGrid &grid,
                            const unsigned int d,
                            const unsigned int i,
                            const std::array<double, 3> &means)
{
  const std::vector<double> &ends = grid.ends[d];
  return MeanParabola({{ends[i - 1], ends[i], ends[i + 1], ends[i + 2]}}, means);
}
} // namespace

std::optional<PeakPressure> peak_pressure(const MultiplierSpace<3> &multipliers,
                                          const dealii::Vector<double> &P)
{
  const ContactSurface<3> &surface = multipliers.surface();
  const double threshold = pressing_threshold(P);
  const RecoveredPressure<3> recovered(multipliers, P);
  std::optional<PeakPressure> peak;
  const auto compare = [&](const unsigned int tau, const PressureAt &candidate) {
    // Of equal peaks (a symmetric body may have two) the first, whatever rounding makes of them.
    constexpr double larger = 1. + 1e-9;
    if (!peak || candidate.value > larger * peak->value)
    {
      const Side<3> &side = surface.side(surface.patches()[tau]);
      peak = {candidate.value, {side.name(), 0., side.point(candidate.s)}, -P[tau]};
    }
  };
  for (const PatchGrid &grid : patch_grids(surface.patches()))
    for (unsigned int j = 0; j < grid.n(1); ++j)
      for (unsigned int i = 0; i < grid.n(0); ++i)
      {
        const unsigned int tau = grid.at(i, j);
        const auto presses = [&](const unsigned int k, const unsigned int l) {
          return k < grid.n(0) && l < grid.n(1) && P[grid.at(k, l)] < threshold;
        };
        if (!presses(i, j))
          continue;
        // Numbers below zero are large ones.
        if (presses(i - 1, j) && presses(i + 1, j) && presses(i, j - 1) && presses(i, j + 1))
        {
          const auto mean = [&](const unsigned int k, const unsigned int l) {
            return -P[grid.at(k, l)];
          };
          const auto x =
            parabola_along(grid, 0, i, {{mean(i - 1, j), mean(i, j), mean(i + 1, j)}}).maximum();
          const auto y =
            parabola_along(grid, 1, j, {{mean(i, j - 1), mean(i, j), mean(i, j + 1)}}).maximum();
          compare(tau, {{x.s, y.s}, x.value + y.value - mean(i, j)});
        }
        else
          for (const double t : {grid.ends[1][j], grid.middle(1, j), grid.ends[1][j + 1]})
            for (const double r : {grid.ends[0][i], grid.middle(0, i), grid.ends[0][i + 1]})
              compare(tau, {{r, t}, -recovered(tau, {r, t})});
      }
  return peak;
}
} // namespace Signorini
