// SPDX-License-Identifier: LGPL-2.1-or-later
// Bodies in space from files: the numbers of an independent program (trilinear maps, patches by
// parents, true normals), and identities of contact on planes, cylinders and spheres.

#include <deal.II/base/tensor.h>

#include <cmath>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "study_helpers.h"
#include "tests.h"

using namespace Signorini;

namespace {
/** A scene, its last level, and the numbers of the other program there: the contact force, J, the
 * largest p_H and the area of the patches that press. */
struct Reference {
  std::string mesh, scene;
  unsigned int level;
  dealii::Tensor<1, 3> force;
  double energy, peak, area;
};

/** Solves a scene, one entry a line, on a mesh of this folder or of the parts of the scenes. */
StudyResult<3> solve_mesh(const std::string &mesh, const std::string &scene,
                          const unsigned int coarsest, const unsigned int finest) {
  const std::set<std::string> of_scenes = {"plate_on_pin", "rod_with_ball", "table_on_pads"};
  const std::string folder =
    of_scenes.count(mesh) > 0 ? SOURCE_DIR "/prm/parts/" : SOURCE_DIR "/tests/driver/study/solids/";
  std::vector<std::string> overrides =
    levels(coarsest, finest, {"Geometry/Shape=file", "Geometry/File=" + folder + mesh + ".msh"});
  std::istringstream lines(scene);
  for (std::string line; std::getline(lines, line);)
    overrides.push_back(line);
  return solve<3>("set Dimension = 3\n", overrides);
}

dealii::Tensor<1, 3> vector(const double x, const double y, const double z) {
  return dealii::Tensor<1, 3>({x, y, z});
}

const std::string on_sphere = "Boundary/Contact=bottom\nBoundary/Rollers=left front\n"
                              "Boundary/Displacement=top: 0; 0; -0.1\n"
                              "Contact/Foundation=sphere 0,0,-1 radius 1\n";
const std::string cylinder_on_plane =
  "Boundary/Contact=round\nBoundary/Rollers=middle end0 end1\nBoundary/Displacement=top: 0; 0; "
  "-0.1\n"
  "Contact/Foundation=plane 0,0,-1 normal 0,0,1\nContact/Direction=body\n";
const std::string on_pin =
  "Boundary/Contact=hole\nBoundary/Rollers=middle z0 z1\nBoundary/Displacement=right: 0.05; 0; 0\n"
  "Contact/Foundation=cylinder 0,0,0 axis 0,0,1 radius 0.98\n";
const std::string on_two_planes =
  "Boundary/Contact=bottom left\nBoundary/Rollers=front\n"
  "Boundary/Displacement=top: -0.02; 0; -0.03\nContact/Direction=body\n"
  "Contact/Foundation=bottom: plane 0,0,0 normal 0,0.05,1 | left: plane 0,0,0 normal 1,0,0.1\n";
const std::string in_socket =
  "Boundary/Contact=ball\nBoundary/Rollers=x0 y0\nBoundary/Displacement=top: 0; 0; -0.02\n"
  "Contact/Foundation=sphere 0,0,0.05 radius 1.05 inside\n";
const std::string by_force = "Boundary/Contact=ball\nBoundary/Rollers=x0 y0\n"
                             "Boundary/Plates=top: 0, 0, -1\nLoad/Plate force=top: 0.00036\n"
                             "Contact/Foundation=plane 0,0,-1 normal 0,0,1\n"
                             "Contact/Direction=body\n";
const std::string on_pads = "Boundary/Contact=pad1 pad2 pad3\nLoad/Body force=0; 0; -1\n"
                            "Boundary/Traction=top: 0; 0; -0.2*x\nContact/Gap=0\n";

const std::vector<Reference> references = {
  {"cube", on_sphere, 2, vector(0., 0., 1.5457589965e-2), 6.0942978327e-4, 2.4732143944e-1,
   6.25e-2},
  {"cube", on_sphere, 3, vector(0., 0., 1.5417433958e-2), 5.8776774591e-4, 2.3974513392e-1,
   9.375e-2},
  {"quarter_cylinder", cylinder_on_plane, 3, vector(-2.2969452698e-3, 0., 2.0944511367e-2),
   9.5446750818e-4, 2.0308297076e-1, 1.9627069731e-1},
  {"plate_on_pin", on_pin, 2, vector(-1.3712754198e-3, 7.5061609270e-4, 0.), 1.8112905816e-5,
   9.8426638409e-3, 2.9405142099e-1},
  {"plate_on_pin", on_pin, 3, vector(-1.3481322334e-3, 7.7282309191e-4, 0.), 1.7586871107e-5,
   8.1734158761e-3, 2.4533837164e-1},
  {"distorted_cube", on_two_planes, 2, vector(1.9614367795e-3, 0., 1.1741252631e-2),
   1.4179373713e-4, 5.3022318564e-2, 5.275e-1},
  {"distorted_cube", on_two_planes, 3, vector(2.7970565163e-3, 0., 1.1744068768e-2),
   1.5491666481e-4, 7.6327822825e-2, 5.34375e-1},
  {"ball_octant", in_socket, 2, vector(-1.8285954675e-3, -1.8285954675e-3, 6.6507252633e-3),
   4.9085447287e-5, 3.2056721569e-2, 4.0816370262e-1},
  {"ball_octant", in_socket, 3, vector(-1.7425555316e-3, -1.7425555316e-3, 6.5397725896e-3),
   5.0346402406e-5, 3.0530374314e-2, 3.8103168772e-1},
  {"rod_with_ball", by_force, 2, vector(-1.3293668610e-5, -1.3293668610e-5, 3.6e-4),
   -1.9524524371e-6, 6.5644590287e-2, 5.4940677640e-3},
  {"rod_with_ball", by_force, 3, vector(-1.3283028590e-5, -1.3283028590e-5, 3.6e-4),
   -2.0168118298e-6, 6.7187353711e-2, 8.1954698506e-3},
  {"table_on_pads", on_pads, 1, vector(0., 0., 7.8), -3.1438167747e+1, 15.6, 0.75},
  {"table_on_pads", on_pads, 2, vector(0., 0., 7.8), -2.8179695164e+1, 26.955895595, 0.625}};

void test_references(Checks &checks) {
  for (const Reference &known : references) {
    checks.about(known.mesh + ", level " + std::to_string(known.level));
    const StudyResult<3> result = solve_mesh(known.mesh, known.scene, 1, known.level);
    checks.that("equations hold", result.verdict.equations_hold());
    const Answer &answer = result.levels.back().answer;
    // Components that are zero by symmetry are not told by the other program.
    for (unsigned int d = 0; d < 3; ++d)
      if (known.force[d] != 0.)
        checks.near("force " + std::to_string(d), answer.contact_force.resultant.force[d],
                    known.force[d], 1e-8 * known.force.norm());
    checks.near("J", last(result, "energy"), known.energy, 1e-8 * std::abs(known.energy));
    checks.near("area", result.levels.back().contact.length, known.area, 1e-8 * known.area);
    checks.near("largest p_H", result.pressure.P.linfty_norm(), known.peak, 1e-7 * known.peak);
  }
  checks.about("");
}

/** Three pads carry a table in shares that statics tells where each has one patch; with more of
 * them the other program tells the shares. */
void test_pads(Checks &checks) {
  const StudyResult<3> result = solve_mesh("table_on_pads", on_pads, 1, 2);
  const std::vector<std::vector<double>> expected = {{1.2, 2.7, 3.9},
                                                     {1.323655142, 2.686663355, 3.789681503}};
  for (std::size_t i = 0; i < 2; ++i) {
    const Answer &answer = result.levels[i].answer;
    std::vector<double> forces;
    for (const ContactForce &force : answer.contact_by_side)
      forces.push_back(force.resultant.force[2]);
    checks.near("forces of the pads", forces, expected[i], i == 0 ? 1e-11 : 1e-8);
    // Weight 6 in (1.5, 1), and the traction.
    checks.near("moment", answer.contact_force.resultant.moment, {7.8, -12.6, 0.}, 1e-10);
    checks.near("sliding and turning are not determined",
                result.levels[i].motions.undetermined.size(), 3, 0);
  }
}

/** The force of a given travel causes that travel. */
void test_force_and_travel(Checks &checks) {
  const StudyResult<3> result =
    solve_mesh("ball_octant",
               "Boundary/Contact=ball\nBoundary/Rollers=x0 y0\nBoundary/Plates=top: 0, 0, -1\n"
               "Load/Plate force=top: 6.5397725896e-3\n"
               "Contact/Foundation=sphere 0,0,0.05 radius 1.05 inside\n",
               1, 3);
  checks.near("travel", result.levels.back().motions.plates.at(0).travel, 0.02, 1e-9);
  checks.near("force across", result.levels.back().answer.contact_force.resultant.force[0],
              -1.7425555316e-3, 1e-10);
}

/** Cubes that rollers hold on three sides, compressed by 2 %: p_H = -0.02, J = 2e-4. At the edges
 * of these sides no tetrahedron has faces on both. */
void test_compression(Checks &checks) {
  for (const std::string mesh : {"tetrahedra", "distorted_cube"}) {
    checks.about(mesh);
    const StudyResult<3> result = solve_mesh(
      mesh, "Boundary/Contact=top\nBoundary/Rollers=left front bottom\nContact/Gap=-0.02\n", 1, 2);
    checks.that("equations hold", result.verdict.equations_hold());
    checks.near("J", last(result, "energy"), 2e-4, 1e-13);
    for (const double p : result.pressure.P)
      checks.near("p_H", p, -0.02, 1e-10);
  }
}

/** A tube on rollers inside and at its ends is compressed from outside, plane strain: u_r = A (r -
 * 1/r), p = λ 2A + 2μ A (1 + 1/4) outside. Nothing stops it from turning. */
void test_tube(Checks &checks) {
  checks.about("a tube on a round roller");
  const StudyResult<3> result =
    solve<3>("set Dimension = 3\n",
             levels(1, 3,
                    {"Geometry/Shape=tube", "Geometry/Radius=2", "Geometry/Inner radius=1",
                     "Geometry/Length=0.5", "Boundary/Contact=outer",
                     "Boundary/Rollers=bottom top inner", "Contact/Gap=-0.01"}));
  checks.that("equations hold", result.verdict.equations_hold());
  const double A = -0.01 / 1.5, lambda = 0.3 / (1.3 * 0.4), mu = 1. / 2.6;
  const double exact = -A * (2. * lambda + 2.5 * mu);
  std::vector<double> errors;
  for (const LevelRecord &level : result.levels)
    errors.push_back(std::abs(level.answer.peak_pressure->mean / exact - 1.));
  checks.between("order of the pressure", std::log2(errors[1] / errors[2]), 1.8, 2.2);
  checks.near("its error", errors[2], 0., 1e-3);
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(
    argc, argv, {test_references, test_pads, test_force_and_travel, test_compression, test_tube});
}
