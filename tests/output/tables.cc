// SPDX-License-Identifier: LGPL-2.1-or-later
// What is said about the levels of a run, read back: convergence.csv, the table on the screen and
// certificate.json.

#include <signorini/base/text.h>
#include <signorini/output/tables.h>

#include <nlohmann/json.hpp>

#include <cmath>

#include "csv.h"
#include "tests.h"

using namespace Signorini;

namespace
{
std::vector<LevelRecord> two_levels()
{
  LevelRecord coarse;
  coarse.level = 2;
  coarse.cells = 16;
  coarse.dofs = 50;
  coarse.multipliers = 2;
  coarse.h = 0.25;
  coarse.H = 0.5;
  coarse.active = 1;
  coarse.qp_iterations = 3;
  coarse.kkt = 1e-13;
  coarse.contact_force = 1. / 3.;
  coarse.u_h1 = 0.4;
  coarse.u_l2 = 0.02;
  coarse.p_l2 = 0.3;
  coarse.estimated_h1 = 0.3;
  coarse.certificate.energy = -0.125;
  coarse.certificate.stationarity = 1e-15;
  LevelRecord fine = coarse;
  fine.level = 3;
  fine.h = 0.125;
  fine.H = 0.25;
  fine.u_h1 = 0.2;
  fine.u_l2 = 0.005;
  fine.u_superclose_h1 = 1e-3;
  fine.p_l2 = 0.15;
  fine.estimated_h1 = 0.19;
  fine.increment_iterations = 7;
  fine.p_dual = 0.02;
  fine.inf_sup = 0.8;
  return {coarse, fine};
}

void convergence_csv(Checks &checks)
{
  std::ostringstream stream;
  write_convergence_csv(stream, two_levels());
  const std::string text = stream.str();
  const std::string columns =
    "level,cells,dofs,multipliers,h,H,active,qp_iterations,kkt,inf_sup,energy,contact_force_n,"
    "max_pressure,contact_length,u_h1,u_l2,u_superclose_h1,u_post_h1,p_l2,p_dual,p_dual_spectral,"
    "p_superclose_dual,p_superclose_dual_spectral,p_post_l2,endpoint_error,estimated_h1,"
    "effectivity,t_mesh,t_setup,t_assembly,t_factor,t_compliance,t_qp,t_recovery,t_postprocess,"
    "t_errors,t_output,t_total,cpu_total,peak_memory_mb";
  checks.that("columns in their order", text.compare(0, columns.size(), columns) == 0);
  const auto rows = read_csv(text);
  checks.that("one complete row per level",
              rows.size() == 2 && !rows[0].empty() && !rows[1].empty());
  checks.that("counts", rows[0].at("level") == "2" && rows[0].at("dofs") == "50");
  checks.near("numbers keep all digits", std::stod(rows[0].at("contact_force_n")), 1. / 3., 1e-16);
  checks.near("energy", std::stod(rows[0].at("energy")), -0.125, 0.);
  checks.near("effectivity", std::stod(rows[1].at("effectivity")), 0.95, 1e-15);
  checks.that("what is not known is empty",
              rows[0].at("u_superclose_h1").empty() && rows[0].at("inf_sup").empty() &&
                rows[0].at("u_post_h1").empty() && rows[0].at("p_dual").empty() &&
                rows[0].at("endpoint_error").empty());
  checks.near("what becomes known is not", std::stod(rows[1].at("u_superclose_h1")), 1e-3, 1e-18);
  checks.near("dual norm", std::stod(rows[1].at("p_dual")), 0.02, 1e-17);
  checks.near("inf-sup constant", std::stod(rows[1].at("inf_sup")), 0.8, 1e-16);
  checks.that("sweeps until the increment was small",
              rows[0].at("qp_increment_iterations").empty() &&
                rows[1].at("qp_increment_iterations") == "7");
  LevelRecord exact;
  exact.estimated_h1 = 0.1;
  exact.u_h1 = 0.;
  checks.that("no effectivity without an error", !exact.effectivity());
}

void screen_table(Checks &checks)
{
  const auto levels = two_levels();
  const ScreenTable table(true, true);
  const std::string first = table.row(levels[0], nullptr),
                    second = table.row(levels[1], &levels[0]);
  checks.that("rows align with the header",
              table.header().size() == first.size() && first.size() == second.size());
  const auto words = split_words(second);
  // h is halved: 0.4 -> 0.2 is order 1, 0.02 -> 0.005 order 2.
  const auto order_after = [&](const std::string &number) {
    for (std::size_t i = 0; i + 1 < words.size(); ++i)
      if (words[i] == number)
        return words[i + 1];
    return std::string();
  };
  checks.that("order of the H1 error", order_after("2.000e-01") == "1.00");
  checks.that("order of the L2 error", order_after("5.000e-03") == "2.00");
  checks.that("order of the pressure error", order_after("1.500e-01") == "1.00");
  checks.that("no order without a value before", order_after("1.000e-03") == "-");
  checks.that("no orders on the first level", first.find("1.00 ") == std::string::npos);
  const ScreenTable without(false, false);
  checks.that("the estimate stands in for errors",
              without.header().find("estimate") != std::string::npos &&
                without.header().find("|u-uh|1") == std::string::npos);
  checks.that("its rows align, too",
              without.header().size() == without.row(levels[1], &levels[0]).size());
}

void certificate(Checks &checks)
{
  using Json = nlohmann::json;
  const auto parse = [](const std::vector<LevelRecord> &levels, const std::string &failure) {
    std::ostringstream stream;
    write_certificate(stream, levels, 1e-10, true, failure);
    return Json::parse(stream.str());
  };
  auto levels = two_levels();
  const Json good = parse(levels, "");
  checks.that("verdict", good.at("verdict") == "certified");
  checks.near("tolerance", good.at("tolerance"), 1e-10, 0.);
  checks.that("levels", good.at("levels").size() == 2 && good.at("levels")[1].at("level") == 3);
  bool complete = true;
  for (const char *name : {"stationarity",
                           "penetration",
                           "sign",
                           "complementarity",
                           "duality_gap",
                           "force_balance",
                           "moment_balance",
                           "degenerate_patches"})
    complete = complete && good.at("levels")[0].at(name).is_number();
  checks.that("all residuals", complete);
  checks.near("a residual", good.at("levels")[0].at("stationarity"), 1e-15, 0.);
  checks.that("inf-sup constant where it is known",
              good.at("levels")[0].at("inf_sup").is_null() &&
                good.at("levels")[1].at("inf_sup") == 0.8);
  levels[0].certificate.force_balance = 1e-3;
  checks.that("a large residual", parse(levels, "").at("verdict") == "not certified");
  levels = two_levels();
  levels[1].converged = false;
  checks.that("an unconverged level", parse(levels, "").at("verdict") == "not certified");
  levels = two_levels();
  levels[1].kkt = 1e-9;
  checks.that("a KKT residual above the tolerance",
              parse(levels, "").at("verdict") == "not certified");
  std::ostringstream unfinished;
  write_certificate(unfinished, two_levels(), 1e-10, false, "");
  checks.that("more levels to come", Json::parse(unfinished.str()).at("verdict") == "unfinished");
  const Json failed = parse(two_levels(), "it \"failed\"\n");
  checks.that("a failure",
              failed.at("verdict") == "not certified" && failed.at("failure") == "it \"failed\"\n");
  checks.that("no level at all", parse({}, "").at("verdict") == "not certified");
  levels = two_levels();
  levels[0].certificate.duality_gap = std::nan("");
  checks.that("not a number", parse(levels, "").at("verdict") == "not certified");
}
} // namespace

int main()
{
  Checks checks;
  convergence_csv(checks);
  screen_table(checks);
  certificate(checks);
  return checks.exit_code();
}
