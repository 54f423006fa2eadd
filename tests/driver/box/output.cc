// SPDX-License-Identifier: LGPL-2.1-or-later
// Files about a box: the faces of its contact side, its cells with their stresses.

#include <signorini/discretization/elasticity/integration.h>
#include <signorini/results/files/contact_files.h>
#include <signorini/results/files/solution_vtu.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "box.h"
#include "results/files/vtu_reader.h"
#include "tests.h"

using namespace Signorini;

namespace
{
/** p = -(1 + x + 2 y), at the bottom of 1 x 2. */
Scene<3> scene_with_pressure(const FunctionPointer<3> &u)
{
  Scene<3> scene = make_box_scene(
    scalar([](const dealii::Point<3> &x) { return 0.2 + x[0] * x[1]; }), u, {1., 2., 1.});
  scene.boundary[scene.geometry.find_side("bottom")].exact_pressure =
    scalar([](const dealii::Point<3> &x) { return -(1. + x[0] + 2. * x[1]); });
  return scene;
}

std::vector<std::string> split(const std::string &line)
{
  std::vector<std::string> fields;
  std::istringstream stream(line);
  for (std::string field; std::getline(stream, field, ',');)
    fields.push_back(field);
  return fields;
}

void contact(Checks &checks)
{
  const auto sinking = field([](const auto &x) { return Vector3({0.1 * x[1], 0., -0.3 - x[0]}); });
  const Scene<3> scene = scene_with_pressure(sinking);
  const Box box(scene, 3, 2);
  const Displacement U = interpolate_at_nodes(box.space, *sinking);
  Pressure P(box.multipliers.n_multipliers());
  for (unsigned int tau = 0; tau < P.size(); ++tau)
  {
    const dealii::Point<2> s = box.surface.patches()[tau].centre();
    P[tau] = -(1. + s[0] + 2. * s[1]);
  }
  const auto area = trace_contact(box.space, box.multipliers, scene.boundary, U, P);
  std::ostringstream vtu;
  write_contact_vtu(vtu, area, {});
  checks.that("64 quadrilaterals",
              vtu.str().find("NumberOfPoints=\"256\" NumberOfCells=\"64\"") != std::string::npos);
  const PointField points = read_vtu_field(vtu.str(), ""),
                   p = read_vtu_field(vtu.str(), "contact_pressure"),
                   recovered = read_vtu_field(vtu.str(), "recovered_contact_pressure"),
                   opening = read_vtu_field(vtu.str(), "opening"),
                   u = read_vtu_field(vtu.str(), "displacement"),
                   patch = read_vtu_field(vtu.str(), "patch");
  double force = 0., recovery_error = 0., opening_error = 0., displacement_error = 0.;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const double x = points[i][0], y = points[i][1];
    force += p[i][0] * (1. / 8.) * (2. / 8.) / 4.;
    recovery_error =
      std::max<double>(recovery_error, std::abs(recovered[i][0] - (1. + x + 2. * y)));
    opening_error =
      std::max<double>(opening_error, std::abs(opening[i][0] - (0.2 + x * y - 0.3 - x)));
    displacement_error = std::max<double>({displacement_error,
                                           std::abs(u[i][0] - 0.1 * y),
                                           std::abs(u[i][1]),
                                           std::abs(u[i][2] + 0.3 + x)});
  }
  // int (1 + x + 2 y) over 1 x 2.
  checks.near("sum of p times area", force, 7., 1e-5);
  checks.near("recovered pressure", recovery_error, 0., 1e-6);
  checks.near("opening", opening_error, 0., 1e-6);
  checks.near("displacement", displacement_error, 0., 1e-6);
  checks.that("four points of a face, four faces of a patch",
              patch.size() == 256 && patch[0] == patch[3]);

  std::ostringstream csv;
  write_contact_csv(csv, area);
  std::istringstream rows(csv.str());
  std::string row;
  std::getline(rows, row);
  checks.that("columns", row == "side,x,y,z,p_H,p_recovered,u_n,g,p_exact,patch,patch_area");
  double error = 0.;
  unsigned int n = 0;
  for (; std::getline(rows, row); ++n)
  {
    const std::vector<std::string> fields = split(row);
    const auto number = [&](const unsigned int i) { return std::stod(fields.at(i)); };
    const double x = number(1), y = number(2), exact = -(1. + x + 2. * y);
    error = std::max({error,
                      std::abs(number(3)),
                      std::abs(number(4) - P[std::stoul(fields.at(9))]),
                      std::abs(number(5) - exact),
                      std::abs(number(6) - (0.3 + x)),
                      std::abs(number(7) - (0.2 + x * y)),
                      std::abs(number(8) - exact),
                      std::abs(number(10) - 1. / 8.)});
  }
  checks.that("64 rows", n == 64);
  checks.near("their numbers", error, 0., 1e-14);
}

/** u = (0.1 x + 0.2 y z, 0.3 y, x z): its stresses are linear, and patches of degree two know them.
 */
void body(Checks &checks)
{
  const auto u = field([](const auto &x) {
    return Vector3({0.1 * x[0] + 0.2 * x[1] * x[2], 0.3 * x[1], x[0] * x[2]});
  });
  const Scene<3> scene = scene_with_pressure(u);
  const Box box(scene, 2, 2);
  const std::string file = "box_output.vtu";
  write_solution_vtu(file, box.space, scene, interpolate_at_nodes(box.space, *u), {}, 0);
  std::ifstream stream(file);
  std::ostringstream text;
  text << stream.rdbuf();
  std::filesystem::remove(file);
  const std::string vtu = text.str();
  checks.that("64 hexahedra",
              vtu.find("NumberOfPoints=\"512\" NumberOfCells=\"64\"") != std::string::npos);
  const PointField points = read_vtu_field(vtu, ""), stress = read_vtu_field(vtu, "stress"),
                   mises = read_vtu_field(vtu, "von_mises_stress"),
                   shear = read_vtu_field(vtu, "stress_yz"),
                   displacement = read_vtu_field(vtu, "displacement");
  double stress_error = 0., mises_error = 0., displacement_error = 0.;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const double x = points[i][0], y = points[i][1], z = points[i][2];
    const double trace = 0.4 + x, xy = 0.2 * mu * z, xz = mu * (0.2 * y + z);
    const std::array<double, 9> expected = {{lambda * trace + 0.2 * mu,
                                             xy,
                                             xz,
                                             xy,
                                             lambda * trace + 0.6 * mu,
                                             0.,
                                             xz,
                                             0.,
                                             lambda * trace + 2. * mu * x}};
    for (unsigned int k = 0; k < 9; ++k)
      stress_error = std::max(stress_error, std::abs(stress[i][k] - expected[k]));
    const double a = expected[0] - expected[4], b = expected[4] - expected[8],
                 c = expected[8] - expected[0];
    mises_error = std::max(
      mises_error,
      std::abs(mises[i][0] - std::sqrt(0.5 * (a * a + b * b + c * c) + 3. * (xy * xy + xz * xz))));
    displacement_error = std::max<double>({displacement_error,
                                           std::abs(displacement[i][0] - 0.1 * x - 0.2 * y * z),
                                           std::abs(displacement[i][2] - x * z)});
  }
  checks.near("stress", stress_error, 0., 1e-6);
  checks.near("von Mises stress", mises_error, 0., 1e-6);
  checks.near("displacement", displacement_error, 0., 1e-6);
  checks.that("components by name", !shear.empty() && std::abs(shear[7][0]) < 1e-6);
}
} // namespace

int main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  Checks checks;
  contact(checks);
  body(checks);
  return checks.exit_code();
}
