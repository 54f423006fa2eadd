// SPDX-License-Identifier: LGPL-2.1-or-later
// Whole runs in space: exact answers, orders, materials, Hertz' sphere.

#include <signorini/problem/parameters/parameter_text.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/numbers.h>

#include "study_helpers.h"
#include "tests.h"

using namespace Signorini;

namespace
{
using Levels = std::vector<LevelRecord>;

/** A file of prm/space. */
StudyResult<3> solve_file(const std::string &name, const std::vector<std::string> &overrides = {})
{
  return solve<3>(read_text_file(SOURCE_DIR "/../../../prm/space/" + name + ".prm"), overrides);
}

/** The order of a column between the last two levels. */
double last_order(const Levels &levels, const std::string &column)
{
  return slope(Levels(levels.end() - 2, levels.end()), column);
}

void check_exact_scenes(Checks &checks)
{
  const StudyResult<3> patch = solve_file("patch_test");
  checks.that("patch test: equations hold", patch.verdict.equations_hold());
  for (const LevelRecord &level : patch.levels)
  {
    const std::string name = "patch test, level " + std::to_string(level.sizes.level) + ": ";
    checks.near(name + "u", level.displacement_errors->h1, 0., 1e-12);
    checks.near(name + "p", level.pressure_errors->l2, 0., 1e-11);
  }
  const StudyResult<3> block = solve_file("own_weight");
  checks.that("own weight: equations hold", block.verdict.equations_hold());
  for (const LevelRecord &level : block.levels)
  {
    const std::string name = "own weight, level " + std::to_string(level.sizes.level) + ": ";
    checks.near(name + "nodal values", level.displacement_errors->superclose_h1, 0., 1e-11);
    checks.near(name + "p", level.pressure_errors->l2, 0., 1e-11);
    checks.near(name + "contact force", level.contact.normal_force, 0.7, 1e-11);
  }
  checks.near("own weight: order of u_h1", last_order(block.levels, "u_h1"), 1., 0.01);
  // u is a polynomial of degree two.
  checks.near("own weight: pi^{2h}", *block.levels.back().displacement_errors->post_h1, 0., 1e-11);
}

/** Orders one, two, and three halves to two. */
void check_orders(Checks &checks, const std::string &name)
{
  const StudyResult<3> result = solve_file(name);
  const Levels &levels = result.levels;
  checks.that(name + ": equations hold", result.verdict.equations_hold());
  checks.near(name + ": order of u_h1", last_order(levels, "u_h1"), 1., 0.1);
  checks.near(name + ": order of p_l2", last_order(levels, "p_l2"), 1., 0.1);
  checks.between(name + ": order of pi^{2h}", last_order(levels, "u_post_h1"), 1.8, 2.2);
  checks.between(name + ": order of degree 4", last_order(levels, "u_post4_h1"), 1.9, 2.6);
  checks.between(name + ": order of nodal values", last_order(levels, "u_superclose_h1"), 1.8, 2.6);
  checks.between(name + ": order of the recovered p", last_order(levels, "p_post_l2"), 1.5, 2.2);
  checks.between(
    name + ": order in the dual norm", last_order(levels, "p_dual_spectral"), 1.4, 2.0);
  checks.between(name + ": effectivity", *value(levels.back(), "effectivity"), 0.9, 1.1);
}

/** An isotropic tensor given by its 21 entries, and the same with three faces per patch. */
void check_materials_and_patches(Checks &checks)
{
  const std::string scene = R"(
set Dimension = 3
subsection Boundary
  set Clamped = top
  set Contact = bottom
end
subsection Contact
  set Gap = -0.05+0.1*(x^2+y^2)
end
subsection Geometry
  set Cells = 3, 3, 3
end
subsection Discretization
  set Coarsest level = 1
  set Finest level = 2
end
subsection Material
)";
  const std::string isotropic = "set Young's modulus = 2.6\nend\n";
  const std::string general = "set Law = general\nset Hooke tensor = 3.5; 1.5; 1.5; 0; 0; 0; 3.5; "
                              "1.5; 0; 0; 0; 3.5; 0; 0; 0; "
                              "1; 0; 0; 1; 0; 1\nend\n";
  const StudyResult<3> one = solve<3>(scene + isotropic), two = solve<3>(scene + general);
  checks.near("21 entries: P", relative_distance(two.pressure.P, one.pressure.P), 0., 1e-10);
  const StudyResult<3> three = solve<3>(scene + isotropic, {"Discretization/Patch ratio=3"});
  checks.that("3 x 3 faces: equations hold", three.verdict.equations_hold());
  checks.near("3 x 3 faces: patches", three.pressure.P.size(), 16, 0.);
  checks.near("3 x 3 faces: force",
              three.levels.back().contact.normal_force / one.levels.back().contact.normal_force,
              1.,
              0.02);
}

/** The mean of p_0 (1 - r²/a²)^{1/2} over a patch, r the distance from the origin. */
double mean_of_hertz(const Patch<3> &patch, const double peak, const double radius)
{
  constexpr unsigned int n = 50;
  double sum = 0.;
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < n; ++j)
    {
      const double x = patch.lower[0] + (patch.upper[0] - patch.lower[0]) * (i + 0.5) / n;
      const double y = patch.lower[1] + (patch.upper[1] - patch.lower[1]) * (j + 0.5) / n;
      sum += peak * std::sqrt(std::max(0., 1. - (x * x + y * y) / (radius * radius)));
    }
  return sum / (n * n);
}

/** a³ = 3 F R/(4 E*), p_0³ = 6 F E*²/(pi³ R²), F of the whole sphere; the block is four contact
 * radii wide, and fifteen patches make a diameter. */
void check_sphere(Checks &checks)
{
  const StudyResult<3> result = solve_file("sphere", {"Discretization/Finest level=6"});
  const LevelRecord &finest = result.levels.back();
  checks.that("sphere: equations hold", result.verdict.equations_hold());
  const double E = 1. / (1. - 0.3 * 0.3), force = 4. * finest.contact.normal_force;
  const double peak = std::cbrt(6. * force * E * E) / dealii::numbers::PI;
  const double radius = std::cbrt(3. * force / (4. * E));
  double square = 0., square_of_hertz = 0.;
  for (std::size_t k = 0; k < result.pressure.patches.size(); ++k)
  {
    const double hertz = mean_of_hertz(result.pressure.patches[k], peak, radius);
    square += std::pow(-result.pressure.P[k] - hertz, 2);
    square_of_hertz += hertz * hertz;
  }
  checks.near("sphere: pressure", std::sqrt(square / square_of_hertz), 0., 0.06);
  checks.near("sphere: peak", finest.answer.peak_pressure->value / peak, 1., 0.015);
  checks.near("sphere: area in contact",
              4. * finest.contact.length / (dealii::numbers::PI * radius * radius),
              1.,
              0.03);
}
} // namespace

int main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  Checks checks;
  check_exact_scenes(checks);
  check_orders(checks, "d3");
  check_orders(checks, "v3");
  check_materials_and_patches(checks);
  check_sphere(checks);
  return checks.exit_code();
}
