// SPDX-License-Identifier: LGPL-2.1-or-later
// Solutions on meshes from files: a half disc gives the answer of the half disc of the catalogue.

#include <signorini/verification/catalogue/catalogue.h>

#include "study_helpers.h"
#include "tests.h"

using namespace Signorini;

namespace {
const std::string files = SOURCE_DIR "/tests/problem/mesh_file/", parts = SOURCE_DIR "/prm/parts/";

/** E3 of the catalogue on a mesh of the half disc from a file, which has as many cells as the
 * scene's on level 3, or a few less. */
void check_half_disc(Checks &checks) {
  const Scene<2> e3 = make_scene<2>(parse_parameters(named_scene("E3"), "test"), named_scenes());
  const StudyResult<2> built_in = solve(named_scene("E3"), levels(4, 5));
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
    scene.contacts[0].side = scene.geometry.find_side("arc");
    const StudyResult<2> result =
      run(parse_parameters(named_scene("E3"), "test", levels(1, 2)), scene);
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
  return run_tests(argc, argv, {check_half_disc});
}
