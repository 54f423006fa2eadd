// SPDX-License-Identifier: LGPL-2.1-or-later
// Matrices, contact line and VTU read back, and how files appear on disk.

#include <signorini/base/errors.h>
#include <signorini/results/files/contact_files.h>
#include <signorini/results/files/files.h>
#include <signorini/results/files/matrix_market.h>
#include <signorini/results/files/solution_vtu.h>

#include <deal.II/lac/dynamic_sparsity_pattern.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "csv.h"
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

/** Reads an array (dense) or coordinate file in Matrix Market format, general or symmetric. */
dealii::FullMatrix<double> read_matrix_market(const std::string &text)
{
  std::istringstream stream(text);
  std::string banner;
  std::getline(stream, banner);
  const std::string kind = "%%MatrixMarket matrix ";
  const bool sparse = banner.find(kind + "coordinate real ") == 0;
  const bool symmetric = banner.find(" real symmetric") != std::string::npos;
  if (!sparse && banner.find(kind + "array real ") != 0)
    return dealii::FullMatrix<double>();
  unsigned int rows = 0, columns = 0, entries = 0;
  stream >> rows >> columns;
  dealii::FullMatrix<double> matrix(rows, columns);
  if (sparse)
    stream >> entries;
  else
    entries = symmetric ? rows * (rows + 1) / 2 : rows * columns;
  unsigned int i = 0, j = 1;
  for (unsigned int k = 0; k < entries; ++k)
  {
    // The next entry of a column, or the first of the next column.
    if (++i > rows)
    {
      ++j;
      i = symmetric ? j : 1;
    }
    if (sparse)
      stream >> i >> j;
    double value = 0.;
    stream >> value;
    matrix(i - 1, j - 1) = value;
    if (symmetric)
      matrix(j - 1, i - 1) = value;
  }
  return stream ? matrix : dealii::FullMatrix<double>();
}

void matrix_market(Checks &checks)
{
  RandomNumbers random(1);
  dealii::FullMatrix<double> matrix(4, 4), dense_D(7, 2), dense_A(3, 3);
  for (unsigned int i = 0; i < 4; ++i)
    for (unsigned int j = 0; j <= i; ++j)
      matrix(i, j) = matrix(j, i) = random() * std::pow(10., 100. * random());
  const auto written = [](const auto &...what) {
    std::ostringstream stream;
    write_matrix_market(stream, what...);
    return read_matrix_market(stream.str());
  };
  std::ostringstream dense;
  write_symmetric_matrix_market(dense, matrix);
  const std::string text = dense.str();
  checks.that("a symmetric matrix, to the last bit", read_matrix_market(text) == matrix);
  checks.that("  its lower triangle only", std::count(text.begin(), text.end(), '\n') == 2 + 10);
  const auto vector = random.vector(5);
  const auto column = written(vector);
  bool same = column.m() == 5 && column.n() == 1;
  for (unsigned int i = 0; same && i < 5; ++i)
    same = column(i, 0) == vector[i];
  checks.that("a vector", same);
  dense_D(0, 0) = 1. / 3.;
  dense_D(6, 0) = -2.;
  dense_D(2, 1) = 1e-20;
  dealii::DynamicSparsityPattern pattern(3);
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j < 3; ++j)
      pattern.add(i, j);
  dealii::TrilinosWrappers::SparseMatrix A;
  A.reinit(pattern);
  for (unsigned int i = 0; i < 3; ++i)
    A.set(i, i, 2.);
  for (const auto &[i, j] : {std::pair(0U, 2U), std::pair(2U, 0U)})
    A.set(i, j, -1. / 3.);
  A.compress(dealii::VectorOperation::insert);
  for (unsigned int i = 0; i < 3; ++i)
    dense_A(i, i) = 8.;
  dense_A(0, 2) = dense_A(2, 0) = 4. * (-1. / 3.);
  std::ostringstream sparse;
  write_symmetric_matrix_market(sparse, 3, {lower_triangle(A, 4.), ""});
  checks.that("A", read_matrix_market(sparse.str()) == dense_A);
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
  const Displacement U = nodal_values(level.space(), [](const dealii::Point<2> &x) {
    return dealii::Point<2>(x[0], 2. * x[0] - x[1]);
  });
  Pressure P(2);
  P[0] = -1.;
  P[1] = -2.;
  const auto line = trace_contact(level.space(), level.multipliers(), level.scene.boundary, U, P);
  std::ostringstream stream;
  write_contact_csv<2>(stream, line);
  const std::string header = "side,s,x,y,p_H,p_recovered,u_n,g,p_exact,patch,patch_length\n";
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
    const double expected[] = {x,
                               x,
                               0.,
                               k < 3 ? -1. : -2.,
                               recovered,
                               -2. * x,
                               0.1 + x * x,
                               -x,
                               k < 3 ? 0. : 1.,
                               k < 3 ? 0.375 : 0.625};
    const char *const names[] = {
      "s", "x", "y", "p_H", "p_recovered", "u_n", "g", "p_exact", "patch", "patch_length"};
    for (unsigned int i = 0; i < 10; ++i)
      largest = std::max(largest, std::abs(number(names[i]) - expected[i]));
  }
  checks.near("contact line: values at the middles", largest, 0., 1e-14);
  checks.that("contact line: side", rows[0].at("side") == "bottom");
  checks.near(
    "contact line: ends", line[0].corners.front().x[0] + line[7].corners.back().x[0], 1., 1e-15);

  const OneLevel unknown("subsection Boundary\nset Clamped = top\nset Contact = bottom\nend\n", 1);
  std::ostringstream without;
  write_contact_csv<2>(without,
                       trace_contact(unknown.space(),
                                     unknown.multipliers(),
                                     unknown.scene.boundary,
                                     unknown.space().zero(),
                                     Pressure(1)));
  checks.that("contact line: no exact pressure", read_csv(without.str())[0].at("p_exact").empty());
}

void directories(Checks &checks, const fs::path &directory)
{
  const fs::path path = directory / "a" / "b";
  fs::create_directory(directory);
  {
    const ResultsDirectory results(path);
    checks.that("directories are made", fs::is_directory(path));
    checks.that("nothing is left in them", fs::is_empty(path));
    checks.throws<InputError>("not for two runs at once", "another run is writing", [&]() {
      const ResultsDirectory second(path);
    });
    checks.that("the second run removes nothing", fs::is_directory(path));
    results.remove_if_empty();
    checks.that("directories without use are removed, but no others",
                !fs::exists(directory / "a") && fs::is_directory(directory));
  }
  std::ofstream(directory / "file") << "mine";
  checks.throws<InputError>("a file behind a new directory", "--output: found", [&]() {
    const ResultsDirectory results(directory / "new" / ".." / "file");
  });
  checks.that("which stays, without the directory",
              read(directory / "file") == "mine" && !fs::exists(directory / "new"));
  fs::create_directories(path);
  ResultsDirectory(path).remove_if_empty();
  checks.that("what was there before stays", fs::is_directory(path));
  fs::remove_all(directory);
}

/** Results of an earlier run go, with halves of a killed one; other files stay. */
void earlier_run(Checks &checks, const fs::path &directory)
{
  fs::create_directories(directory / "results-1");
  for (const char *name : {"results-0",
                           ".results-0.part",
                           ".results-2.part",
                           "notes",
                           ".notes.part",
                           ".part",
                           "..part"})
    std::ofstream(directory / name) << "text";
  remove_files(directory, [](const std::string &name) { return name.rfind("results-", 0) == 0; });
  const fs::directory_iterator entries(directory);
  checks.that("earlier results are removed, also halves of them",
              !fs::exists(directory / "results-0") && !fs::exists(directory / ".results-0.part") &&
                !fs::exists(directory / ".results-2.part"));
  checks.that("nothing else is", std::distance(begin(entries), end(entries)) == 5);
  remove_files(directory / "missing", [](const std::string &) { return true; });
  fs::remove_all(directory);
}

void disk(Checks &checks, const fs::path &directory)
{
  fs::create_directories(directory / "a");
  const fs::path file = directory / "a" / "table.csv";
  const auto n_files = [&]() {
    const fs::directory_iterator entries(directory / "a");
    return std::count_if(
      begin(entries), end(entries), [](const auto &entry) { return entry.is_regular_file(); });
  };
  write_file(file, [](std::ostream &stream) { stream << "first"; });
  checks.that("a file is written", read(file) == "first");
  bool untouched = false;
  write_file(file, [&](std::ostream &stream) {
    stream << "second" << std::flush;
    untouched = read(file) == "first";
  });
  checks.that("the old file stays until the new one is complete",
              untouched && read(file) == "second");
  checks.throws<std::runtime_error>("a writer that fails", "no more", [&]() {
    write_file(file, [](std::ostream &stream) {
      stream << "half";
      throw std::runtime_error("no more");
    });
  });
  checks.that("the old file survives it and is alone", read(file) == "second" && n_files() == 1);
  checks.throws<ComputationError>("a directory that is missing", "could not be written", [&]() {
    write_file(directory / "missing" / "file", [](std::ostream &) {});
  });
  checks.that("no temporary files", n_files() == 1 && read(file) == "second");
  checks.throws<InputError>("a directory that is a file", "--output: found", [&]() {
    const ResultsDirectory results(file);
  });
  checks.that("the file is still there", read(file) == "second");
}

void pvd(Checks &checks)
{
  std::ostringstream stream;
  write_pvd(stream, {{0., "solution-00.vtu"}, {1., "solution-01.vtu"}});
  const std::string pvd = stream.str();
  checks.that("PVD lists its files, levels are times",
              pvd.find("solution-00.vtu") != std::string::npos &&
                pvd.find("timestep=\"1\" group=\"\" part=\"0\" file=\"solution-01.vtu\"") !=
                  std::string::npos);
}
} // namespace

int main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  dealii::deal_II_exceptions::disable_abort_on_exception();
  Checks checks;
  matrix_market(checks);
  contact_line(checks);
  const fs::path directory = "files_test_results";
  fs::remove_all(directory);
  directories(checks, directory);
  earlier_run(checks, directory);
  disk(checks, directory);
  pvd(checks);
  fs::remove_all(directory);
  return checks.exit_code();
}
