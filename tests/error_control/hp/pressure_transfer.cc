// SPDX-License-Identifier: LGPL-2.1-or-later
// Polynomial pressures at the nodes of other multipliers.

#include <signorini/postprocessing/fields/pressure_transfer.h>

#include <algorithm>
#include <cmath>

#include "graded.h"
#include "tests.h"

using namespace Signorini;

namespace {
using Function = std::function<double(unsigned int, double)>;

Pressure nodal(const MultiplierSpace<2> &space, const Function &p) {
  Pressure P(space.n_multipliers());
  for (unsigned int k = 0; k < P.size(); ++k)
    P[k] = p(space.surface().patches()[space.patch_of(k)].side, space.node(k)[0]);
  return P;
}

MeshPlan plan(const double s, const double layers, const double rise) {
  MeshPlan plan = uniform_plan(2, 2);
  plan.base_size = 0.25;
  plan.rise = rise;
  plan.singularities = {end_of_contact({s, 0.}, 2, s, s, layers)};
  return plan;
}

/** Degree 4 everywhere: pressures of degree two are transferred exactly. */
MeshPlan quadratic(const std::string &text, const double s, const double layers) {
  MeshPlan graded = plan(s, layers, 2.);
  const GradedLevel uniform(text, uniform_plan(2, 2));
  for (const auto &cell : uniform.mesh().triangulation().active_cell_iterators())
    graded.demands[cell->id()].degree = 4;
  return graded;
}

void check(Checks &checks, const std::string &name, const std::string &text, const double s) {
  const GradedLevel coarse(text, quadratic(text, s, 2.)), fine(text, quadratic(text, 1. - s, 7.)),
    uniform(text, uniform_plan(3, 2));
  const Function p = [](const unsigned int side, const double t) {
    return -1. - side - t + 0.5 * t * t;
  };
  const auto P = nodal(coarse.multipliers(), p);
  for (const auto &[to, mesh_name] : std::vector<std::pair<const GradedLevel *, std::string>>{
         {&coarse, "the same"}, {&fine, "finer elsewhere"}, {&uniform, "uniform"}})
    checks.near(name + ", to a mesh, " + mesh_name,
                distance(transfer_pressure(coarse.multipliers(), P, to->multipliers()),
                         nodal(to->multipliers(), p)),
                0., 1e-12);
  // Positive values are cut off: they would pull.
  const Function q = [](const unsigned int side, const double t) {
    return (t - 0.3) * (side + 1.);
  };
  const Function cut = [&q](const unsigned int side, const double t) {
    return std::min(0., q(side, t));
  };
  checks.near(name + ", cut off",
              distance(transfer_pressure(fine.multipliers(), nodal(fine.multipliers(), q),
                                         uniform.multipliers()),
                       nodal(uniform.multipliers(), cut)),
              0., 1e-12);
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(
    argc, argv, {[](Checks &checks) {
      check(checks, "one side",
            "subsection Boundary\nset Clamped = top\nset Contact = bottom\nend\n", 0.3);
      check(checks, "three sides",
            "subsection Boundary\nset Clamped = top\nset Contact = left right bottom\nend\n", 0.8);
    }});
}
