// SPDX-License-Identifier: LGPL-2.1-or-later
// The output on the levels of a run, read back: convergence.csv, the table on the screen and
// certificate.json.

#include <signorini/base/text.h>
#include <signorini/results/output/tables.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>

#include "csv.h"
#include "tests.h"

using namespace Signorini;

namespace {
std::vector<LevelRecord> two_levels() {
  LevelRecord coarse;
  coarse.sizes = {2, 16, 50, 2, 0.25, 0.5, false};
  coarse.dual.iterations = 3;
  coarse.dual.kkt = 1e-13;
  coarse.contact.active = 1;
  coarse.contact.normal_force = 1. / 3.;
  coarse.displacement_errors = DisplacementErrors{0.4, 0.02, 0., {}, {}, 0.5};
  coarse.pressure_errors = PressureErrors{0.3, 0.3};
  coarse.estimate = ErrorEstimate{0.3, 0.6, 0.1, 0.5, 0.3};
  coarse.certificate.energy = -0.125;
  coarse.certificate.stationarity = 1e-15;
  LevelRecord fine = coarse;
  fine.sizes.level = 3;
  fine.sizes.h = 0.125;
  fine.sizes.H = 0.25;
  fine.displacement_errors = DisplacementErrors{0.2, 0.005, 1e-3, {}, {}, 0.25};
  fine.pressure_errors = PressureErrors{0.15, 0.15};
  fine.estimate = ErrorEstimate{0.19, 0.05, 0.02, 0.04, 0.03};
  fine.dual.increment_iterations = 7;
  fine.dual_norm_errors = DualNormErrors{0.03, 0.02, 0.003, 0.002};
  fine.inf_sup = 0.8;
  return {coarse, fine};
}

void convergence_csv(Checks &checks) {
  std::ostringstream stream, without_friction;
  std::vector<LevelRecord> levels = two_levels();
  write_convergence_csv(without_friction, levels);
  checks.that("no friction", without_friction.str().find("dissipation") == std::string::npos);
  levels.front().tangential.emplace();
  write_convergence_csv(stream, levels);
  const std::string text = stream.str();
  std::vector<std::string> names;
  for (const Column<LevelRecord> &column : level_columns())
    names.push_back(column.name);
  checks.that("columns in their order", text.substr(0, text.find('\n')) == join(names, ","));
  const auto rows = read_csv(text);
  checks.that("one complete row per level",
              rows.size() == 2 && !rows[0].empty() && !rows[1].empty());
  checks.near("numbers keep all digits",
              {std::stod(rows[0].at("contact_force_n")), std::stod(rows[1].at("p_dual"))},
              {1. / 3., 0.02}, 1e-16);
  using Field = std::array<std::string, 3>;
  for (const auto &[column, coarse, fine] :
       {Field{"level", "2", "3"}, Field{"dofs", "50", "50"}, Field{"u_post_h1", "", ""},
        Field{"endpoint_error", "", ""}, Field{"qp_increment_iterations", "", "7"}})
    checks.that(column, rows[0].at(column) == coarse && rows[1].at(column) == fine);
  for (const char *column : {"inf_sup", "p_dual"})
    checks.that("known on one level", rows[0].at(column).empty() && !rows[1].at(column).empty());
}

/** The same numbers as those of a graded sequence: nothing has an order in h. */
void graded_tables(Checks &checks) {
  auto steps = two_levels();
  for (LevelRecord &step : steps) {
    step.sizes.strategy = Strategy::hp;
    step.sizes.max_degree = 2 + step.sizes.level;
    step.sizes.min_h = 0.01;
    step.estimate = ErrorEstimate{{}, 0.6, 0.25, {}, {}};
  }
  const std::string row = screen_row(steps[1], &steps[0]), errors = error_table(steps);
  checks.that("graded: rows align with the header", screen_header(true).size() == row.size());
  checks.that("graded: steps", screen_header(true).rfind(" step", 0) == 0);
  checks.that("graded: no order", split_words(row).back() == "-");
  checks.that("graded: no orders of errors", errors.find("2.000e-01    -") != std::string::npos &&
                                               errors.find("slope") == std::string::npos);
  std::ostringstream csv;
  write_convergence_csv(csv, steps);
  const auto rows = read_csv(csv.str());
  checks.that("graded: an estimate without parts",
              rows[1].at("estimated_h1").empty() && rows[1].at("estimated_mesh").empty() &&
                rows[1].at("effectivity").empty() && rows[1].at("estimated_relative") == "0.25");
}

/** One blank between all words. */
std::string words_of(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  return join(split_words(text), " ");
}

void screen_table(Checks &checks) {
  const auto levels = two_levels();
  const std::string first = screen_row(levels[0], nullptr),
                    second = screen_row(levels[1], &levels[0]);
  checks.that("rows align with the header",
              screen_header().size() == first.size() && first.size() == second.size());
  const std::string errors = error_table(levels);
  // h is halved: 0.4 -> 0.2 is order 1, 0.02 -> 0.005 order 2.
  for (const char *row :
       {"4.000e-01 -", "2.000e-01 1.00", "5.000e-03 2.00", "1.000e-03 -", "slope -"})
    checks.that(std::string("orders: ") + row, words_of(errors).find(row) != std::string::npos);
  auto four = levels;
  // 0.2 -> 0.05 -> 0.0125: with 0.4 -> 0.2 before, least squares over x = 0..3 (in log 2) and
  // y = 0, 1, 3, 5 give the slope sum (x - 1.5)(y - 2.25)/5 = 1.7.
  for (const double error : {0.05, 0.0125}) {
    four.push_back(four.back());
    four.back().sizes.h /= 2.;
    four.back().displacement_errors->h1 = error;
  }
  const std::string slopes = error_table(four);
  checks.that("least-squares slope", words_of(slopes).find("slope 1.70") != std::string::npos);
  std::istringstream lines(slopes + screen_header() + "\n" + screen_legend());
  for (std::string line; std::getline(lines, line);)
    checks.that("tables have 80 columns", line.size() <= 80);
  for (LevelRecord &level : four) {
    level.displacement_errors.reset();
    level.pressure_errors.reset();
  }
  checks.that("no table of errors without an exact solution", error_table(four).empty());
}

void certificate(Checks &checks) {
  using Json = nlohmann::json;
  const Judge judge({1e-10, 0.2, 0.});
  const auto parse = [&](const std::vector<LevelRecord> &levels, const StudyVerdict &verdict) {
    std::ostringstream stream;
    write_certificate(stream, levels, judge, verdict);
    return Json::parse(stream.str());
  };
  auto levels = two_levels();
  const Json good = parse(levels, judge.verdict(levels));
  checks.that("verdict", good.at("verdict") == "equations certified");
  checks.that("no failure", !good.contains("failure"));
  checks.near("tolerance", good.at("tolerance"), 1e-10, 0.);
  checks.near("bound on residuals", good.at("residual_bound"), 1e-8, 1e-22);
  for (const char *name : {"stationarity", "penetration", "sign", "complementarity", "duality_gap",
                           "force_balance", "moment_balance", "support", "degenerate_patches"})
    checks.that(name, good.at("levels")[0].at(name).is_number());
  checks.that("inf-sup constant where it is known", good.at("levels")[0].at("inf_sup").is_null() &&
                                                      good.at("levels")[1].at("inf_sup") == 0.8);
  checks.that("the chosen solver answered",
              good.at("levels")[0].at("contact_solver_replaced") == false);
  levels[0].certificate.duality_gap = levels[1].certificate.duality_gap = std::nan("");
  levels[1].dual.active_set_failure = "singular";
  const Json bad = parse(levels, judge.verdict(levels));
  checks.that("the verdict on a level", bad.at("levels")[0].at("certified") == false &&
                                          good.at("levels")[1].at("certified") == true);
  checks.that("another solver answered", bad.at("levels")[1].at("contact_solver_replaced") == true);
  const Json failed = parse(levels, judge.failed(levels, "it \"failed\"\n"));
  checks.that("a failure",
              failed.at("verdict") == "not certified" && failed.at("failure") == "it \"failed\"\n");
}
} // namespace

int main() {
  return run_tests({convergence_csv, screen_table, graded_tables, certificate});
}
