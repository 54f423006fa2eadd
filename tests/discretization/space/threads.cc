// SPDX-License-Identifier: LGPL-2.1-or-later
// The assembly has the same digits on any number of threads.

#include <signorini/base/errors.h>
#include <signorini/base/parallel.h>
#include <signorini/discretization/space/linear_system.h>

#include <cstdlib>
#include <numeric>

#include "one_level.h"
#include "tests.h"

using namespace Signorini;

namespace {
void set_threads(const std::string &n) {
  setenv("DEAL_II_NUM_THREADS", n.c_str(), 1);
}

/** Expressions everywhere, a kink, and cells of which no two are congruent. */
std::string scene(const std::string &body_force) {
  return "subsection Boundary\nset Clamped = top\nset Contact = bottom\nset Traction = left: "
         "sin(y); x\n"
         "end\n" +
         entry("Load", "Body force", body_force) +
         "Material/Young's modulus = 1 + x*y\n"
         "Geometry/Distortion = 0.2\n"
         "Discretization/Kinks at x = 0.3\n";
}

void assembly(Checks &checks) {
  const OneLevel level(scene("exp(x); max(0, x - 0.3)"), 5);
  set_threads("1");
  const LinearSystem<2> one = assemble_linear_system(level.space(), level.scene, 3);
  for (const std::string n : {"2", "5"}) {
    set_threads(n);
    LinearSystem<2> several = assemble_linear_system(level.space(), level.scene, 3);
    several.matrix.add(-1., one.matrix);
    several.f -= one.f;
    several.loads -= one.loads;
    several.applied[0].force -= one.applied[0].force;
    several.applied[0].moment -= one.applied[0].moment;
    checks.near("the same on " + n + " threads",
                {several.matrix.frobenius_norm(), several.f.linfty_norm(),
                 several.loads.linfty_norm(), several.applied[0].force.norm(),
                 several.applied[0].moment.norm()},
                std::vector<double>(5, 0.), 0.);
  }
}

void failures(Checks &checks) {
  set_threads("3");
  const OneLevel level(scene("0; (x-0.78)^2+(y-0.5)^2 < 8e-5 ? 1/0 : 0"), 5);
  checks.throws<InputError>("what fails in a thread", "Load/Body force: ", [&]() {
    assemble_linear_system(level.space(), level.scene, 3);
  });
}

void order(Checks &checks) {
  set_threads("4");
  checks.that("DEAL_II_NUM_THREADS", n_available_threads() == 4);
  for (const std::size_t n : {0U, 1U, 3U, 100U}) {
    std::vector<std::size_t> expected(n), found;
    std::iota(expected.begin(), expected.end(), 0U);
    produce_in_parallel<std::size_t>(
      4, n, [](const std::size_t i) { return i; },
      [&](const std::size_t i) { found.push_back(i); });
    checks.that(std::to_string(n) + " results in order", found == expected);
  }
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv, {assembly, failures, order});
}
