// SPDX-License-Identifier: LGPL-2.1-or-later
// What is written about elements of several degrees: fields and curves of polynomials, and the
// files of a run.

#include <signorini/results/files/contact_files.h>
#include <signorini/results/files/files.h>
#include <signorini/results/files/solution_vtu.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "csv.h"
#include "one_level.h"
#include "study_helpers.h"
#include "tests.h"
#include "vtu_reader.h"

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

/** u = (x² + x y, y² - 2 x y). */
class Quadratic : public dealii::Function<2>
{
public:
  Quadratic()
    : dealii::Function<2>(2)
  {
  }
  double value(const dealii::Point<2> &x, const unsigned int component) const override
  {
    return component == 0 ? x[0] * x[0] + x[0] * x[1] : x[1] * x[1] - 2. * x[0] * x[1];
  }
};

/** The unit square with 4 x 4 cells, whose degrees are 2, 3, 4, 5 from left to right. */
class Columns4
{
public:
  Columns4()
    : level(entry("Boundary", "Contact", "bottom") + entry("Boundary", "Clamped", "top") +
              entry("Material", "Young's modulus", "2.5") +
              entry("Material", "Poisson's ratio", "0.25") + entry("Contact", "Gap", "0.1 + x^2"),
            2)
    , space(mesh(), level.scene, degrees())
    , surface(mesh(), level.scene, degrees())
    , multipliers(surface, {1, 2, 3, 4})
    , U(interpolate_at_nodes(space, Quadratic()))
  {
  }

  const Mesh<2> &mesh() const
  {
    return level.discretization.mesh;
  }
  std::vector<unsigned int> degrees() const
  {
    std::vector<unsigned int> degrees;
    for (const auto &cell : mesh().triangulation().active_cell_iterators())
      degrees.push_back(2 + static_cast<unsigned int>(4. * cell->center()[0]));
    return degrees;
  }

  OneLevel level;
  DisplacementSpace<2> space;
  ContactSurface<2> surface;
  MultiplierSpace<2> multipliers;
  Displacement U;
};

/** In plane strain with E = 2.5, nu = 1/4: lambda = mu = 1. */
void fields(Checks &checks, const Columns4 &example)
{
  const fs::path file = "graded_solution.vtu";
  write_solution_vtu(file, example.space, example.level.scene, example.U, BoundFields(), 3);
  const std::string vtu = read(file);
  fs::remove(file);
  const PointField points = read_vtu_field(vtu, ""), stress = read_vtu_field(vtu, "stress"),
                   u = read_vtu_field(vtu, "displacement"), degree = read_vtu_field(vtu, "degree");
  // Four cells of every degree p, with (p + 1)² points each.
  checks.that("cells of degree p are divided into p x p",
              points.size() == 4 * (9 + 16 + 25 + 36) && stress.size() == points.size() &&
                u.size() == points.size() && degree.size() == points.size());
  double of_u = 0., stress_data = 0.;
  bool degrees_fit = true;
  for (std::size_t k = 0; k < points.size(); ++k)
  {
    const double x = points[k][0], y = points[k][1], e11 = 2. * x + y, e22 = 2. * y - 2. * x,
                 e12 = 0.5 * (x - 2. * y);
    of_u = std::max(
      {of_u, std::abs(u[k][0] - (x * x + x * y)), std::abs(u[k][1] - (y * y - 2. * x * y))});
    stress_data = std::max({stress_data,
                            std::abs(stress[k][0] - (3. * e11 + e22)),
                            std::abs(stress[k][1] - 2. * e12),
                            std::abs(stress[k][4] - (e11 + 3. * e22)),
                            std::abs(stress[k][8] - (e11 + e22))});
    degrees_fit = degrees_fit && std::abs(x - (degree[k][0] - 1.5) / 4.) < 0.13;
  }
  checks.near("displacement", of_u, 0., 1e-6);
  checks.near("stress in space", stress_data, 0., 3e-6);
  checks.that("degree", degrees_fit);
  checks.that("the number of the step is the time",
              vtu.find("Name=\"TIME\" NumberOfTuples=\"1\" format=\"ascii\">3<") != vtu.npos);
  checks.that("no recovered displacement", vtu.find("recovered_displacement") == std::string::npos);
}

/** p_H = -(1 + x - x³) on faces with at least four nodes, and what less nodes make of it. */
void curves(Checks &checks, const Columns4 &example)
{
  const auto p = [](const double x) { return -1. - x + x * x * x; };
  const MultiplierSpace<2> &multipliers = example.multipliers;
  Pressure P(multipliers.n_multipliers());
  for (unsigned int k = 0; k < P.size(); ++k)
    P[k] = p(multipliers.node(k)[0]);
  const auto &boundary = example.level.scene.boundary;
  const auto line = trace_contact(example.space, multipliers, boundary, example.U, P);
  std::ostringstream csv, stream;
  write_contact_csv<2>(csv, line);
  write_contact_vtu<2>(stream, line, {});
  const auto rows = read_csv(csv.str());
  checks.that("ends, nodes and middles of every face", rows.size() == 5 + 7 + 9 + 11);
  double before = 0., of_p = 0., of_opening = 0.;
  bool ascending = true;
  for (const auto &row : rows)
  {
    const auto number = [&](const char *name) { return std::stod(row.at(name)); };
    const double x = number("x");
    ascending = ascending && number("s") >= before && std::abs(number("s") - x) < 1e-14;
    before = number("s");
    if (row.at("patch") == "3")
      of_p = std::max(of_p, std::abs(number("p_H") - p(x)));
    // u_n = -u_2 = 0 at y = 0.
    of_opening =
      std::max({of_opening, std::abs(number("u_n")), std::abs(number("g") - 0.1 - x * x)});
  }
  checks.that("in the order of arc length", ascending && before == 1.);
  checks.near("a polynomial of degree three", of_p, 0., 1e-14);
  checks.near("displacement and gap", of_opening, 0., 1e-14);
  const PointField points = read_vtu_field(stream.str(), ""),
                   pressure = read_vtu_field(stream.str(), "contact_pressure");
  checks.that("curve: an interval between two rows", points.size() == 2 * (4 + 6 + 8 + 10));
  double largest = 0.;
  for (std::size_t k = 0; k < pressure.size(); ++k)
    if (points[k][0] > 0.76)
      largest = std::max(largest, std::abs(pressure[k][0] + p(points[k][0])));
  checks.near("curve: pressure", largest, 0., 1e-6);
  P.add(-2. * P[0]);
  const auto open = trace_contact(example.space, multipliers, boundary, example.U, P);
  checks.that("p_recovered is cut at zero",
              open[0].rows[0].p_H > 0. && open[0].rows[0].p_recovered == 0.);
}

/** B1: p = -(xi - x)_+^{1/2} at the bottom, xi = 2^{-1/2}. */
void run(Checks &checks)
{
  const fs::path directory = "graded_results";
  fs::remove_all(directory);
  fs::create_directory(directory);
  std::ostringstream screen;
  const Parameters parameters = parse_parameters(named_scene("B1"),
                                                 "test",
                                                 {"Discretization/Strategy=hp",
                                                  "Discretization/Coarsest level=2",
                                                  "Discretization/Target error=1e-5",
                                                  "Output/VTU=all"});
  const StudyResult<2> study = run_study(parameters,
                                         make_scene<2>(parameters),
                                         MPI_COMM_WORLD,
                                         {screen, directory, [](const std::string &) {}});
  const LevelSizes &sizes = study.levels.back().sizes;
  const std::string number = "-0" + std::to_string(sizes.level);
  bool known = true;
  for (const auto &file : fs::directory_iterator(directory))
    known = known && is_name_of_result(file.path().filename().string());
  checks.that("run: every file will be known to the next run", known);
  const double xi = std::sqrt(0.5);

  const std::string vtu = read(directory / ("solution" + number + ".vtu"));
  const PointField points = read_vtu_field(vtu, ""), yy = read_vtu_field(vtu, "stress_yy"),
                   xy = read_vtu_field(vtu, "stress_xy");
  double of_yy = 0., of_xy = 0.;
  unsigned int n_points = 0;
  for (std::size_t k = 0; k < points.size(); ++k)
    if (points[k][1] == 0.F && std::abs(points[k][0] - xi) > 0.02)
    {
      ++n_points;
      of_yy = std::max(of_yy, std::abs(yy[k][0] + std::sqrt(std::max(0., xi - points[k][0]))));
      of_xy = std::max<double>(of_xy, std::abs(xy[k][0]));
    }
  checks.that("run: points at the contact side", n_points > 30);
  checks.near("run: the stress there is the pressure", of_yy, 0., 2e-4);
  checks.near("run: no friction", of_xy, 0., 2e-4);

  double of_p = 0.;
  for (const auto &row : read_csv(read(directory / ("contact" + number + ".csv"))))
    if (std::abs(std::stod(row.at("x")) - xi) > 0.02)
      of_p = std::max(of_p, std::abs(std::stod(row.at("p_H")) - std::stod(row.at("p_exact"))));
  checks.near("run: pressure at all rows", of_p, 0., 2e-4);

  fs::remove_all(directory);
}
} // namespace

int main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  dealii::deal_II_exceptions::disable_abort_on_exception();
  Checks checks;
  const Columns4 example;
  fields(checks, example);
  curves(checks, example);
  run(checks);
  return checks.exit_code();
}
