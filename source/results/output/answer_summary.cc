// SPDX-License-Identifier: LGPL-2.1-or-later
// The trends of the maxima in an answer, for its lines on the screen and for answer.json.

#include "answer_summary.h"

#include <signorini/base/text.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace Signorini {
namespace {
const AnswerVector &point_of(const PressureMaximum &peak) {
  return peak.at.point;
}
const AnswerVector &point_of(const FieldMaximum &stress) {
  return stress.point;
}

/** Returns whether two maxima lie on the same cell, as far as its size, its degree and the point
 * show. */
template <typename Maximum>
bool share_mesh(const Maximum &a, const Maximum &b) {
  return a.mesh.degree == b.mesh.degree &&
         std::abs(a.mesh.size - b.mesh.size) < 1e-6 * a.mesh.size &&
         point_of(a).distance(point_of(b)) < a.mesh.size;
}

/** Returns whether every contact zone is longer than three times the uncertainty of its ends. One
 * of a patch or two has not shown its pressures and stresses yet. */
bool resolves_zones(const Answer &answer) {
  return std::all_of(answer.zones.begin(), answer.zones.end(), [](const ContactZone &zone) {
    return zone.length >= 3. * std::max(zone.start.uncertainty, zone.end.uncertainty);
  });
}

/** Returns the trend of a maximum of all levels; unknown where the finest one has none. Where the
 * finest level is not @p is_resolved, a maximum is not settled. */
template <typename Maximum>
Trend trend_over(const std::vector<std::optional<Maximum>> &maxima, const bool is_unlimited,
                 const bool is_resolved = true) {
  if (!maxima.back())
    return {};
  std::vector<std::optional<double>> values;
  for (const std::optional<Maximum> &maximum : maxima)
    values.push_back(maximum ? std::optional(maximum->value) : std::nullopt);
  Trend trend = trend_of(values);
  const std::size_t n = maxima.size();
  if (is_unlimited)
    trend.kind = Trend::Kind::unlimited;
  else if (n > 1 && maxima[n - 2] && share_mesh(*maxima[n - 1], *maxima[n - 2]))
    trend.kind = Trend::Kind::not_refined;
  else if (!is_resolved && trend.kind == Trend::Kind::settled)
    trend.kind = Trend::Kind::not_settled;
  return trend;
}

/** Returns the trends of a PeakPressure or VonMises. */
template <typename Maximum>
MaximumTrends trends_over(const std::vector<LevelRecord> &levels,
                          const std::function<std::optional<Maximum>(const Answer &)> &of) {
  std::vector<std::optional<Maximum>> all;
  std::vector<decltype(Maximum::away)> away;
  for (const LevelRecord &level : levels) {
    all.push_back(of(level.answer));
    away.push_back(all.back() ? all.back()->away : std::nullopt);
  }
  const bool is_resolved = resolves_zones(levels.back().answer);
  return {trend_over(all, all.back() && all.back()->grows_at, is_resolved),
          trend_over(away, false, is_resolved)};
}
} // namespace

AnswerSummary::AnswerSummary(const std::vector<LevelRecord> &levels)
  : level(levels.back())
  , peak_pressure(
      trends_over<PeakPressure>(levels, [](const Answer &a) { return a.peak_pressure; }))
  , von_mises(trends_over<VonMises>(levels, [](const Answer &a) { return a.von_mises; })) {
  for (std::size_t i = 0; i < level.answer.reports.size(); ++i) {
    const ProbeReport &report = level.answer.reports[i];
    reports.emplace_back();
    for (std::size_t k = 0; k < report.extremes.size(); ++k) {
      std::vector<std::optional<FieldMaximum>> values;
      for (const LevelRecord &each : levels) {
        const std::vector<FieldMaximum> &extremes = each.answer.reports[i].extremes;
        values.push_back(extremes.empty() ? std::nullopt : std::optional(extremes[k]));
      }
      reports[i].push_back(trend_over(values, report.rows.size() == 1 && !report.growth.empty()));
    }
  }
  if (level.tangential && level.contact.active > 0 && level.contact.normal_force != 0.)
    tangential_ratio = level.tangential->tangential_force / level.contact.normal_force;
  for (const LevelRecord &each : levels)
    seconds += each.times.total();
}

std::vector<std::pair<std::string, double>> values_at_point(const ProbeReport &report,
                                                            const unsigned int dimension) {
  std::vector<std::pair<std::string, double>> values;
  const std::vector<std::string> names = split_list(report_header(dimension), ',');
  for (std::size_t k = 1; k + n_report_fields < names.size() && report.rows.size() == 1; ++k)
    values.emplace_back(names[k], report.rows[0][k]);
  return values;
}
} // namespace Signorini
