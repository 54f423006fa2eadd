// SPDX-License-Identifier: LGPL-2.1-or-later
// answer.json and certificate.json, for programs to read.

#include <signorini/base/text.h>
#include <signorini/results/output/answer_output.h>
#include <signorini/results/output/tables.h>
#include <signorini/results/verdict/judge.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

#include "answer_json.h"

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
// The library finds the functions to_json() by the types of their arguments.

static void to_json(Json &json, const BoundaryPlace &place) {
  json = {{"side", place.side}};
  if (place.point.size() == 2)
    json["arc_length"] = place.arc_length;
  json["point"] = place.point;
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

static void to_json(Json &json, const ZoneEnd &end) {
  json = end.place;
  json["uncertainty"] = end.uncertainty;
}

static void to_json(Json &json, const ContactZone &zone) {
  json = {{"start", zone.start}, {"end", zone.end}, {"length", zone.length}};
}

static void to_json(Json &json, const FrictionSummary &friction) {
  json = {
    {"tangential_force", friction.tangential_force}, {"dissipation", friction.dissipation},
    {"stick_length", friction.stick_length},         {"slip_length", friction.slip_length},
    {"carried_share", friction.carried_share},       {"largest_share", friction.largest_share},
    {"open_length", friction.open_length},           {"critical_factor", friction.critical_factor},
    {"fixed_point_rate", friction.fixed_point_rate}, {"regular", friction.is_regular},
    {"stick_zones", friction.stick_zones},           {"slip_zones", friction.slip_zones}};
}

static void to_json(Json &json, const PressureMaximum &peak) {
  json = {{"value", peak.value}};
  json.update(Json(peak.place));
  json["mean"] = peak.mean;
}

static void to_json(Json &json, const FieldMaximum &stress) {
  json = {{"value", stress.value}, {"point", stress.point}};
}

static void to_json(Json &json, const GrowthPlace &place) {
  json = Json::object();
  if (place.ends[0].size() == 2)
    json["point"] = place.ends[0];
  else
    json["ends"] = place.ends;
  json["radius"] = place.radius;
  json["exponent"] = place.exponent;
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
  json.update(Json(penetration.place));
}

static void to_json(Json &json, const ErrorBound &bound) {
  json = {{"absolute", bound.absolute},
          {"relative", bound.relative},
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
const AnswerVector &point_of(const PressureMaximum &peak) {
  return peak.place.point;
}
const AnswerVector &point_of(const FieldMaximum &stress) {
  return stress.point;
}

/** Returns whether two maxima lie on the same cell, as far as its size, its degree and the place
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

/** Returns the maximum of the finest level with its trend over the levels. Where the finest level
 * is not @p is_resolved, a maximum is not settled. */
template <typename Maximum>
Json with_trend(const std::vector<std::optional<Maximum>> &maxima, const bool is_unlimited,
                const bool is_resolved = true) {
  std::vector<std::optional<double>> values;
  values.reserve(maxima.size());
  for (const std::optional<Maximum> &maximum : maxima)
    values.push_back(maximum ? std::optional<double>(maximum->value) : std::nullopt);
  Trend trend = trend_of(values);
  const std::size_t n = maxima.size();
  if (is_unlimited)
    trend.kind = Trend::Kind::unlimited;
  else if (n > 1 && maxima[n - 2] && share_mesh(*maxima[n - 1], *maxima[n - 2]))
    trend.kind = Trend::Kind::not_refined;
  else if (!is_resolved && trend.kind == Trend::Kind::settled)
    trend.kind = Trend::Kind::not_settled;
  Json json = *maxima.back();
  json["change"] = trend.change;
  json["trend"] = word_for(trend.kind);
  return json;
}

/** Returns the maximum of the finest level, the place where it grows without limit, and the maximum
 * away from such places. @param of returns the optional PeakPressure or VonMises of an answer. */
template <typename Maximum, typename Get>
Json maximum_of(const std::vector<LevelRecord> &levels, const Get &of) {
  std::vector<std::optional<Maximum>> largest, away;
  for (const LevelRecord &level : levels) {
    const auto maximum = of(level.answer);
    largest.push_back(maximum);
    away.push_back(maximum ? maximum->away : std::nullopt);
  }
  const auto finest = of(levels.back().answer);
  if (!finest)
    return nullptr;
  const bool is_resolved = resolves_zones(levels.back().answer);
  Json json = with_trend(largest, finest->grows_at.has_value(), is_resolved);
  json["grows_at"] = finest->grows_at;
  json["away"] = finest->away ? with_trend(away, false, is_resolved) : nullptr;
  return json;
}

/** Returns what is known about a place of Output/Report, with trends over the levels. */
Json report_of(const std::vector<LevelRecord> &levels, const std::size_t i) {
  const PlaceReport &finest = levels.back().answer.reports[i];
  Json json = {{"place", finest.place}};
  for (std::size_t k = 0; k < finest.extremes.size(); ++k) {
    std::vector<std::optional<FieldMaximum>> values;
    for (const LevelRecord &level : levels) {
      const std::vector<FieldMaximum> &extremes = level.answer.reports[i].extremes;
      values.push_back(extremes.empty() ? std::nullopt : std::optional(extremes[k]));
    }
    const bool grows = finest.rows.size() == 1 && !finest.growth.empty();
    json[to_text(static_cast<ReportField>(k))] = with_trend(values, grows);
  }
  json["growth"] = finest.growth;
  if (finest.rows.size() == 1) {
    const std::vector<std::string> names =
      split_list(report_header(levels[0].answer.dimension), ',');
    for (std::size_t k = 1; k + n_report_fields < names.size(); ++k)
      json["values"][names[k]] = finest.rows[0][k];
  }
  return json;
}
} // namespace

Json answer_of(const std::vector<LevelRecord> &levels, const StudyVerdict &verdict) {
  const LevelRecord &finest = levels.back();
  const Answer &answer = finest.answer;
  const ErrorBound bound = finest.bound.value_or(ErrorBound());
  double seconds = 0.;
  for (const LevelRecord &level : levels)
    seconds += level.times.total();
  Json total = answer.contact_force;
  total["error"] = bound.force_error;
  Json json = {
    {"level", finest.sizes.level},
    {"verdict", word_for(verdict.outcome)},
    {"accuracy", verdict.accuracy},
    {"contact_force", total},
    {"contact_by_side", answer.contact_by_side},
    {"reactions", answer.reactions},
    {"plates", finest.motions.plates},
    {"undetermined_motions", finest.motions.undetermined},
    {"peak_pressure",
     maximum_of<PressureMaximum>(levels, [](const Answer &a) { return a.peak_pressure; })},
    {"contact_zones", answer.zones},
    {"penetration", answer.penetration},
    {"von_mises",
     maximum_of<FieldMaximum>(levels, [](const Answer &a) { return std::optional(a.von_mises); })},
    {"strained_share", answer.von_mises.strained_share},
    {"turned_share", answer.von_mises.turned_share},
    {"energy",
     {{"value", finest.certificate.energy},
      {"lower", bound.energy_lower},
      {"upper", bound.energy_upper}}},
    {"seconds", seconds}};
  for (std::size_t i = 0; i < answer.reports.size(); ++i)
    json["reports"].push_back(report_of(levels, i));
  if (finest.friction) {
    json["friction"] = *finest.friction;
    json["friction"]["ratio"] = nullptr;
    if (finest.contact.active > 0 && finest.contact.normal_force != 0.)
      json["friction"]["ratio"] = finest.friction->tangential_force / finest.contact.normal_force;
  }
  if (answer.dimension == 3)
    json["contact_area"] = finest.contact.length;
  return json;
}
void write_answer(std::ostream &stream, const std::vector<LevelRecord> &levels,
                  const StudyVerdict &verdict) {
  stream << answer_of(levels, verdict).dump(2) << "\n";
}

// certificate.json: how well each level satisfies (5).

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
               {"unique", level.friction ? Json(nullptr) : Json(level.dual.unique)},
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
