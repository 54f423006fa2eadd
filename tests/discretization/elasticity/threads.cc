// SPDX-License-Identifier: LGPL-2.1-or-later
// The assembly has the same digits on any number of threads.

#include <signorini/base/errors.h>
#include <signorini/base/parallel.h>
#include <signorini/discretization/elasticity/linear_system.h>

#include <cstdlib>
#include <numeric>

#include "one_level.h"
#include "tests.h"

using namespace Signorini;

namespace
{
void set_threads(const std::string &n)
{
  setenv("DEAL_II_NUM_THREADS", n.c_str(), 1);
}

/** Expressions everywhere, a kink, and cells of which no two are congruent. */
std::string scene(const std::string &body_force)
{
  return "subsection Boundary\nset Clamped = top\nset Contact = bottom\nset Traction = left: "
         "sin(y); x\n"
         "end\n" +
         entry("Load", "Body force", body_force) + entry("Material", "Young's modulus", "1 + x*y") +
         entry("Geometry", "Distortion", "0.2") + entry("Discretization", "Kinks at x", "0.3");
}

void assembly(Checks &checks)
{
  const OneLevel level(scene("exp(x); max(0, x - 0.3)"), 5);
  set_threads("1");
  const LinearSystem<2> one = assemble_linear_system(level.space(), level.scene, 3);
  for (const std::string n : {"2", "5"})
  {
    set_threads(n);
    LinearSystem<2> several = assemble_linear_system(level.space(), level.scene, 3);
    several.matrix.add(-1., one.matrix);
    several.f -= one.f;
    several.loads -= one.loads;
    several.applied.force -= one.applied.force;
    several.applied.moment -= one.applied.moment;
    checks.near("A on " + n + " threads", several.matrix.frobenius_norm(), 0., 0.);
    checks.near("f on " + n + " threads", several.f.linfty_norm(), 0., 0.);
    checks.near("loads on " + n + " threads", several.loads.linfty_norm(), 0., 0.);
    checks.near("resultant on " + n + " threads", several.applied.force.norm(), 0., 0.);
    checks.near("moment on " + n + " threads", several.applied.moment.norm(), 0., 0.);
  }
}

void failures(Checks &checks)
{
  set_threads("3");
  const OneLevel level(scene("0; (x-0.78)^2+(y-0.5)^2 < 8e-5 ? 1/0 : 0"), 5);
  checks.throws<InputError>("what fails in a thread", "Load/Body force: ", [&]() {
    assemble_linear_system(level.space(), level.scene, 3);
  });
}

void order(Checks &checks)
{
  set_threads("4");
  checks.that("DEAL_II_NUM_THREADS", n_available_threads(MPI_COMM_WORLD) == 4);
  for (const std::size_t n : {0U, 1U, 3U, 100U})
  {
    std::vector<std::size_t> expected(n), found;
    std::iota(expected.begin(), expected.end(), 0U);
    produce_in_parallel<std::size_t>(
      4,
      n,
      [](const std::size_t i) { return i; },
      [&](const std::size_t i) { found.push_back(i); });
    checks.that(std::to_string(n) + " results in order", found == expected);
  }
}
} // namespace

int main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  dealii::deal_II_exceptions::disable_abort_on_exception();
  Checks checks;
  assembly(checks);
  failures(checks);
  order(checks);
  return checks.exit_code();
}
