// SPDX-License-Identifier: LGPL-2.1-or-later
// answer.json: the answer of the finest level, for programs to read.

#include <signorini/results/files/answer_output.h>
#include <signorini/results/files/tables.h>
#include <signorini/results/verdict/judge.h>

#include <nlohmann/json.hpp>

#include "answer_output_internal.h"

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

/** Returns a maximum, the place where it grows without limit, and the maximum away from such
 * places. */
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

// certificate.json: how well each level satisfies (5), for programs to read.

namespace
{
using Json = nlohmann::ordered_json;

Json number(const std::optional<double> &value)
{
  return value ? Json(*value) : Json(nullptr);
}

Json describe(const ErrorBound &bound)
{
  return {{"absolute", number(bound.absolute)},
          {"relative", number(bound.relative)},
          {"mesh", number(bound.mesh)},
          {"oscillation", number(bound.oscillation)},
          {"contact", number(bound.contact)},
          {"geometry", number(bound.geometry)},
          {"guaranteed", bound.absolute.has_value() && bound.guaranteed},
          {"algebra", number(bound.algebra)},
          {"post_absolute", number(bound.post_absolute)},
          {"post_relative", number(bound.post_relative)},
          {"energy", {number(bound.energy_lower), number(bound.energy_upper)}},
          {"contact_force_error", number(bound.force_error)},
          {"max_penetration", bound.penetration},
          {"place_of_penetration", bound.place_of_penetration},
          {"largest_cell", bound.largest_cell},
          {"largest_contact_face", bound.worst_face},
          {"missing", bound.missing}};
}

Json describe(const LevelRecord &level, const Judge &judge)
{
  const Certificate &c = level.certificate;
  return {{"level", level.sizes.level},
          {"stationarity", c.stationarity},
          {"penetration", c.penetration},
          {"sign", c.sign},
          {"complementarity", c.complementarity},
          {"duality_gap", c.duality_gap},
          {"force_balance", c.force_balance},
          {"motion_balance", c.motion_balance},
          {"support", c.support},
          {"moment_balance", c.moment_balance},
          {"moment_balance_is_exact", c.moments_are_exact},
          {"inf_sup", level.inf_sup ? Json(*level.inf_sup) : Json(nullptr)},
          {"degenerate_patches", c.degenerate_patches},
          {"kkt", level.dual.kkt},
          {"linear_solves", level.linear.solves},
          {"linear_residual", level.linear.residual},
          {"rounding_error", rounding(level)},
          {"residual_bound", judge.residual_bound(level)},
          {"unique", level.dual.unique},
          {"contact_solver_replaced",
           level.dual.active_set_failure.has_value() || level.dual.stalled.has_value() ||
             level.dual.failure_of_cycles.has_value()},
          {"bound", level.bound ? describe(*level.bound) : Json(nullptr)},
          {"certified", judge.accepts(level)}};
}
} // namespace

void write_certificate(std::ostream &stream,
                       const std::vector<LevelRecord> &levels,
                       const Judge &judge,
                       const StudyVerdict &verdict)
{
  Json rows = Json::array();
  for (const LevelRecord &level : levels)
    rows.push_back(describe(level, judge));
  Json certificate = {{"verdict", word_for(verdict.outcome)},
                      {"tolerance", judge.tolerance()},
                      {"residual_bound", verdict.residual_bound},
                      {"accuracy", verdict.accuracy},
                      {"levels", rows}};
  if (!verdict.reason.empty())
    certificate["failure"] = verdict.reason;
  stream << certificate.dump(2) << "\n";
}
} // namespace Signorini
