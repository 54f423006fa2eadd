// SPDX-License-Identifier: LGPL-2.1-or-later
// The estimate where few patches press, or none although the body penetrates: it is not below half
// of the error, or too large to certify.
//
// The reference is u_f of a much finer mesh, nested in that of u_h. |||u_f - u_h||| is about
// |||u - u_h||| as long as u_f is much closer to u.

#include <signorini/discretization/space/internal_forces.h>

#include <deal.II/numerics/vector_tools.h>

#include <cmath>
#include <fstream>
#include <iomanip>
#include <sstream>

#include "one_level.h"
#include "tests.h"

using namespace Signorini;

namespace {
struct Given {
  std::string name, scene;
  unsigned int reference_level = 7;
};

template <typename Number>
std::string text(const Number &number) {
  std::ostringstream stream;
  stream << number;
  return stream.str();
}

/** Spheres and rollers that press a block, of the radius R, by the travel d. */
std::vector<Given> all_scenes() {
  const std::string wide = "Geometry/Lower left = -1, 0\nGeometry/Cells = 2, 1\n";
  std::vector<Given> scenes;
  // On the wide zone of the last size 1 to 30 patches press, on one level more.
  constexpr double widest = 10.;
  const auto add = [&](const std::string &law, const std::string &rest, const double R,
                       const double d, const std::string &centre = "0") {
    scenes.push_back({law + ", R = " + text(R) + ", d = " + text(d),
                      rest + "Boundary/Contact = bottom\nBoundary/Displacement = top: 0; -" +
                        text(d) + "\nContact/Gap = (x-" + centre + ")^2/" + text(2. * R) + "\n",
                      R < widest ? 7U : 8U});
  };
  const std::vector<std::pair<double, double>> sizes = {{1., 0.03},  {0.5, 0.002}, {0.15, 0.005},
                                                        {2., 0.005}, {5., 0.02},   {widest, 0.025}};
  for (const auto &[R, d] : sizes)
    add("revolution", "Material/Plane state = axisymmetric\n", R, d);
  for (const auto &[R, d] : sizes)
    add("Coulomb", wide + "Contact/Friction = coulomb\nContact/Friction coefficient = 0.3\n", R, d);
  for (const auto &[R, d] : sizes)
    add("plane, off nodes", wide, R, d, "0.0371");
  // A half disc of the radius R, lowered by d onto a plane, or onto a block of the modulus E.
  for (const auto &[R, d] : sizes)
    scenes.push_back({"half disc, R = " + text(R) + ", d = " + text(d * R),
                      "Geometry/Shape = half disc\nGeometry/Radius = " + text(R) +
                        "\nGeometry/Centre = 0, " + text(R) +
                        "\nBoundary/Contact = arc\nBoundary/Displacement = flat: 0; -" +
                        text(d * R) + "\nContact/Foundation = plane 0,0 normal 0,1\n"});
  for (const auto &[E, d] : std::vector<std::pair<double, double>>{
         {1., 0.04}, {1., 0.001}, {1., 0.005}, {0.1, 0.005}, {1., 0.02}, {10., 0.01}})
    scenes.push_back({"pair, E = " + text(E) + ", d = " + text(d),
                      "Geometry/Bodies = c b\nGeometry/Shape = c: half disc | b: rectangle\n"
                      "Geometry/Radius = c: 1\nGeometry/Centre = c: 0, 1\n"
                      "Geometry/Lower left = b: -1, -1\nGeometry/Upper right = b: 1, 0\n"
                      "Geometry/Cells = b: 4, 2\nMaterial/Young's modulus = c: 1 | b: " +
                        text(E) +
                        "\nBoundary/Contact = c.arc with b.top\nBoundary/Clamped = b.bottom\n"
                        "Boundary/Displacement = c.flat: 0; -" +
                        text(d) + "\n",
                      6});
  return scenes;
}

/** A row of estimate_few_patches.csv. */
void check(Checks &checks, std::ofstream &table, const Given &given, const OneLevel &fine,
           const Displacement &fine_U, const unsigned int number) {
  const OneLevel level(given.scene + "Discretization/Finest level = 14\n", number);
  const LevelSolution<2> solution = level.solve();
  const LevelRecord &record = solution.record;
  Displacement difference(fine_U);
  dealii::VectorTools::interpolate_to_different_mesh(
    level.space().dofs(), solution.contact.U.entries(), fine.space().dofs(), difference.entries());
  difference -= fine_U;
  const double error =
                 internal_forces(DisplacedBody(fine.space(), fine.scene, difference)).energy_norm,
               size = internal_forces(DisplacedBody(fine.space(), fine.scene, fine_U)).energy_norm;
  const ErrorEstimate estimate = record.estimate.value();
  checks.about(given.name + ", level " + std::to_string(number));
  checks.that("no estimate below half of the error certifies",
              estimate.energy >= 0.5 * error || estimate.relative > 0.2);
  checks.that("nor is it large without need", estimate.energy <= 2. * error);
  table << '"' << given.name << "\"," << number << ',' << record.contact.active << ','
        << std::setprecision(3) << error / size << ',' << estimate.relative << ','
        << estimate.energy / error << std::endl;
}

void few_patches(Checks &checks) {
  std::ofstream table("estimate_few_patches.csv");
  table << "scene,level,pressing,error_over_u,estimated_relative,estimate_over_error\n";
  const std::vector<Given> scenes = all_scenes();
  for (const Given &given : checks.rows(scenes, 5)) {
    // Every day the coarsest levels will do, on which contact is missed.
    const unsigned int n_less = checks.is_long() ? 0 : 2;
    const OneLevel fine(given.scene + "Discretization/Finest level = 14\n",
                        given.reference_level - n_less);
    const Displacement fine_U = fine.solve().contact.U;
    for (unsigned int number = 2; number + 2 <= given.reference_level - n_less; ++number)
      check(checks, table, given, fine, fine_U, number);
  }
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv, {few_patches});
}
