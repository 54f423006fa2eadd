// SPDX-License-Identifier: LGPL-2.1-or-later
// answer.json, and certificate.json with the residuals of (5) on each level, for programs to read.

#include <signorini/results/output/answer_output.h>
#include <signorini/results/output/tables.h>
#include <signorini/results/verdict/judge.h>

#include <nlohmann/json.hpp>

#include "answer_summary.h"

namespace nlohmann {
/** A number that is not known is null. */
template <typename T>
struct adl_serializer<std::optional<T>> {
  template <typename Json>
  static void to_json(Json &json, const std::optional<T> &value) {
    json = value ? Json(*value) : Json(nullptr);
  }
};
} // namespace nlohmann

namespace Signorini {
using Json = nlohmann::ordered_json;

// The library finds the functions to_json() by the types of their arguments.

static void to_json(Json &json, const BoundaryPoint &point) {
  json = {{"side", point.side}};
  if (point.point.size() == 2)
    json["arc_length"] = point.arc_length;
  json["point"] = point.point;
}

static void to_json(Json &json, const SideForce &force) {
  json = Json::object();
  if (!force.side.empty())
    json["side"] = force.side;
  const AnswerVector &moment = force.resultant.moment;
  json["force"] = force.resultant.force;
  json["moment"] = moment.size() == 1 ? Json(moment[0]) : Json(moment);
  json["through"] = force.through;
}

static void to_json(Json &json, const PressureMaximum &peak) {
  json = {{"value", peak.value}};
  json.update(Json(peak.at));
  json["mean"] = peak.mean;
}

static void to_json(Json &json, const ContactForce &force) {
  json = Json(static_cast<const SideForce &>(force));
  if (!force.other.empty())
    json["with"] = force.other;
  if (force.peak)
    json["peak_pressure"] = *force.peak;
}

static void to_json(Json &json, const ZoneEnd &end) {
  json = end.at;
  json["uncertainty"] = end.uncertainty;
}

static void to_json(Json &json, const ContactZone &zone) {
  json = {{"start", zone.start}, {"end", zone.end}, {"length", zone.length}};
}

static void to_json(Json &json, const TangentialSummary &part) {
  json = {{"tangential_force", part.tangential_force}, {"dissipation", part.dissipation},
          {"stick_length", part.stick_length},         {"slip_length", part.slip_length},
          {"carried_share", part.carried_share},       {"largest_share", part.largest_share},
          {"open_length", part.open_length},           {"critical_factor", part.critical_factor},
          {"fixed_point_rate", part.fixed_point_rate}, {"regular", part.is_regular},
          {"stick_zones", part.stick_zones},           {"slip_zones", part.slip_zones}};
}

static void to_json(Json &json, const FieldMaximum &stress) {
  json = {{"value", stress.value}, {"point", stress.point}};
}

static void to_json(Json &json, const GrowthEdge &edge) {
  json = Json::object();
  if (edge.ends[0].size() == 2)
    json["point"] = edge.ends[0];
  else
    json["ends"] = edge.ends;
  json["radius"] = edge.radius;
  json["exponent"] = edge.exponent;
}

static void to_json(Json &json, const PlateRecord &plate) {
  json = {{"side", plate.side},
          {"direction", AnswerVector(plate.plate.direction)},
          {"travel", plate.motion.travel},
          {"force", plate.force},
          {"drift", plate.motion.drift},
          {"cross_force", plate.cross_force},
          {"centre", AnswerVector(plate.plate.centre)},
          {"rotation", plate.motion.rotation},
          {"moment", plate.moment}};
}

static void to_json(Json &json, const Penetration &penetration) {
  json = {{"value", penetration.value}};
  json.update(Json(penetration.at));
}

static void to_json(Json &json, const ErrorBound &bound) {
  json = {{"absolute", bound.absolute},
          {"relative", bound.relative},
          {"distance", bound.distance},
          {"margin", bound.margin},
          {"post_distance", bound.post_distance},
          {"post_margin", bound.post_margin},
          {"mesh", bound.mesh},
          {"oscillation", bound.oscillation},
          {"contact", bound.contact},
          {"guaranteed", bound.absolute.has_value() && bound.is_guaranteed()},
          {"conditional", bound.is_conditional},
          {"algebra", bound.algebra},
          {"post_absolute", bound.post_absolute},
          {"post_relative", bound.post_relative},
          {"energy", {bound.energy_lower, bound.energy_upper}},
          {"contact_force_error", bound.force_error},
          {"max_penetration", bound.penetration},
          {"place_of_penetration", bound.place_of_penetration},
          {"largest_cell", bound.largest_cell},
          {"largest_contact_face", bound.worst_face},
          {"missing", bound.missing}};
}

namespace {
Json with_trend(Json maximum, const Trend &trend) {
  maximum["change"] = trend.change;
  maximum["trend"] = word_for(trend.kind);
  return maximum;
}

/** Returns the contact zones with their forces. */
Json zones_of(const Answer &answer) {
  Json zones = Json::array();
  for (std::size_t i = 0; i < answer.zones.size(); ++i) {
    zones.push_back(answer.dimension == 2 ? Json(answer.zones[i])
                                          : Json({{"area", answer.zones[i].length}}));
    Json force = answer.zone_forces[i];
    force.erase("side");
    zones.back().update(force);
  }
  return zones;
}

/** Returns a PeakPressure or VonMises with its trend, the edge where it grows without limit, and
 * the maximum away from such edges. */
template <typename Maximum>
Json maximum_of(const Maximum &maximum, const MaximumTrends &trends) {
  Json json = with_trend(maximum, trends.all);
  json["grows_at"] = maximum.grows_at;
  json["away"] = maximum.away ? with_trend(*maximum.away, trends.away) : nullptr;
  return json;
}

/** Returns a report with the trends of its fields. */
Json report_of(const ProbeReport &report, const std::vector<Trend> &trends,
               const unsigned int dimension) {
  AssertDimension(report.extremes.size(), trends.size());
  Json json = {{"place", report.probe}};
  for (std::size_t k = 0; k < report.extremes.size(); ++k)
    json[to_text(static_cast<ReportField>(k))] = with_trend(report.extremes[k], trends[k]);
  json["growth"] = report.growth;
  for (const BoundedValue &mean : report.means)
    json["means"][mean.name] = {
      {"value", mean.value}, {"error", mean.error}, {"missing", mean.missing}};
  for (const auto &[name, value] : values_at_point(report, dimension))
    json["values"][name] = value;
  return json;
}
} // namespace

void write_answer(std::ostream &stream, const std::vector<LevelRecord> &levels,
                  const StudyVerdict &verdict) {
  Assert(!levels.empty(), ExcMessage("The answer is that of a level."));
  const AnswerSummary summary(levels);
  const LevelRecord &finest = summary.level;
  const Answer &answer = finest.answer;
  const ErrorBound bound = finest.bound.value_or(ErrorBound());
  Json total = answer.contact_force;
  total["error"] = bound.force_error;
  Json json = {{"level", finest.sizes.level},
               {"verdict", word_for(verdict.outcome)},
               {"accuracy", verdict.accuracy},
               {"contact_force", total},
               {"contact_by_side", answer.contact_by_side},
               {"reactions", answer.reactions},
               {"plates", finest.motions.plates},
               {"undetermined_motions", finest.motions.undetermined},
               {"peak_pressure", answer.peak_pressure
                                   ? maximum_of(*answer.peak_pressure, summary.peak_pressure)
                                   : nullptr},
               {"contact_zones", zones_of(answer)},
               {"penetration", answer.penetration},
               {"von_mises", maximum_of(answer.von_mises, summary.von_mises)},
               {"strained_share", answer.von_mises.strained_share},
               {"turned_share", answer.von_mises.turned_share},
               {"energy",
                {{"value", finest.certificate.energy},
                 {"lower", bound.energy_lower},
                 {"upper", bound.energy_upper}}},
               {"seconds", summary.seconds}};
  for (std::size_t i = 0; i < answer.reports.size(); ++i)
    json["reports"].push_back(report_of(answer.reports[i], summary.reports[i], answer.dimension));
  if (finest.tangential) {
    json["friction"] = *finest.tangential;
    json["friction"]["ratio"] = summary.tangential_ratio;
  }
  if (answer.dimension == 3)
    json["contact_area"] = finest.contact.length;
  stream << json.dump(2) << "\n";
}

namespace {
Json describe(const LevelRecord &level, const Judge &judge) {
  const Certificate &c = level.certificate;
  Json json = {{"level", level.sizes.level}};
  for (const Residual &residual : residuals(c))
    json[residual.name] = residual.value;
  json.update({{"moment_balance_is_exact", c.moments_are_exact},
               {"inf_sup", level.inf_sup},
               {"inf_sup_first", level.inf_sup_first},
               {"inf_sup_opposite", level.inf_sup_opposite},
               {"degenerate_patches", c.degenerate_patches},
               {"kkt", level.dual.kkt},
               {"linear_solves", level.linear.solves},
               {"linear_residual", level.linear.residual},
               {"rounding_error", rounding(level)},
               {"residual_bound", judge.residual_bound(level)},
               {"unique", level.tangential ? Json(nullptr) : Json(level.dual.unique)},
               {"contact_solver_replaced", level.dual.active_set_failure.has_value() ||
                                             level.dual.stalled.has_value() ||
                                             level.dual.failure_of_cycles.has_value()},
               {"bound", level.bound},
               {"certified", judge.accepts(level)}});
  return json;
}
} // namespace

void write_certificate(std::ostream &stream, const std::vector<LevelRecord> &levels,
                       const Judge &judge, const StudyVerdict &verdict) {
  Json rows = Json::array();
  for (const LevelRecord &level : levels)
    rows.push_back(describe(level, judge));
  Json certificate = {{"verdict", word_for(verdict.outcome)},
                      {"tolerance", judge.demands.tolerance},
                      {"residual_bound", verdict.residual_bound},
                      {"accuracy", verdict.accuracy},
                      {"levels", rows}};
  if (!verdict.reason.empty())
    certificate["failure"] = verdict.reason;
  stream << certificate.dump(2) << "\n";
}
} // namespace Signorini
