// SPDX-License-Identifier: LGPL-2.1-or-later
// Whole runs in space: exact answers, orders, materials, Hertz' sphere.

#include <deal.II/base/numbers.h>

#include <tuple>

#include "study_helpers.h"
#include "tests.h"

using namespace Signorini;

namespace {
using Levels = std::vector<LevelRecord>;

/** A file of prm/space, whose equations hold. */
StudyResult<3> solve_prm(Checks &checks, const std::string &name,
                         const std::vector<std::string> &overrides = {}) {
  checks.about(name);
  const StudyResult<3> result = solve_file<3>(SOURCE_DIR "/prm/space/" + name + ".prm", overrides);
  checks.that("equations hold", result.verdict.equations_hold());
  return result;
}

void check_exact_scenes(Checks &checks) {
  for (const auto &overrides : {levels(1, 3), levels(2, 3, {"Discretization/Patch ratio=4"}),
                                levels(1, 2, {"Discretization/Element=Q2"})})
    for (const LevelRecord &level : solve_prm(checks, "patch_test", overrides).levels) {
      checks.near("u", level.displacement_errors->h1, 0., 1e-12);
      checks.near("p", level.pressure_errors->l2, 0., 1e-11);
    }
  const StudyResult<3> block = solve_prm(checks, "own_weight");
  for (const LevelRecord &level : block.levels) {
    checks.near("nodal values", level.displacement_errors->superclose_h1, 0., 1e-11);
    checks.near("p", level.pressure_errors->l2, 0., 1e-11);
    checks.near("contact force", level.contact.normal_force, 0.7, 1e-11);
  }
  check_orders(checks, Levels(block.levels.end() - 2, block.levels.end()), {{"u_h1", 0.99, 1.01}});
  // u is a polynomial of degree two.
  checks.near("pi^{2h}", last(block, "u_post_h1"), 0., 1e-11);
}

/** Orders one, two, and three halves to two. */
void check_last_orders(Checks &checks) {
  for (const std::string &name : checks.rows<std::string>({"d3", "v3"}, 1)) {
    const StudyResult<3> result = solve_prm(checks, name);
    check_orders(checks, Levels(result.levels.end() - 2, result.levels.end()),
                 {{"u_h1", 0.9, 1.1},
                  {"p_l2", 0.9, 1.1},
                  {"u_post_h1", 1.8, 2.2},
                  {"u_post4_h1", 1.9, 2.6},
                  {"u_superclose_h1", 1.8, 2.6},
                  {"p_post_l2", 1.5, 2.2},
                  {"p_dual_spectral", 1.4, 2.0}});
    checks.near("effectivity", last(result, "effectivity"), 1., 0.1);
  }
}

/** An isotropic tensor given by its 21 entries, and the same with 4 x 4 faces per patch. */
void check_materials_and_patches(Checks &checks) {
  const std::string scene = "set Dimension = 3\nsubsection Boundary\n set Clamped = top\n"
                            " set Contact = bottom\nend\nsubsection Contact\n"
                            " set Gap = -0.05+0.1*(x^2+y^2)\nend\nsubsection Geometry\n"
                            " set Cells = 3, 3, 3\nend\nsubsection Discretization\n"
                            " set Coarsest level = 1\n set Finest level = 2\nend\n"
                            "subsection Material\n";
  const std::string isotropic = scene + "set Young's modulus = 2.6\nend\n";
  const StudyResult<3> one = solve<3>(isotropic);
  const StudyResult<3> two =
    solve<3>(scene + "set Law = general\nset Hooke tensor = 3.5; 1.5; 1.5; "
                     "0; 0; 0; 3.5; 1.5; 0; 0; 0; 3.5; "
                     "0; 0; 0; 1; 0; 0; 1; 0; 1\nend\n");
  checks.near("21 entries: P", relative_distance(two.pressure.P, one.pressure.P), 0., 1e-10);
  const StudyResult<3> four = solve<3>(isotropic, levels(2, 2, {"Discretization/Patch ratio=4"}));
  checks.that("4 x 4 faces: equations hold", four.verdict.equations_hold());
  checks.near("4 x 4 faces: patches", four.pressure.P.size(), 9, 0.);
  checks.near("4 x 4 faces: force", last(four, "contact_force_n") / last(one, "contact_force_n"),
              1., 0.04);
}

/** The mean of p_0 (1 - r²/a²)^{1/2} over a patch, r the distance from the origin. */
double mean_of_hertz(const Patch<3> &patch, const double peak, const double radius) {
  constexpr unsigned int n = 50;
  double sum = 0.;
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < n; ++j) {
      const dealii::Point<3> x = point_on(patch.face.corners, {(i + 0.5) / n, (j + 0.5) / n});
      sum += peak * std::sqrt(std::max(0., 1. - x.square() / (radius * radius)));
    }
  return sum / (n * n);
}

/** a³ = 3 F R/(4 E*), p_0³ = 6 F E*²/(pi³ R²), F of the whole sphere; the block is four contact
 * radii wide, and fifteen patches make a diameter. */
void check_sphere(Checks &checks) {
  const StudyResult<3> result = solve_prm(checks, "sphere", {"Discretization/Finest level=6"});
  const double E = 1. / (1. - 0.3 * 0.3), force = 4. * last(result, "contact_force_n");
  const double peak = std::cbrt(6. * force * E * E) / dealii::numbers::PI;
  const double radius = std::cbrt(3. * force / (4. * E));
  double square = 0., square_of_hertz = 0.;
  for (std::size_t k = 0; k < result.pressure.patches.size(); ++k) {
    const double hertz = mean_of_hertz(result.pressure.patches[k], peak, radius);
    square += std::pow(-result.pressure.P[k] - hertz, 2);
    square_of_hertz += hertz * hertz;
  }
  checks.near("pressure", std::sqrt(square / square_of_hertz), 0., 0.06);
  checks.near("peak", last(result, "peak_pressure") / peak, 1., 0.015);
  checks.near("area in contact",
              4. * result.levels.back().contact.length / (dealii::numbers::PI * radius * radius),
              1., 0.03);
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(
    argc, argv, {check_exact_scenes, check_last_orders, check_materials_and_patches, check_sphere});
}
