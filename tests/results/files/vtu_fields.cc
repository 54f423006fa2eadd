// SPDX-License-Identifier: LGPL-2.1-or-later
// The numbers in VTU files, against closed forms: stresses of constant strains in every kind of
// material, the parts of the bound, the contact line.

#include <signorini/results/files/contact_files.h>
#include <signorini/results/files/solution_vtu.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>

#include "one_level.h"
#include "tests.h"
#include "vtu_reader.h"

using namespace Signorini;

namespace
{
/** Components of a stress. */
struct Stress
{
  double xx, yy, zz, xy;
};

/** sigma at a point for the strains e11 = 0.1, e22 = 0.2, e12 = 0.3. */
using Law = std::function<Stress(double x, double y)>;

Stress isotropic(const double E, const double nu, const double lambda, const double nu_zz)
{
  const double mu = E / (2. * (1. + nu)), xx = lambda * 0.3 + 0.2 * mu,
               yy = lambda * 0.3 + 0.4 * mu;
  return {xx, yy, nu_zz * (xx + yy), 0.6 * mu};
}

Stress plane_strain(const double E, const double nu)
{
  return isotropic(E, nu, E * nu / ((1. + nu) * (1. - 2. * nu)), nu);
}

Stress plane_stress(const double E, const double nu)
{
  return isotropic(E, nu, E * nu / (1. - nu * nu), 0.);
}

/** Q11 = 4, Q22 = 1.2, Q12 = 0.5, Q66 = 0.6, Q31 = 0.7, Q32 = 0.2 in axes turned by 30 degrees:
 * strains into these axes, stresses back. */
Stress orthotropic()
{
  const double c = std::sqrt(0.75), s = 0.5, e11 = 0.1, e22 = 0.2, e12 = 0.3;
  const double first = c * c * e11 + s * s * e22 + 2. * s * c * e12;
  const double second = s * s * e11 + c * c * e22 - 2. * s * c * e12;
  const double shear = (e22 - e11) * s * c + e12 * (c * c - s * s);
  const double s11 = 4. * first + 0.5 * second, s22 = 0.5 * first + 1.2 * second, s12 = 1.2 * shear;
  return {c * c * s11 + s * s * s22 - 2. * s * c * s12,
          s * s * s11 + c * c * s22 + 2. * s * c * s12,
          0.7 * first + 0.2 * second,
          (s11 - s22) * s * c + s12 * (c * c - s * s)};
}

double von_mises_of(const Stress &s)
{
  return std::sqrt(
    0.5 * (std::pow(s.xx - s.yy, 2) + std::pow(s.yy - s.zz, 2) + std::pow(s.zz - s.xx, 2)) +
    3. * s.xy * s.xy);
}

/** Mohr's circle, and sigma_zz. */
std::array<double, 3> principal_stresses_of(const Stress &s)
{
  const double middle = 0.5 * (s.xx + s.yy), radius = std::hypot(0.5 * (s.xx - s.yy), s.xy);
  std::array<double, 3> principal = {middle + radius, middle - radius, s.zz};
  std::sort(principal.begin(), principal.end(), std::greater<>());
  return principal;
}

std::string read(const std::string &path)
{
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

std::string body_vtu(const OneLevel &level, const Displacement &U, const BoundFields &bound)
{
  const std::string file = "vtu_fields_solution.vtu";
  write_solution_vtu(file, level.space(), level.scene, U, bound, 7);
  const std::string text = read(file);
  std::filesystem::remove(file);
  return text;
}

/** The largest differences at all points of the file. */
void compare_stresses(Checks &checks,
                      const std::string &name,
                      const std::string &vtu,
                      const Law &law)
{
  const PointField points = read_vtu_field(vtu, ""), tensors = read_vtu_field(vtu, "stress"),
                   von_mises = read_vtu_field(vtu, "von_mises_stress");
  std::array<PointField, 3> principal;
  for (unsigned int i = 0; i < 3; ++i)
    principal[i] = read_vtu_field(vtu, "principal_stress_" + std::to_string(i + 1));
  const bool complete = !points.empty() && tensors.size() == points.size() &&
                        von_mises.size() == points.size() && principal[2].size() == points.size();
  checks.that(name + ": all points", complete);
  double of_tensor = 0., of_von_mises = 0., of_principal = 0.;
  for (std::size_t k = 0; complete && k < points.size(); ++k)
  {
    const Stress s = law(points[k][0], points[k][1]);
    const double expected[] = {s.xx, s.xy, 0., s.xy, s.yy, 0., 0., 0., s.zz};
    for (unsigned int i = 0; i < 9; ++i)
      of_tensor = std::max(of_tensor, std::abs(tensors[k][i] - expected[i]));
    of_von_mises = std::max(of_von_mises, std::abs(von_mises[k][0] - von_mises_of(s)));
    for (unsigned int i = 0; i < 3; ++i)
      of_principal =
        std::max(of_principal, std::abs(principal[i][k][0] - principal_stresses_of(s)[i]));
  }
  // Files hold 32-bit floats.
  checks.near(name + ": tensor", of_tensor, 0., 1e-6);
  checks.near(name + ": von Mises", of_von_mises, 0., 1e-6);
  checks.near(name + ": principal stresses", of_principal, 0., 1e-6);
}

void stresses(Checks &checks)
{
  const std::string E_and_nu = "set Young's modulus = 2.5\nset Poisson's ratio = 0.25\n";
  const std::string turned = "set Law = orthotropic\nset Orthotropic moduli = 4; 1.2; 0.5; 0.6\n"
                             "set Orientation = 30\nset Moduli across the plane = 0.7; 0.2\n";
  const std::string general = "set Law = general\nset Hooke tensor = 3+x; 1; 0.1; 4; 0.2; 1\n"
                              "set Moduli across the plane = 0.5; 0.25+y; 0.1\n";
  const std::string varying = "set Young's modulus = 1+x\nset Poisson's ratio = 0.25*(1-y)\n";
  const auto not_across = [](Stress stress) {
    stress.zz = 0.;
    return stress;
  };
  struct Case
  {
    std::string name, material, more;
    Law law;
  };
  const Case cases[] = {
    {"plane strain", E_and_nu, "", [](double, double) { return plane_strain(2.5, 0.25); }},
    {"B-bar",
     E_and_nu,
     entry("Discretization", "Element", "Q1 B-bar"),
     [](double, double) { return plane_strain(2.5, 0.25); }},
    {"plane stress",
     E_and_nu + "set Plane state = stress\n",
     "",
     [](double, double) { return plane_stress(2.5, 0.25); }},
    {"expressions",
     varying,
     "",
     [](double x, double y) { return plane_strain(1. + x, 0.25 * (1. - y)); }},
    {"orthotropic", turned, "", [](double, double) { return orthotropic(); }},
    {"orthotropic, plane stress",
     turned.substr(0, turned.find("set Moduli across")),
     "",
     [&](double, double) { return not_across(orthotropic()); }},
    {"general", general, "", [](double x, double y) {
       return Stress{0.1 * (3. + x) + 0.2 + 0.06,
                     0.1 + 0.8 + 0.12,
                     0.05 + 0.2 * (0.25 + y) + 0.06,
                     0.01 + 0.04 + 0.6};
     }}};
  for (const Case &c : cases)
    for (const unsigned int number : {0U, 2U})
    {
      const OneLevel level("subsection Boundary\nset Clamped = top\nset Contact = bottom\nend\n"
                           "subsection Material\n" +
                             c.material + "end\n" + c.more,
                           number);
      const Displacement U = nodal_values(level.space(), [](const dealii::Point<2> &x) {
        return dealii::Point<2>(0.1 * x[0] + 0.3 * x[1], 0.3 * x[0] + 0.2 * x[1]);
      });
      compare_stresses(checks,
                       c.name + " on level " + std::to_string(number),
                       body_vtu(level, U, BoundFields()),
                       c.law);
    }
}

/** The squares of the parts add up to that of the bound. */
void bound(Checks &checks)
{
  const OneLevel level(
    "subsection Boundary\nset Contact = bottom\nset Displacement = top: 0; -0.05\n"
    "end\n" +
      entry("Contact", "Gap", "(x-0.4)^2/4") + entry("Load", "Body force", "sin(5*x); 0") +
      entry("Discretization", "Finest level", "3"),
    3);
  const LevelSolution<2> solution = level.solve();
  const std::string body = body_vtu(level, solution.U, solution.bound_fields);
  std::ostringstream line;
  write_contact_vtu<2>(
    line,
    trace_contact(level.space(), level.multipliers(), level.scene.boundary, solution.U, solution.P),
    solution.bound_fields.contact);
  const PointField mesh = read_vtu_field(body, "bound_mesh"),
                   oscillation = read_vtu_field(body, "bound_oscillation"),
                   lift = read_vtu_field(body, "bound_lift"),
                   contact = read_vtu_field(line.str(), "bound_contact");
  // A cell has nine points with the same value, a face two: patches do not end inside of faces.
  checks.that("bound: one value for each cell and face",
              mesh.size() == 9 * 64 && contact.size() == 2 * 8);
  double sum = 0., largest_oscillation = 0.;
  for (std::size_t k = 0; k < mesh.size(); k += 9)
  {
    sum += std::pow(mesh[k][0] + oscillation[k][0], 2) + std::pow(lift[k][0], 2);
    largest_oscillation = std::max<double>(largest_oscillation, oscillation[k][0]);
  }
  for (std::size_t k = 0; k < contact.size(); k += 2)
    sum += std::pow(contact[k][0], 2);
  const double absolute = solution.record.bound->absolute.value_or(0.);
  checks.near("bound: the sum of its parts", std::sqrt(sum) / absolute, 1., 1e-6);
  checks.that("bound: the load oscillates, and bodies penetrate",
              largest_oscillation > 0. && solution.record.bound->contact.value_or(0.) > 0.);
  checks.that("bound: none, no fields",
              read_vtu_field(body_vtu(level, solution.U, BoundFields()), "bound_mesh").empty());
}

/** The fields along the bottom, whose numbers come from the same points as contact-LL.csv. */
void contact(Checks &checks)
{
  const OneLevel level("subsection Boundary\nset Clamped = top\nset Contact = bottom\nend\n" +
                         entry("Contact", "Gap", "0.1 + x^2"),
                       2);
  const Displacement U = nodal_values(level.space(), [](const dealii::Point<2> &x) {
    return dealii::Point<2>(x[0], 2. * x[0] - x[1]);
  });
  Pressure P(2);
  P[1] = -2.;
  std::ostringstream stream;
  write_contact_vtu<2>(
    stream, trace_contact(level.space(), level.multipliers(), level.scene.boundary, U, P), {});
  const PointField points = read_vtu_field(stream.str(), "");
  checks.that("contact line: two points for each face", points.size() == 8);
  double largest = 0.;
  const auto compare = [&](const std::string &name, const auto &expected) {
    const PointField field = read_vtu_field(stream.str(), name);
    for (std::size_t k = 0; k < points.size(); ++k)
      largest = std::max(
        largest, field.size() == 8 ? std::abs(field[k][0] - expected(points[k][0], k)) : 1.);
  };
  compare("contact_pressure", [](double, std::size_t k) { return k < 4 ? 0. : 2.; });
  compare("opening", [](double x, std::size_t) { return 0.1 + x * x + 2. * x; });
  compare("displacement", [](double x, std::size_t) { return x; });
  compare("side", [&](double, std::size_t) { return level.scene.geometry.find_side("bottom"); });
  checks.near("contact line: its fields", largest, 0., 1e-6);
}
} // namespace

int main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  dealii::deal_II_exceptions::disable_abort_on_exception();
  Checks checks;
  stresses(checks);
  bound(checks);
  contact(checks);
  return checks.exit_code();
}
