// SPDX-License-Identifier: LGPL-2.1-or-later
// The bound of the stress is a bound, close to the error; exact for patch tests; and twice the sum
// of the two energies.

#include <signorini/error_control/stress/equilibrated_stress.h>

#include <cmath>

#include "energy_errors.h"
#include "tests.h"

using namespace Signorini;

namespace
{
/** J*(tau) where nothing touches. */
double complementary_energy(const StressBound &bound)
{
  return bound.complementary_energy.upper - bound.translation * bound.support_force;
}

/** A level with its answer and the bound of its stress. */
struct Bounded
{
  Bounded(const std::string &text,
          const unsigned int number,
          const ImprovementOptions &options = ImprovementOptions())
    : level(text, number)
    , solution(level.solve())
    , bound(EquilibratedStress({level.space(),
                                level.scene,
                                level.multipliers(),
                                solution.U,
                                solution.P,
                                level.discretization.n_points},
                               options)
              .bound())
  {
  }
  OneLevel level;
  LevelSolution<2> solution;
  StressBound bound;
};

std::string section(const std::string &name, const std::string &lines)
{
  return "subsection " + name + "\n" + lines + "\nend\n";
}

/** Nothing touches in C2; full contact in C1 makes up for nothing, as u_n - g = O(h²). */
void effectivity(Checks &checks)
{
  for (const unsigned int number : {3U, 4U, 5U, 6U})
  {
    const Bounded c2(entry("Scene", "Name", "C2"), number);
    const double error = energy_errors(c2.level, c2.solution.U).strain_of_u_h;
    const double largest = number == 3 ? 1.15 : (number == 4 ? 1.05 : 1.02);
    checks.between(
      "C2, level " + std::to_string(number), std::sqrt(c2.bound.square) / error, 1., largest);
    const Bounded start(entry("Scene", "Name", "C2"), number, {0, 0.01});
    checks.between("C2 before it is improved, level " + std::to_string(number),
                   std::sqrt(start.bound.square) / error,
                   1.2,
                   1.35);
  }
}

/** D1 has a constant stress: tau is the same. */
void patch_tests(Checks &checks)
{
  const std::pair<const char *, std::string> scenes[] = {
    {"D1", entry("Scene", "Name", "D1")},
    {"oblique sides",
     section("Geometry", "set Shape = polygon\nset Vertices = 0,0; 2,0; 2.5,1; -0.5,1") +
       section("Material", "set Young's modulus = 8\nset Poisson's ratio = 0") +
       section("Boundary",
               "set Displacement = side2: 0; -1/8\nset Contact = side0\n"
               "set Traction = side1: 0; 0.5/sqrt(1.25) | side3: 0; 0.5/sqrt(1.25)") +
       entry("Contact", "Gap", "0")}};
  for (const auto &scene : scenes)
    for (const unsigned int number : {2U, 3U})
    {
      const Bounded answer(scene.second, number);
      const double scale = std::sqrt(std::abs(answer.solution.record.certificate.energy));
      checks.near(std::string(scene.first) + ", level " + std::to_string(number),
                  std::sqrt(answer.bound.square),
                  0.,
                  1e-11 * scale);
      checks.that(std::string(scene.first) + " is not trivial", scale > 1e-2);
    }
}

/** J(u_h) + J*(tau) = 1/2 misfit² if nothing touches and all loads are balanced exactly. */
void energies(Checks &checks)
{
  const std::string far = entry("Contact", "Gap", "100");
  const std::string force = entry("Load", "Body force", "0.1+x-2*y; -0.5*x+0.3*y");
  const std::string rectangle = far + force +
                                section("Boundary",
                                        "set Displacement = top: 0.01; -0.02*x\n"
                                        "set Contact = bottom\nset Traction = right: 0.1; 0.2*y");
  const std::pair<const char *, std::string> scenes[] = {
    {"rectangles", rectangle},
    {"orthotropic",
     rectangle + section("Material",
                         "set Law = orthotropic\nset Orthotropic moduli = 10; 1; 0.4; 0.7\n"
                         "set Orientation = 30")},
    {"rotated squares",
     far + force + section("Geometry", "set Shape = polygon\nset Vertices = 0,0; 1,1; 0,2; -1,1") +
       section("Boundary",
               "set Displacement = side1: 0.01; -0.02*x\nset Contact = side0\n"
               "set Traction = side2: 0.1; 0.2*y")}};
  for (const auto &scene : scenes)
    for (const unsigned int steps : {0U, 4U})
    {
      const Bounded answer(scene.second, 3, {steps, 0.});
      const double J = answer.solution.record.certificate.energy;
      const double half = 0.5 * answer.bound.square;
      checks.near(std::string(scene.first) + ", " + std::to_string(steps) + " steps: energies",
                  J + complementary_energy(answer.bound),
                  half,
                  1e-10 * half + 1e-13 * std::abs(J));
      checks.near(
        std::string(scene.first) + ": no oscillation", answer.bound.oscillation_square, 0., 1e-20);
    }
}

/** u = (y²/10, 0), prescribed on three sides: u_h does not take it along edges, u_h + E does. */
void prescribed(Checks &checks)
{
  const std::string text =
    entry("Contact", "Gap", "100") + entry("Load", "Body force", "-0.2; 0") +
    section("Material", "set Poisson's ratio = 0\nset Young's modulus = 2") +
    section("Boundary",
            "set Contact = bottom\nset Displacement = top: 0.1; 0 | left: 0.1*y*y; 0 | "
            "right: 0.1*y*y; 0") +
    entry("Exact solution", "Displacement", "0.1*y^2; 0");
  double last_lift = 0.;
  for (const unsigned int number : {2U, 3U, 4U, 5U})
  {
    const Bounded answer(text, number);
    const std::string name = "prescribed, level " + std::to_string(number);
    const double error = energy_errors(answer.level, answer.solution.U).strain_of_u_h;
    checks.between(name,
                   (std::sqrt(answer.bound.square) + answer.bound.lift) / error,
                   1.,
                   number < 4 ? 1.7 : 1.4);
    if (last_lift > 0.)
      checks.near(
        name + ": lift of the order 3/2", last_lift / answer.bound.lift, std::sqrt(8.), 0.01);
    last_lift = answer.bound.lift;
    // J(u) = 1/2 int 4 eps12² mu - int f.u = 0.02/3 + 0.02/3, and J(u) + J*(tau) = 1/2 ‖sigma -
    // tau‖².
    // tau is sigma up to rounding on small meshes.
    checks.between(name + ": energies",
                   0.04 / 3. + complementary_energy(answer.bound),
                   -1e-15,
                   0.5 * answer.bound.square);
    // u_h is u at nodes, so pi^{2h} u_h = u; tau is far from sigma before it is improved.
    const StressBound start = Bounded(text, number, {0, 0.}).bound;
    const double half = 0.04 / 3. + complementary_energy(start);
    checks.that(name + ": not exact", half > 1e-7);
    checks.near(
      name + ": patches", 0.5 * start.interpolated_part->square, half, 1e-10 * half + 1e-14);
    checks.near(name + ": lift of patches", start.interpolated_part->lift, 0., 1e-12);
  }
}

/** Constants of the unit square, by hand. */
void constants(Checks &checks)
{
  const OscillationConstants square(CellShape({{{0., 0.}, {1., 0.}, {1., 1.}, {0., 1.}}}));
  const double beta = 0.5 / std::sqrt(1. + std::sqrt(0.5));
  checks.near("Korn's constant", square.korn, std::sqrt(1. + 2. / (beta * beta)), 1e-12);
  checks.near("normal tractions", square.normal[0], 0.645, 0.001);
}
} // namespace

int main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  Checks checks(dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0);
  effectivity(checks);
  patch_tests(checks);
  energies(checks);
  prescribed(checks);
  constants(checks);
  return checks.exit_code();
}
