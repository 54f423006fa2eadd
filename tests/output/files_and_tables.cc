// SPDX-License-Identifier: LGPL-2.1-or-later
// What a run writes, read back: tables, certificate, matrices, contact line, VTU; and how files
// appear on disk.

#include <signorini/output/contact_line.h>
#include <signorini/output/files.h>
#include <signorini/output/matrix_market.h>
#include <signorini/output/solution_vtu.h>
#include <signorini/output/tables.h>
#include <signorini/parameters/exceptions.h>
#include <signorini/parameters/lists.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>
#include <map>
#include <sstream>

#include "one_level.h"
#include "tests.h"

using namespace Signorini;
namespace fs = std::filesystem;

namespace
{
std::string read(const fs::path &path)
{
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/** Comma-separated fields, empty ones included. */
std::vector<std::string> fields(const std::string &line)
{
  std::vector<std::string> result(1);
  for (const char c : line)
    if (c == ',')
      result.emplace_back();
    else
      result.back() += c;
  return result;
}

/** Rows of a CSV text as maps from the name of a column to its field. */
std::vector<std::map<std::string, std::string>> read_csv(const std::string &text)
{
  std::istringstream stream(text);
  std::string line;
  std::getline(stream, line);
  const auto names = fields(line);
  std::vector<std::map<std::string, std::string>> rows;
  while (std::getline(stream, line))
  {
    const auto values = fields(line);
    rows.emplace_back();
    for (std::size_t i = 0; i < names.size() && values.size() == names.size(); ++i)
      rows.back()[names[i]] = values[i];
  }
  return rows;
}

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
  const auto order_after = [&](const std::string &number)
  {
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
  const auto parse = [](const std::vector<LevelRecord> &levels, const std::string &failure)
  {
    std::ostringstream stream;
    write_certificate(stream, levels, 1e-10, failure);
    return Json::parse(stream.str());
  };
  auto levels = two_levels();
  levels[1].inf_sup = 0.8;
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
  const Json failed = parse(two_levels(), "it \"failed\"\n");
  checks.that("a failure",
              failed.at("verdict") == "not certified" && failed.at("failure") == "it \"failed\"\n");
  checks.that("no level at all", parse({}, "").at("verdict") == "not certified");
  levels = two_levels();
  levels[0].certificate.duality_gap = std::nan("");
  checks.that("not a number", parse(levels, "").at("verdict") == "not certified");
}

/** Reads an array (dense) or coordinate file in Matrix Market format. */
dealii::FullMatrix<double> read_matrix_market(const std::string &text)
{
  std::istringstream stream(text);
  std::string banner;
  std::getline(stream, banner);
  const bool sparse = banner == "%%MatrixMarket matrix coordinate real general";
  if (!sparse && banner != "%%MatrixMarket matrix array real general")
    return dealii::FullMatrix<double>();
  unsigned int rows = 0, columns = 0, entries = 0;
  stream >> rows >> columns;
  dealii::FullMatrix<double> matrix(rows, columns);
  if (sparse)
    stream >> entries;
  else
    entries = rows * columns;
  for (unsigned int k = 0; k < entries; ++k)
  {
    unsigned int i = k % rows + 1, j = k / rows + 1;
    if (sparse)
      stream >> i >> j;
    double value = 0.;
    stream >> value;
    matrix(i - 1, j - 1) = value;
  }
  return stream ? matrix : dealii::FullMatrix<double>();
}

void matrix_market(Checks &checks)
{
  RandomNumbers random(1);
  dealii::FullMatrix<double> matrix(3, 4), dense_D(7, 2);
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j < 4; ++j)
      matrix(i, j) = random() * std::pow(10., 100. * random());
  const auto written = [](const auto &...what)
  {
    std::ostringstream stream;
    write_matrix_market(stream, what...);
    return read_matrix_market(stream.str());
  };
  checks.that("a matrix, to the last bit", written(matrix) == matrix);
  const auto vector = random.vector(5);
  const auto column = written(vector);
  bool same = column.m() == 5 && column.n() == 1;
  for (unsigned int i = 0; same && i < 5; ++i)
    same = column(i, 0) == vector[i];
  checks.that("a vector", same);
  dense_D(0, 0) = 1. / 3.;
  dense_D(6, 0) = -2.;
  dense_D(2, 1) = 1e-20;
  checks.that("D", written(Coupling({{{0, 1. / 3.}, {6, -2.}}, {{2, 1e-20}}}), 7U) == dense_D);
}

/** u = (x, 2 x - y), n = (0, -1): u_n = -2 x on the bottom; two patches of three faces and five. */
void contact_line(Checks &checks)
{
  const OneLevel level("subsection Boundary\nset Clamped = top\nset Contact = bottom\nend\n" +
                         entry("Contact", "Gap", "0.1 + x^2") +
                         entry("Exact solution", "Pressure", "-x") +
                         entry("Discretization", "Patch ratio", "3"),
                       3);
  const NodalVector U = nodal_values(level.space(),
                                     [](const dealii::Point<2> &x)
                                     { return dealii::Point<2>(x[0], 2. * x[0] - x[1]); });
  dealii::Vector<double> P(2);
  P[0] = -1.;
  P[1] = -2.;
  const auto line = trace_contact_line(level.space(), level.multipliers(), U, P);
  std::ostringstream stream, vtu;
  write_contact_csv(stream, line);
  const std::string header = "side,s,x,y,p_H,p_recovered,u_n,g,p_exact\n";
  checks.that("contact line: columns", stream.str().compare(0, header.size(), header) == 0);
  const auto rows = read_csv(stream.str());
  checks.that("contact line: one row per piece", rows.size() == 8);
  double largest = 0.;
  for (unsigned int k = 0; k < rows.size(); ++k)
  {
    const auto number = [&](const char *name) { return std::stod(rows[k].at(name)); };
    const double x = (k + 0.5) / 8.;
    // Linear through the middles 3/16 and 11/16 of the patches.
    const double recovered = std::min(0., -1. - (x - 3. / 16.) / 0.5);
    const double expected[] = {x, x, 0., k < 3 ? -1. : -2., recovered, -2. * x, 0.1 + x * x, -x};
    const char *const names[] = {"s", "x", "y", "p_H", "p_recovered", "u_n", "g", "p_exact"};
    for (unsigned int i = 0; i < 8; ++i)
      largest = std::max(largest, std::abs(number(names[i]) - expected[i]));
  }
  checks.near("contact line: values at the middles", largest, 0., 1e-14);
  checks.that("contact line: side", rows[0].at("side") == "bottom");
  checks.near("contact line: ends", line[0].start.x[0] + line[7].end.x[0], 1., 1e-15);
  write_contact_vtu(vtu, line);
  bool all = true;
  for (const char *name :
       {"pressure", "recovered_pressure", "normal_displacement", "gap", "opening"})
    all = all && vtu.str().find("Name=\"" + std::string(name) + "\"") != std::string::npos;
  checks.that("contact line: fields of the VTU", all);

  const OneLevel unknown("subsection Boundary\nset Clamped = top\nset Contact = bottom\nend\n", 1);
  std::ostringstream without;
  write_contact_csv(
    without,
    trace_contact_line(
      unknown.space(), unknown.multipliers(), NodalVector(18), dealii::Vector<double>(1)));
  checks.that("contact line: no exact pressure", read_csv(without.str())[0].at("p_exact").empty());
}

void disk(Checks &checks, const fs::path &directory)
{
  prepare_directory(directory / "a" / "b");
  checks.that("directories are made", fs::is_directory(directory / "a" / "b"));
  checks.that("nothing is left in them", fs::is_empty(directory / "a" / "b"));
  const fs::path file = directory / "a" / "table.csv";
  write_file(file, [](std::ostream &stream) { stream << "first"; });
  checks.that("a file is written", read(file) == "first");
  bool untouched = false;
  write_file(file,
             [&](std::ostream &stream)
             {
               stream << "second" << std::flush;
               untouched = read(file) == "first";
             });
  checks.that("the old file stays until the new one is complete",
              untouched && read(file) == "second");
  checks.throws<std::runtime_error>("a writer that fails",
                                    "no more",
                                    [&]()
                                    {
                                      write_file(file,
                                                 [](std::ostream &stream)
                                                 {
                                                   stream << "half";
                                                   throw std::runtime_error("no more");
                                                 });
                                    });
  checks.that("the old file survives it", read(file) == "second");
  checks.throws<ComputationError>(
    "a stream that fails",
    "could not be written",
    [&]() { write_file(file, [](std::ostream &stream) { stream.setstate(std::ios::badbit); }); });
  checks.throws<ComputationError>(
    "a directory that is missing",
    "could not be written",
    [&]() { write_file(directory / "missing" / "file", [](std::ostream &) {}); });
  unsigned int n_files = 0;
  for (const auto &entry : fs::directory_iterator(directory / "a"))
    n_files += entry.is_regular_file() ? 1 : 0;
  checks.that("no temporary files", n_files == 1 && read(file) == "second");
  checks.throws<InputError>(
    "a directory below a file", "--output: found", [&]() { prepare_directory(file / "results"); });
  checks.throws<InputError>(
    "a directory that is a file", "--output: found", [&]() { prepare_directory(file); });
  checks.that("the file is still there", read(file) == "second");
}

void vtu(Checks &checks, const fs::path &directory)
{
  for (const unsigned int number : {0U, 1U})
  {
    const OneLevel level(entry("Scene", "Name", "D1"), number);
    const fs::path file = directory / "solution.vtu";
    write_solution_vtu(file, level.space(), level.scene, level.solve().U);
    const std::string text = read(file);
    const auto has = [&](const std::string &name)
    { return text.find("Name=\"" + name + "\"") != std::string::npos; };
    const std::string name = "VTU of level " + std::to_string(number);
    checks.that(name + ": fields", has("displacement") && has("stress") && has("von_mises_stress"));
    checks.that(name + ": recovered displacement where there are parents",
                has("recovered_displacement") == (number > 0));
    checks.that(name + ": complete", text.find("</VTKFile>") != std::string::npos);
  }
  write_pvd(directory / "solution.pvd", {{0., "solution-00.vtu"}, {1., "solution-01.vtu"}});
  const std::string pvd = read(directory / "solution.pvd");
  checks.that("PVD lists its files",
              pvd.find("solution-00.vtu") != std::string::npos &&
                pvd.find("solution-01.vtu") != std::string::npos);
}
} // namespace

int main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  dealii::deal_II_exceptions::disable_abort_on_exception();
  Checks checks;
  convergence_csv(checks);
  screen_table(checks);
  certificate(checks);
  matrix_market(checks);
  contact_line(checks);
  const fs::path directory = "files_and_tables_results";
  fs::remove_all(directory);
  disk(checks, directory);
  vtu(checks, directory);
  fs::remove_all(directory);
  return checks.exit_code();
}
