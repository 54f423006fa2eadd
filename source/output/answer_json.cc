// SPDX-License-Identifier: LGPL-2.1-or-later
// answer.json: the answer of the finest level, for programs to read.

#include <signorini/answer/trend.h>
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

void add_trend(const std::vector<std::optional<double>> &values, AnswerJson &json)
{
  const Trend trend = trend_of(values);
  json["change"] = optional_number(trend.change);
  json["trend"] = word_for(trend.kind);
}

AnswerJson peak_of(const std::vector<LevelRecord> &levels)
{
  const std::optional<PeakPressure> &peak = levels.back().answer.peak_pressure;
  if (!peak)
    return nullptr;
  AnswerJson json = {{"value", peak->value}};
  json.update(describe(peak->place));
  json["mean"] = peak->mean;
  add_trend(over_levels(levels, "peak_pressure"), json);
  return json;
}

AnswerJson von_mises_of(const std::vector<LevelRecord> &levels)
{
  const VonMises &stress = levels.back().answer.von_mises;
  AnswerJson json = {{"value", stress.value}, {"point", components(stress.point)}};
  add_trend(over_levels(levels, "largest_von_mises"), json);
  return json;
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
