// SPDX-License-Identifier: LGPL-2.1-or-later
// certificate.json: how well each level satisfies (5), for programs to read.

#include <signorini/output/tables.h>

#include <nlohmann/json.hpp>

#include <algorithm>

namespace Signorini
{
void write_certificate(std::ostream &stream,
                       const std::vector<LevelRecord> &levels,
                       const double tolerance,
                       const bool finished,
                       const std::string &failure)
{
  using Json = nlohmann::ordered_json;
  Json rows = Json::array();
  for (const LevelRecord &level : levels)
  {
    const Certificate &c = level.certificate;
    rows.push_back({{"level", level.level},
                    {"stationarity", c.stationarity},
                    {"penetration", c.penetration},
                    {"sign", c.sign},
                    {"complementarity", c.complementarity},
                    {"duality_gap", c.duality_gap},
                    {"force_balance", c.force_balance},
                    {"moment_balance", c.moment_balance},
                    {"moment_balance_is_exact", c.moments_are_exact},
                    {"inf_sup", level.inf_sup ? Json(*level.inf_sup) : Json(nullptr)},
                    {"degenerate_patches", c.degenerate_patches},
                    {"kkt", level.kkt},
                    {"linear_solves", level.linear_solves},
                    {"linear_residual", level.linear_residual},
                    {"rounding_error", level.rounding()},
                    {"residual_bound", level.residual_bound(tolerance)},
                    {"unique", level.unique},
                    {"certified", level.is_certified(tolerance)}});
  }
  const bool certified = failure.empty() && !levels.empty() &&
                         std::all_of(levels.begin(), levels.end(), [&](const LevelRecord &level) {
                           return level.is_certified(tolerance);
                         });
  const char *const verdict = !finished ? "unfinished" : certified ? "certified" : "not certified";
  Json certificate = {{"verdict", verdict},
                      {"tolerance", tolerance},
                      {"residual_bound", largest_residual_bound(levels, tolerance)},
                      {"levels", rows}};
  if (!failure.empty())
    certificate["failure"] = failure;
  stream << certificate.dump(2) << "\n";
}
} // namespace Signorini
