// SPDX-License-Identifier: LGPL-2.1-or-later
// The numbers in VTU files, against closed forms: stresses of constant strains in every kind of
// material, the parts of the bound.

#include <signorini/results/output/contact_files.h>
#include <signorini/results/output/solution_vtu.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <functional>

#include "one_level.h"
#include "tests.h"
#include "vtu_reader.h"

using namespace Signorini;

namespace {
/** sigma_xx, sigma_yy, sigma_zz, sigma_xy at a point for the strains e11 = 0.1, e22 = 0.2, e12 =
 * 0.3. */
using Law = std::function<std::array<double, 4>(double x, double y)>;

std::array<double, 4> plane_strain(const double E, const double nu) {
  const double lambda = E * nu / ((1. + nu) * (1. - 2. * nu)), mu = E / (2. * (1. + nu));
  return {0.3 * lambda + 0.2 * mu, 0.3 * lambda + 0.4 * mu, 0.3 * lambda, 0.6 * mu};
}

const std::string held = "subsection Boundary\nset Clamped = top\nset Contact = bottom\nend\n";

std::string body_vtu(const OneLevel &level, const Displacement &U, const BoundFields &bound) {
  std::ostringstream file;
  solution_vtu(level.body(U), bound, 7)(file);
  return file.str();
}

/** At all points of the file; it holds 32-bit floats. */
void compare_stresses(Checks &checks, const std::string &vtu, const Law &law) {
  const PointField points = read_vtu_field(vtu, ""), tensors = read_vtu_field(vtu, "stress"),
                   von_mises = read_vtu_field(vtu, "von_mises_stress");
  std::array<PointField, 3> principal;
  for (unsigned int i = 0; i < 3; ++i)
    principal[i] = read_vtu_field(vtu, "principal_stress_" + std::to_string(i + 1));
  checks.that("points", !points.empty());
  for (std::size_t k = 0; k < points.size(); ++k) {
    const auto [xx, yy, zz, xy] = law(points[k][0], points[k][1]);
    checks.near("tensor", {tensors.at(k).begin(), tensors[k].end()},
                {xx, xy, 0., xy, yy, 0., 0., 0., zz}, 1e-6);
    checks.near(
      "von Mises", von_mises.at(k)[0],
      std::sqrt(0.5 * (std::pow(xx - yy, 2) + std::pow(yy - zz, 2) + std::pow(zz - xx, 2)) +
                3. * xy * xy),
      1e-6);
    // Mohr's circle, and sigma_zz.
    const double middle = 0.5 * (xx + yy), radius = std::hypot(0.5 * (xx - yy), xy);
    std::vector<double> expected = {middle + radius, middle - radius, zz};
    std::sort(expected.begin(), expected.end(), std::greater<>());
    checks.near("principal stresses",
                {principal[0].at(k)[0], principal[1].at(k)[0], principal[2].at(k)[0]}, expected,
                1e-6);
  }
}

/** Other laws are compared in tests/problem/scene/scenes.cc. */
void stresses(Checks &checks) {
  struct Case {
    std::vector<std::string> settings;
    Law law;
  };
  const Law usual = [](double, double) { return plane_strain(1., 0.3); };
  for (
    const Case &c : std::vector<Case>{
      {{}, usual},
      {{"Discretization/Element=Q1 B-bar"}, usual},
      {{"Material/Young's modulus=1+x", "Material/Poisson's ratio=0.25*(1-y)"},
       [](double x, double y) { return plane_strain(1. + x, 0.25 * (1. - y)); }},
      {{"Material/Law=general", "Material/Hooke tensor=3+x; 1; 0.1; 4; 0.2; 1",
        "Material/Moduli across the plane=0.5; 0.25+y; 0.1"},
       [](double x, double y) {
         return std::array<double, 4>{0.1 * (3. + x) + 0.26, 1.02, 0.11 + 0.2 * (0.25 + y), 0.65};
       }}})
    for (const unsigned int number : {0U, 2U}) {
      const OneLevel level(held, number, c.settings);
      const Displacement U = nodal_values(level.space(), [](const dealii::Point<2> &x) {
        return dealii::Point<2>(0.1 * x[0] + 0.3 * x[1], 0.3 * x[0] + 0.2 * x[1]);
      });
      checks.about(c.settings.empty() ? "usual" : c.settings[0]);
      compare_stresses(checks, body_vtu(level, U, BoundFields()), c.law);
    }
}

/** The squares of the parts add up to that of the bound. */
void bound(Checks &checks) {
  const OneLevel level("", 3,
                       {"Boundary/Contact=bottom", "Boundary/Displacement=top: 0; -0.05",
                        "Contact/Gap=(x-0.4)^2/4", "Load/Body force=sin(5*x); 0",
                        "Discretization/Target error=1e-9"});
  const LevelSolution<2> solution = level.solve();
  const std::string body = body_vtu(level, solution.contact.U, solution.bound_fields);
  std::ostringstream line;
  write_contact_vtu<2>(line, trace_contact(level.body(solution.contact.U, solution.contact.P)),
                       solution.bound_fields.contact);
  const PointField mesh = read_vtu_field(body, "bound_mesh"),
                   oscillation = read_vtu_field(body, "bound_oscillation"),
                   lift = read_vtu_field(body, "bound_lift"),
                   contact = read_vtu_field(line.str(), "bound_contact");
  // A cell has nine points with the same value, a face two: patches do not end inside of faces.
  checks.that("bound: one value for each cell and face",
              mesh.size() == 9 * 64 && contact.size() == 2 * 8);
  double sum = 0., largest_oscillation = 0.;
  for (std::size_t k = 0; k < mesh.size(); k += 9) {
    sum += std::pow(mesh[k][0] + oscillation[k][0], 2) + std::pow(lift[k][0], 2);
    largest_oscillation = std::max<double>(largest_oscillation, oscillation[k][0]);
  }
  for (std::size_t k = 0; k < contact.size(); k += 2)
    sum += std::pow(contact[k][0], 2);
  const double absolute = solution.record.bound->absolute.value_or(0.);
  checks.near("bound: the sum of its parts", std::sqrt(sum) / absolute, 1., 1e-6);
  checks.that("bound: the load oscillates, and bodies penetrate",
              largest_oscillation > 0. && solution.record.bound->contact.value_or(0.) > 0.);
  checks.near("the side is a field", read_vtu_field(line.str(), "side").at(0)[0],
              level.scene.geometry.find_side("bottom"), 0.);
  checks.that(
    "bound: none, no fields",
    read_vtu_field(body_vtu(level, solution.contact.U, BoundFields()), "bound_mesh").empty());
}

/** A body is one piece of the file, a large one several; pieces have all of its cells. */
void pieces(Checks &checks) {
  for (const auto &[cells, n_expected] : {std::pair("3, 3", 1U), {"65, 66", 5U}}) {
    const OneLevel level(held, 2, {std::string("Geometry/Cells=") + cells});
    const std::string vtu =
      body_vtu(level, Displacement(level.space().dofs().n_dofs()), BoundFields());
    unsigned int n_pieces = 0, n_cells = 0;
    const std::string count = "NumberOfCells=\"";
    for (std::size_t at = vtu.find(count); at != std::string::npos; at = vtu.find(count, at + 1)) {
      ++n_pieces;
      n_cells += std::stoul(vtu.substr(at + count.size()));
    }
    checks.near("pieces", n_pieces, n_expected, 0.);
    checks.near("every cell in four parts", n_cells,
                4 * level.space().mesh().triangulation().n_active_cells(), 0.);
  }
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv, {stresses, bound, pieces});
}
