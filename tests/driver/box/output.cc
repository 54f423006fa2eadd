// SPDX-License-Identifier: LGPL-2.1-or-later
// Files about a box: the faces of its contact side, its cells with their stresses.

#include <signorini/discretization/space/nodes.h>
#include <signorini/results/output/contact_files.h>
#include <signorini/results/output/solution_vtu.h>

#include <array>
#include <filesystem>
#include <sstream>

#include "box.h"
#include "results/output/csv.h"
#include "results/output/vtu_reader.h"
#include "tests.h"

using namespace Signorini;

namespace {
/** p = -(1 + x + 2 y), at the bottom of 1 x 2. */
Scene<3> scene_with_pressure(const FunctionPointer<3> &u) {
  Scene<3> scene = make_box_scene(
    scalar([](const dealii::Point<3> &x) { return 0.2 + x[0] * x[1]; }), u, {1., 2., 1.});
  scene.contacts[0].exact_pressure =
    scalar([](const dealii::Point<3> &x) { return -(1. + x[0] + 2. * x[1]); });
  return scene;
}

void contact(Checks &checks) {
  const auto sinking = field([](const auto &x) { return Vector3({0.1 * x[1], 0., -0.3 - x[0]}); });
  const Scene<3> scene = scene_with_pressure(sinking);
  const Box box(scene, 3, 2);
  const Displacement U = interpolate_at_nodes(box.space, *sinking);
  const Pressure P = box.at_centres([](const auto &s) { return -(1. + s[0] + 2. * s[1]); });
  const auto area = trace_contact(box.body(U, P));
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
  double force = 0.;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double x = points[i][0], y = points[i][1];
    force += p[i][0] * (1. / 8.) * (2. / 8.) / 4.;
    checks.near("recovered pressure", recovered[i][0], 1. + x + 2. * y, 1e-6);
    checks.near("opening", opening[i][0], 0.2 + x * y - 0.3 - x, 1e-6);
    checks.near("displacement", {u[i][0], u[i][1], u[i][2]}, {0.1 * y, 0., -0.3 - x}, 1e-6);
  }
  // int (1 + x + 2 y) over 1 x 2.
  checks.near("sum of p times area", force, 7., 1e-5);
  checks.that("four points of a face, four faces of a patch",
              patch.size() == 256 && patch[0] == patch[3]);

  std::ostringstream csv;
  write_contact_csv(csv, area);
  const std::string columns = "side,x,y,z,p_H,p_recovered,u_n,g,p_exact,patch,patch_area\n";
  checks.that("columns", csv.str().rfind(columns, 0) == 0);
  const auto rows = read_csv(csv.str());
  checks.near("rows", rows.size(), 64, 0.);
  for (const auto &row : rows)
    checks.near("p_recovered, p_exact, patch_area",
                {std::stod(row.at("p_recovered")), std::stod(row.at("patch_area"))},
                {std::stod(row.at("p_exact")), 1. / 8.}, 1e-14);
}

/** u = (0.1 x + 0.2 y z, 0.3 y, x z): its stresses are linear, and patches of degree two know them.
 */
void body(Checks &checks) {
  const auto u = field([](const auto &x) {
    return Vector3({0.1 * x[0] + 0.2 * x[1] * x[2], 0.3 * x[1], x[0] * x[2]});
  });
  const Scene<3> scene = scene_with_pressure(u);
  const Box box(scene, 2, 2);
  std::ostringstream file;
  const Displacement U = interpolate_at_nodes(box.space, *u);
  solution_vtu(DisplacedBody(box.space, scene, U), {}, 0)(file);
  const std::string vtu = file.str();
  checks.that("64 hexahedra, eight of each parent",
              vtu.find("NumberOfPoints=\"216\" NumberOfCells=\"64\"") != std::string::npos);
  const PointField points = read_vtu_field(vtu, ""), stress = read_vtu_field(vtu, "stress"),
                   mises = read_vtu_field(vtu, "von_mises_stress"),
                   shear = read_vtu_field(vtu, "stress_yz"),
                   displacement = read_vtu_field(vtu, "displacement");
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double x = points[i][0], y = points[i][1], z = points[i][2];
    const double trace = lambda * (0.4 + x), xy = 0.2 * mu * z, xz = mu * (0.2 * y + z);
    const double xx = trace + 0.2 * mu, yy = trace + 0.6 * mu, zz = trace + 2. * mu * x;
    checks.near("stress", {stress[i].begin(), stress[i].end()},
                {xx, xy, xz, xy, yy, 0., xz, 0., zz}, 1e-6);
    const double a = xx - yy, b = yy - zz, c = zz - xx;
    checks.near("von Mises stress, displacement, components by name",
                {mises[i][0], displacement[i][0], displacement[i][2], shear[i][0]},
                {std::sqrt(0.5 * (a * a + b * b + c * c) + 3. * (xy * xy + xz * xz)),
                 0.1 * x + 0.2 * y * z, x * z, 0.},
                1e-6);
  }
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv, {contact, body});
}
