// SPDX-License-Identifier: LGPL-2.1-or-later
// Solutions on meshes from files: constant strain is exact on straight bodies, a half disc from a
// file gives what the half disc of the catalogue gives, and the numbers of a file do not matter.

#include <signorini/base/text.h>

#include "study_helpers.h"
#include "tests.h"

using namespace Signorini;

namespace
{
const std::string files = TEST_FILES, parts = PARTS;

/** From a mesh file, with an exact solution. */
std::string text(const std::string &file,
                 const std::string &contact,
                 const std::string &held,
                 const std::string &displacement,
                 const std::string &gradient,
                 const std::string &gap,
                 const std::string &pressure)
{
  std::string list;
  for (const std::string &side : split_words(held))
    list += (list.empty() ? "" : " | ") + side + ": " + displacement;
  return "subsection Geometry\nset Shape = file\nset File = " + file + "\nend\n" +
         "subsection Material\nset Young's modulus = 2.5\nset Poisson's ratio = 0.25\nend\n" +
         "subsection Boundary\nset Contact = " + contact + "\nset Displacement = " + list +
         "\nend\nsubsection Contact\nset Gap = " + gap + "\nend\n" +
         "subsection Exact solution\nset Displacement = " + displacement +
         "\nset Displacement gradient = " + gradient + "\nset Pressure = " + pressure + "\nend\n";
}

void check_constant_strain(Checks &checks,
                           const std::string &name,
                           const std::string &scene,
                           const double size)
{
  const StudyResult<2> result = solve(scene, levels(0, 1));
  checks.near(name + ": levels", result.levels.size(), 2, 0);
  for (const LevelRecord &level : result.levels)
  {
    checks.near(name + ": u", value(level, "u_h1").value(), 0., 1e-11 * size);
    checks.near(name + ": p", value(level, "p_l2").value(), 0., 1e-10 * size);
  }
  checks.that(name + ": the equations hold", result.verdict.outcome == Outcome::certified);
}

void check_patch_tests(Checks &checks)
{
  // lambda = mu = 1: sigma_yy = 0.001 - 3 * 0.002 and no shear.
  check_constant_strain(checks,
                        "bracket",
                        text(files + "bracket_1.msh",
                             "foot",
                             "tip top back fillet rest",
                             "0.001*x; -0.002*y",
                             "0.001; 0; 0; -0.002",
                             "0",
                             "-0.005"),
                        80.);
  // Hydrostatic pressure on a hole with n flat facets: u.n is the same everywhere on it.
  const double n = 16.;
  const std::string gap = "0.01*0.2*cos(pi/" + std::to_string(n) + ")";
  check_constant_strain(checks,
                        "plate with contact in the hole",
                        text(files + "plate_with_hole_1.msh",
                             "hole",
                             "left right top bottom",
                             "-0.01*(x - 1); -0.01*(y - 0.5)",
                             "-0.01; 0; 0; -0.01",
                             gap,
                             "-0.04"),
                        1.);
}

/** E3 of the catalogue on a mesh of the half disc from a file. */
StudyResult<2> solve_e3(const std::string &file, const std::string &arcs)
{
  const Parameters of_file = parse_parameters("",
                                              "test",
                                              {"Geometry/Shape=file",
                                               "Geometry/File=" + file,
                                               "Geometry/Arcs=" + arcs,
                                               "Boundary/Contact=arc",
                                               "Boundary/Clamped=flat"});
  const Parameters parameters = parse_parameters(named_scene("E3"), "test", levels(1, 3));
  const Scene<2> e3 = make_scene<2>(parameters);
  Scene<2> scene = e3;
  scene.geometry = make_scene<2>(of_file).geometry;
  for (unsigned int i = 0; i < 2; ++i)
    scene.boundary[scene.geometry.find_side(e3.geometry.sides[i].name())] = e3.boundary[i];
  std::ostream silence(nullptr);
  return run_study(parameters, scene, MPI_COMM_WORLD, {silence, "", [](const std::string &) {}});
}

/** The mesh of the file has as many cells as the scene's on level 3, or a few less. */
void check_half_disc(Checks &checks, const std::string &name, const StudyResult<2> &result)
{
  static const StudyResult<2> e3 = solve(named_scene("E3"), levels(4, 6));
  const std::pair<const char *, double> orders[] = {
    {"u_h1", 1.}, {"u_l2", 2.}, {"p_l2", 1.}, {"u_superclose_h1", 1.7}, {"u_post_h1", 1.7}};
  for (const auto &[column, order] : orders)
  {
    checks.between(name + ": order of " + column, slope(result.levels, column), order - 0.15, 2.6);
    const double here = value(result.levels.back(), column).value();
    const double there = value(e3.levels.back(), column).value();
    checks.between(
      name + ": " + column + " beside that of the built-in mesh", here / there, 0.2, 2.5);
  }
  checks.that(name + ": the verdict of the built-in mesh",
              result.verdict.outcome == e3.verdict.outcome);
  checks.near(name + ": the energy of the built-in mesh",
              value(result.levels.back(), "energy").value(),
              value(e3.levels.back(), "energy").value(),
              1e-3 * std::abs(value(e3.levels.back(), "energy").value()));
}
} // namespace

int main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  Checks checks;
  check_patch_tests(checks);
  check_half_disc(checks, "second order", solve_e3(parts + "half_disc.msh", ""));
  check_half_disc(checks, "a declared arc", solve_e3(files + "half_disc_1.msh", "arc"));
  return checks.exit_code();
}
