// SPDX-License-Identifier: LGPL-2.1-or-later
// certificate.json: how well each level satisfies (5), for programs to read.

#include <signorini/output/tables.h>
#include <signorini/verdict/residuals.h>

#include <nlohmann/json.hpp>

namespace Signorini
{
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
          {"largest_contact_face", bound.largest_face},
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
