// SPDX-License-Identifier: LGPL-2.1-or-later
// answer.json: the answer of the finest level, for programs to read.

#include <signorini/output/answer_output.h>

#include <nlohmann/json.hpp>

#include "answer_trends.h"

namespace Signorini
{
namespace
{
using AnswerJson = nlohmann::ordered_json;

AnswerJson optional_number(const std::optional<double> &value)
{
  return value ? AnswerJson(*value) : AnswerJson(nullptr);
}

AnswerJson components(const AnswerVector &x)
{
  return x.values();
}

AnswerJson describe(const BoundaryPlace &place)
{
  AnswerJson json = {{"side", place.side}};
  if (place.point.size() == 2)
    json["arc_length"] = place.arc_length;
  json["point"] = components(place.point);
  return json;
}

AnswerJson describe(const SideForce &force)
{
  AnswerJson json;
  if (!force.side.empty())
    json["side"] = force.side;
  json["force"] = components(force.resultant.force);
  const AnswerVector &moment = force.resultant.moment;
  json["moment"] = moment.size() == 1 ? AnswerJson(moment[0]) : components(moment);
  json["through"] = force.through ? components(*force.through) : AnswerJson(nullptr);
  return json;
}

AnswerJson describe(const std::vector<SideForce> &forces)
{
  AnswerJson json = AnswerJson::array();
  for (const SideForce &force : forces)
    json.push_back(describe(force));
  return json;
}

AnswerJson describe(const ZoneEnd &end)
{
  AnswerJson json = describe(end.place);
  json["uncertainty"] = end.uncertainty;
  return json;
}

AnswerJson describe(const PressureMaximum &peak)
{
  AnswerJson json = {{"value", peak.value}};
  json.update(describe(peak.place));
  json["mean"] = peak.mean;
  return json;
}

AnswerJson describe(const StressMaximum &stress)
{
  return {{"value", stress.value}, {"point", components(stress.point)}};
}

AnswerJson describe(const GrowthPlace &place, const unsigned int dimension)
{
  AnswerJson json;
  if (dimension == 2)
    json["point"] = components(place.ends[0]);
  else
    json["ends"] = {components(place.ends[0]), components(place.ends[1])};
  json["radius"] = place.radius;
  return json;
}

/** A maximum, where it grows without limit, and the maximum away from such places. */
template <typename Maximum>
AnswerJson describe(const Maximum &maximum,
                    const MaximumTrends &trends,
                    const unsigned int dimension)
{
  const auto with_trend = [](AnswerJson json, const Trend &trend) {
    json["change"] = optional_number(trend.change);
    json["trend"] = word_for(trend.kind);
    return json;
  };
  AnswerJson json = with_trend(describe(maximum), trends.largest);
  json["grows_at"] =
    maximum.grows_at ? describe(*maximum.grows_at, dimension) : AnswerJson(nullptr);
  json["away"] = maximum.away ? with_trend(describe(*maximum.away), trends.away) : nullptr;
  return json;
}

AnswerJson peak_of(const std::vector<LevelRecord> &levels)
{
  const Answer &answer = levels.back().answer;
  if (!answer.peak_pressure)
    return nullptr;
  return describe(*answer.peak_pressure, trends_of_peak(levels), answer.dimension);
}

AnswerJson von_mises_of(const std::vector<LevelRecord> &levels)
{
  const Answer &answer = levels.back().answer;
  return describe(answer.von_mises, trends_of_stress(levels), answer.dimension);
}

AnswerJson zones_of(const Answer &answer)
{
  AnswerJson json = AnswerJson::array();
  for (const ContactZone &zone : answer.zones)
    json.push_back(
      {{"start", describe(zone.start)}, {"end", describe(zone.end)}, {"length", zone.length}});
  return json;
}

AnswerJson plates_of(const MotionRecord &motions)
{
  AnswerJson json = AnswerJson::array();
  for (const PlateRecord &plate : motions.plates)
    json.push_back({{"side", plate.side},
                    {"direction", components(plate.plate.direction)},
                    {"travel", plate.motion.travel},
                    {"force", plate.force},
                    {"centre", components(plate.plate.centre)},
                    {"rotation", plate.motion.rotation},
                    {"moment", plate.moment}});
  return json;
}

AnswerJson penetration_of(const Answer &answer)
{
  if (!answer.penetration)
    return nullptr;
  AnswerJson json = {{"value", answer.penetration->value}};
  json.update(describe(answer.penetration->place));
  return json;
}
} // namespace

void write_answer(std::ostream &stream,
                  const std::vector<LevelRecord> &levels,
                  const StudyVerdict &verdict)
{
  const LevelRecord &finest = levels.back();
  const Answer &answer = finest.answer;
  const ErrorBound bound = finest.bound.value_or(ErrorBound());
  AnswerJson total = describe(answer.contact_force);
  total["error"] = optional_number(bound.force_error);
  AnswerJson json = {{"level", finest.sizes.level},
                     {"verdict", word_for(verdict.outcome)},
                     {"accuracy", verdict.accuracy},
                     {"contact_force", total},
                     {"contact_by_side", describe(answer.contact_by_side)},
                     {"reactions", describe(answer.reactions)},
                     {"plates", plates_of(finest.motions)},
                     {"undetermined_motions", finest.motions.undetermined},
                     {"peak_pressure", peak_of(levels)},
                     {"contact_zones", zones_of(answer)},
                     {"penetration", penetration_of(answer)},
                     {"von_mises", von_mises_of(levels)},
                     {"strained_share", answer.von_mises.strained_share},
                     {"energy",
                      {{"value", finest.certificate.energy},
                       {"lower", optional_number(bound.energy_lower)},
                       {"upper", optional_number(bound.energy_upper)}}},
                     {"seconds", total_seconds(levels)}};
  if (answer.dimension == 3)
    json["contact_area"] = finest.contact.length;
  stream << json.dump(2) << "\n";
}
} // namespace Signorini
