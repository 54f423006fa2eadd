// SPDX-License-Identifier: LGPL-2.1-or-later
// Matrices, contact line and VTU read back, and how files appear on disk.

#include <signorini/base/errors.h>
#include <signorini/results/output/answer_output.h>
#include <signorini/results/output/contact_files.h>
#include <signorini/results/output/files.h>
#include <signorini/results/output/matrix_market.h>
#include <signorini/results/output/solution_vtu.h>

#include <deal.II/lac/dynamic_sparsity_pattern.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>

#include "csv.h"
#include "one_level.h"
#include "study_helpers.h"
#include "tests.h"

using namespace Signorini;
namespace fs = std::filesystem;

namespace {
/** The text of a matrix as the format demands it: a banner, sizes, and entries with all digits. */
void matrix_market(Checks &checks) {
  const auto written = [](const auto &...parts) {
    std::ostringstream stream;
    write_matrix_market(stream, parts...);
    return stream.str();
  };
  const std::string banner = "%%MatrixMarket matrix ", third = "0.3333333333333333";
  std::ostringstream dense, sparse;
  dealii::FullMatrix<double> matrix(2, 2);
  matrix(0, 0) = 1. / 3.;
  matrix(1, 0) = matrix(0, 1) = -2.;
  matrix(1, 1) = 1e-20;
  write_matrix_market(dense, matrix, true);
  checks.that("a symmetric matrix, its lower triangle only",
              dense.str() == banner + "array real symmetric\n2 2\n" + third + "\n-2\n1e-20\n");
  dealii::FullMatrix<double> vector(2, 1);
  vector(1, 0) = 1. / 3.;
  checks.that("a vector",
              written(vector) == banner + "array real general\n2 1\n0\n" + third + "\n");
  checks.that("D", written(7, 2, entries_of(Coupling({{{0, 1. / 3.}, {6, -2.}}, {{2, 4.}}}))) ==
                     banner + "coordinate real general\n7 2 3\n1 1 " + third + "\n7 1 -2\n3 2 4\n");
  dealii::DynamicSparsityPattern pattern(2);
  for (const unsigned int i : {0, 1})
    for (const unsigned int j : {0, 1})
      pattern.add(i, j);
  dealii::TrilinosWrappers::SparseMatrix A;
  A.reinit(pattern);
  for (const unsigned int i : {0, 1})
    for (const unsigned int j : {0, 1})
      A.set(i, j, i == j ? 2. : -0.5);
  A.compress(dealii::VectorOperation::insert);
  write_matrix_market(sparse, 2, 2, lower_triangle(A, 4.), true);
  checks.that("A",
              sparse.str() == banner + "coordinate real symmetric\n2 2 3\n1 1 8\n2 1 -2\n2 2 8\n");
}

/** u = (x, 2 x - y), n = (0, -1): u_n = -2 x on the bottom; two patches of three faces and five. */
void contact_line(Checks &checks) {
  const std::vector<std::string> held = {"Boundary/Clamped=top", "Boundary/Contact=bottom"};
  const OneLevel level("subsection Discretization\nset Patch ratio = 3\nend\n"
                       "subsection Contact\nset Gap = 0.1 + x^2\nend\n"
                       "subsection Exact solution\nset Pressure = -x\nend\n",
                       3, held);
  const Displacement U = nodal_values(level.space(), [](const dealii::Point<2> &x) {
    return dealii::Point<2>(x[0], 2. * x[0] - x[1]);
  });
  Pressure P(2);
  P[0] = -1.;
  P[1] = -2.;
  const auto line = trace_contact(level.body(U, P));
  std::ostringstream stream;
  write_contact_csv<2>(stream, line);
  const std::string header = "side,s,x,y,p_H,p_recovered,u_n,g,p_exact,patch,patch_length\n";
  checks.that("contact line: columns", stream.str().compare(0, header.size(), header) == 0);
  const auto rows = read_csv(stream.str());
  checks.near("contact line: rows", rows.size(), 8, 0.);
  for (unsigned int k = 0; k < rows.size(); ++k) {
    // The recovered pressure is linear through the middles 3/16 and 11/16 of the patches.
    const double x = (k + 0.5) / 8., patch = k < 3 ? 0. : 1.;
    const std::map<std::string, double> expected = {
      {"s", x},
      {"x", x},
      {"y", 0.},
      {"p_H", -1. - patch},
      {"p_recovered", std::min(0., -1. - (x - 3. / 16.) / 0.5)},
      {"u_n", -2. * x},
      {"g", 0.1 + x * x},
      {"p_exact", -x},
      {"patch", patch},
      {"patch_length", 0.375 + 0.25 * patch}};
    for (const auto &[name, number] : expected)
      checks.near("contact line: " + name, std::stod(rows[k].at(name)), number, 1e-14);
  }
  checks.that("contact line: side", rows[0].at("side") == "bottom");
  checks.near("contact line: ends", line[0].corners.front().x[0] + line[7].corners.back().x[0], 1.,
              1e-15);

  const OneLevel unknown("", 1, held);
  std::ostringstream without;
  write_contact_csv<2>(without, trace_contact(unknown.body(unknown.space().zero(), Pressure(1))));
  checks.that("contact line: no exact pressure", read_csv(without.str())[0].at("p_exact").empty());
}

/** Runs that are killed, full disks and two runs at once: tests/driver/faults. */
/** A zone that is shorter than rounding of the body goes around nothing. */
void short_zone(Checks &checks) {
  std::vector<LevelRecord> records =
    solve("Boundary/Clamped = top\nBoundary/Contact = bottom\n", levels(1, 1)).levels;
  const auto end_at = [](const double s) {
    return ZoneEnd{{"bottom", s, AnswerVector(dealii::Point<2>(s, 0.))}, 0.};
  };
  records.back().answer.zones = {{end_at(0.), end_at(5e-11), 5e-11}};
  std::ostringstream stream;
  print_answer(stream, records, "");
  const std::string text = stream.str();
  checks.that("a short zone has two ends",
              text.find("all around") == std::string::npos &&
                text.find("Contact zone      bottom from (0, 0)") != std::string::npos);
}

void directories(Checks &checks) {
  const fs::path directory = "files_test_results", path = directory / "a" / "b";
  fs::remove_all(directory);
  fs::create_directory(directory);
  {
    const ResultsDirectory results(path);
    checks.that("directories are made, and nothing is left in them", fs::is_empty(path));
    results.remove_if_empty();
    checks.that("directories without use are removed, but no others",
                !fs::exists(directory / "a") && fs::is_directory(directory));
  }
  std::ofstream(directory / "file") << "mine";
  checks.throws<InputError>("a file behind a new directory", "--output: found", [&]() {
    const ResultsDirectory results(directory / "new" / ".." / "file");
  });
  checks.that("which stays, without the directory",
              file_text(directory / "file") == "mine" && !fs::exists(directory / "new"));
  fs::create_directories(path);
  ResultsDirectory(path).remove_if_empty();
  checks.that("what was there before stays", fs::is_directory(path));
  const fs::path file = path / "table.csv";
  write_file(file, [](std::ostream &stream) { stream << "first"; });
  checks.throws<std::runtime_error>("a writer that fails", "no more", [&]() {
    write_file(file, [&](std::ostream &stream) {
      stream << "half" << std::flush;
      throw std::runtime_error(file_text(file) == "first" ? "no more" : "");
    });
  });
  checks.that("the old file survives it and is alone",
              file_text(file) == "first" &&
                std::distance(fs::directory_iterator(path), fs::directory_iterator()) == 1);
  fs::remove_all(directory);
}

void pvd(Checks &checks) {
  std::ostringstream stream;
  write_pvd(stream, {{0., "solution-00.vtu"}, {1., "solution-01.vtu"}});
  const std::string pvd = stream.str();
  checks.that("PVD lists its files, levels are times",
              pvd.find("solution-00.vtu") != std::string::npos &&
                pvd.find("timestep=\"1\" group=\"\" part=\"0\" file=\"solution-01.vtu\"") !=
                  std::string::npos);
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv, {matrix_market, contact_line, short_zone, directories, pvd});
}
