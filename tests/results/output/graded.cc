// SPDX-License-Identifier: LGPL-2.1-or-later
// The output on elements of several degrees: fields and curves of polynomials, and the
// files of a run.

#include <signorini/results/output/contact_files.h>
#include <signorini/results/output/solution_vtu.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "csv.h"
#include "one_level.h"
#include "tests.h"
#include "vtu_reader.h"

using namespace Signorini;
namespace fs = std::filesystem;

namespace {
/** u = (x² + x y, y² - 2 x y). */
const Field quadratic = [](const dealii::Point<2> &x) {
  return dealii::Point<2>(x[0] * x[0] + x[0] * x[1], x[1] * x[1] - 2. * x[0] * x[1]);
};

/** The unit square with 4 x 4 cells, whose degrees are 2, 3, 4, 5 from left to right. */
class Columns4 {
public:
  Columns4()
    : level("", 2,
            {"Boundary/Contact=bottom", "Boundary/Clamped=top", "Material/Young's modulus=2.5",
             "Material/Poisson's ratio=0.25", "Contact/Gap=0.1 + x^2"})
    , space(mesh(), level.scene, degrees())
    , surface(mesh(), level.scene, degrees())
    , multipliers(surface, {1, 2, 3, 4})
    , U(nodal_values(space, quadratic)) {}

  const Mesh<2> &mesh() const {
    return level.discretization.mesh;
  }
  std::vector<unsigned int> degrees() const {
    std::vector<unsigned int> degrees;
    for (const auto &cell : mesh().triangulation().active_cell_iterators())
      degrees.push_back(2 + static_cast<unsigned int>(4. * cell->center()[0]));
    return degrees;
  }
  DisplacedBody<2> body() const {
    return {space, level.scene, U};
  }

  OneLevel level;
  DisplacementSpace<2> space;
  ContactSurface<2> surface;
  MultiplierSpace<2> multipliers;
  Displacement U;
};

/** In plane strain with E = 2.5, nu = 1/4: lambda = mu = 1. */
void fields(Checks &checks, const Columns4 &example) {
  std::ostringstream file;
  solution_vtu(example.body(), BoundFields(), 3)(file);
  const std::string vtu = file.str();
  const PointField points = read_vtu_field(vtu, ""), stress = read_vtu_field(vtu, "stress"),
                   u = read_vtu_field(vtu, "displacement"), degree = read_vtu_field(vtu, "degree");
  // Four cells of every degree p, with (p + 1)² points each.
  checks.that("cells of degree p are divided into p x p",
              points.size() == 4 * (9 + 16 + 25 + 36) && stress.size() == points.size() &&
                u.size() == points.size() && degree.size() == points.size());
  for (std::size_t k = 0; k < points.size(); ++k) {
    const double x = points[k][0], y = points[k][1], e11 = 2. * x + y, e22 = 2. * y - 2. * x;
    checks.near("displacement", {u[k][0], u[k][1]}, {x * x + x * y, y * y - 2. * x * y}, 1e-6);
    checks.near("stress", {stress[k][0], stress[k][1], stress[k][4], stress[k][8]},
                {3. * e11 + e22, x - 2. * y, e11 + 3. * e22, e11 + e22}, 3e-6);
    checks.near("degree", (degree[k][0] - 1.5) / 4., x, 0.13);
  }
  checks.that("the number of the step is the time",
              vtu.find("Name=\"TIME\" NumberOfTuples=\"1\" format=\"ascii\">3<") != vtu.npos);
  checks.that("no recovered displacement", vtu.find("recovered_displacement") == std::string::npos);
}

/** p_H = -(1 + x - x³) on faces with at least four nodes, and its values with fewer nodes. */
void curves(Checks &checks, const Columns4 &example) {
  const auto p = [](const double x) { return -1. - x + x * x * x; };
  const MultiplierSpace<2> &multipliers = example.multipliers;
  Pressure P(multipliers.n_multipliers());
  for (unsigned int k = 0; k < P.size(); ++k)
    P[k] = p(multipliers.node(k)[0]);
  const auto line = trace_contact(BodyInContact<2>(example.body(), multipliers, P));
  std::ostringstream csv, stream;
  write_contact_csv<2>(csv, line);
  write_contact_vtu<2>(stream, line, {});
  const auto rows = read_csv(csv.str());
  checks.that("ends, nodes and middles of every face", rows.size() == 5 + 7 + 9 + 11);
  double before = 0.;
  for (const auto &row : rows) {
    const auto number = [&](const char *name) { return std::stod(row.at(name)); };
    const double x = number("x"), s = number("s");
    checks.that("in the order of arc length", s >= before);
    before = s;
    if (row.at("patch") == "3")
      checks.near("a polynomial of degree three", number("p_H"), p(x), 1e-14);
    // u_n = -u_2 = 0 at y = 0.
    checks.near("arc length, displacement and gap", {s, number("u_n"), number("g")},
                {x, 0., 0.1 + x * x}, 1e-14);
  }
  checks.near("the end", before, 1., 0.);
  const PointField points = read_vtu_field(stream.str(), ""),
                   pressure = read_vtu_field(stream.str(), "contact_pressure");
  checks.that("curve: an interval between two rows", points.size() == 2 * (4 + 6 + 8 + 10));
  for (std::size_t k = 0; k < pressure.size(); ++k)
    if (points[k][0] > 0.76)
      checks.near("curve: pressure", pressure[k][0], -p(points[k][0]), 1e-6);
  P.add(-2. * P[0]);
  const auto open = trace_contact(BodyInContact<2>(example.body(), multipliers, P));
  checks.that("p_recovered is cut at zero",
              open[0].rows[0].p_H > 0. && open[0].rows[0].p_recovered == 0.);
}

} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv, {[](Checks &checks) {
                     const Columns4 example;
                     fields(checks, example);
                     curves(checks, example);
                   }});
}
