// SPDX-License-Identifier: LGPL-2.1-or-later
// Solutions on meshes from files: constant strain is exact on straight bodies, a half disc from a
// file gives what the half disc of the catalogue gives, and the numbers of a file do not matter.

#include <signorini/base/text.h>

#include "study_helpers.h"
#include "tests.h"

using namespace Signorini;

namespace {
const std::string files = TEST_FILES, parts = PARTS;

/** The displacement is given on the other sides, and known everywhere. */
void check_constant_strain(Checks &checks, const std::string &file, const std::string &contact,
                           const std::string &held, const std::string &displacement,
                           const std::string &gap, const std::string &pressure, const double size) {
  std::string list;
  for (const std::string &side : split_words(held))
    list += (list.empty() ? "" : " | ") + side + ": " + displacement;
  const StudyResult<2> result =
    solve("", levels(0, 1,
                     {"Geometry/Shape=file", "Geometry/File=" + files + file,
                      "Material/Young's modulus=2.5", "Material/Poisson's ratio=0.25",
                      "Boundary/Contact=" + contact, "Boundary/Displacement=" + list,
                      "Contact/Gap=" + gap, "Exact solution/Displacement=" + displacement,
                      "Exact solution/Pressure=" + pressure}));
  checks.about(file);
  checks.near("levels", result.levels.size(), 2, 0);
  for (const LevelRecord &level : result.levels) {
    checks.near("u", level.displacement_errors->h1, 0., 1e-10 * size);
    checks.near("p", level.pressure_errors->l2, 0., 1e-10 * size);
  }
  checks.that("the equations hold", result.verdict.outcome == Outcome::certified);
}

void check_patch_tests(Checks &checks) {
  // lambda = mu = 1: sigma_yy = 0.001 - 3 * 0.002 and no shear.
  check_constant_strain(checks, "bracket_1.msh", "foot", "tip top back fillet rest",
                        "0.001*x; -0.002*y", "0", "-0.005", 80.);
  // Hydrostatic pressure on a hole with 16 flat facets: u.n is the same everywhere on it.
  check_constant_strain(checks, "plate_with_hole_1.msh", "hole", "left right top bottom",
                        "-0.01*(x - 1); -0.01*(y - 0.5)", "0.01*0.2*cos(pi/16)", "-0.04", 1.);
}

/** E3 of the catalogue on a mesh of the half disc from a file, which has as many cells as the
 * scene's on level 3, or a few less. */
void check_half_disc(Checks &checks) {
  const Scene<2> e3 = make_scene<2>(parse_parameters(named_scene("E3"), "test"));
  const StudyResult<2> built_in = solve(named_scene("E3"), levels(4, 6));
  for (const auto &[file, arcs] :
       {std::pair(parts + "half_disc.msh", ""), std::pair(files + "half_disc_1.msh", "arc")}) {
    checks.about(file);
    Scene<2> scene = e3;
    scene.geometry =
      make_scene<2>(parse_parameters("", "test",
                                     {"Geometry/Shape=file", "Geometry/File=" + file,
                                      std::string("Geometry/Arcs=") + arcs, "Boundary/Contact=arc",
                                      "Boundary/Clamped=flat"}))
        .geometry;
    for (unsigned int i = 0; i < 2; ++i)
      scene.boundary[scene.geometry.find_side(e3.geometry.sides[i].name())] = e3.boundary[i];
    const StudyResult<2> result =
      run(parse_parameters(named_scene("E3"), "test", levels(1, 3)), scene);
    for (const auto &[column, order] :
         {std::pair("u_h1", 1.), std::pair("u_l2", 2.), std::pair("p_l2", 1.),
          std::pair("u_superclose_h1", 1.7), std::pair("u_post_h1", 1.7)}) {
      const std::string name = column;
      checks.between("order of " + name, slope(result.levels, column), order - 0.15, 2.6);
      checks.between(name + " beside that of the built-in mesh",
                     last(result, column) / last(built_in, column), 0.2, 2.5);
    }
    checks.that("the same verdict", result.verdict.outcome == built_in.verdict.outcome);
    checks.near("the same energy", last(result, "energy") / last(built_in, "energy"), 1., 1e-3);
  }
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv, {check_patch_tests, check_half_disc});
}
