// SPDX-License-Identifier: LGPL-2.1-or-later
// Numbers of the answer over the levels.

#include "answer_trends.h"

#include <cmath>

namespace Signorini
{
namespace
{
const AnswerVector &point_of(const PressureMaximum &peak)
{
  return peak.place.point;
}
const AnswerVector &point_of(const StressMaximum &stress)
{
  return stress.point;
}

/** Whether two maxima lie on the same cell, as far as its size, its degree and the place tell. */
template <typename Maximum>
bool share_mesh(const Maximum &a, const Maximum &b)
{
  return a.mesh.degree == b.mesh.degree &&
         std::abs(a.mesh.size - b.mesh.size) < 1e-6 * a.mesh.size &&
         point_of(a).distance(point_of(b)) < a.mesh.size;
}

template <typename Maximum>
Trend trend_of_maxima(const std::vector<std::optional<Maximum>> &maxima)
{
  std::vector<std::optional<double>> values;
  for (const std::optional<Maximum> &maximum : maxima)
    values.push_back(maximum ? std::optional<double>(maximum->value) : std::nullopt);
  Trend trend = trend_of(values);
  const std::size_t n = maxima.size();
  if (n > 1 && maxima[n - 1] && maxima[n - 2] && share_mesh(*maxima[n - 1], *maxima[n - 2]))
    trend.kind = Trend::Kind::not_refined;
  return trend;
}

/** @param of the optional Peak or VonMises of a level. */
template <typename Maximum, typename Get>
MaximumTrends trends_of(const std::vector<LevelRecord> &levels, const Get &of)
{
  std::vector<std::optional<Maximum>> largest, away;
  for (const LevelRecord &level : levels)
  {
    const auto maximum = of(level.answer);
    largest.push_back(maximum ? std::optional<Maximum>(*maximum) : std::nullopt);
    away.push_back(maximum ? maximum->away : std::nullopt);
  }
  MaximumTrends trends = {trend_of_maxima(largest), trend_of_maxima(away)};
  const auto finest = of(levels.back().answer);
  if (finest && finest->grows_at)
    trends.largest.kind = Trend::Kind::unlimited;
  return trends;
}
} // namespace

MaximumTrends trends_of_peak(const std::vector<LevelRecord> &levels)
{
  return trends_of<PressureMaximum>(levels,
                                    [](const Answer &answer) { return answer.peak_pressure; });
}

MaximumTrends trends_of_stress(const std::vector<LevelRecord> &levels)
{
  return trends_of<StressMaximum>(
    levels, [](const Answer &answer) { return std::optional<VonMises>(answer.von_mises); });
}

double total_seconds(const std::vector<LevelRecord> &levels)
{
  double seconds = 0.;
  for (const LevelRecord &level : levels)
    seconds += level.times.total();
  return seconds;
}
} // namespace Signorini
