// SPDX-License-Identifier: LGPL-2.1-or-later
// The memory of multigrid; the long test has large meshes, and its seconds are a table.

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <fstream>
#include <functional>
#include <iomanip>

#include "driver/box/box.h"
#include "v_cycle.h"

using namespace Signorini;

namespace {
/** Returns seconds, the median of three calls. */
double time_of(const std::function<void()> &call) {
  std::array<double, 3> seconds{};
  for (double &time : seconds) {
    const auto start = std::chrono::steady_clock::now();
    call();
    time = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }
  std::sort(seconds.begin(), seconds.end());
  return seconds[1];
}

/** A row of multigrid_cost.csv. */
template <int dim>
void check(Checks &checks, std::ostream &table, const std::string &name, const Scene<dim> &scene,
           const unsigned int level, const double least, const double most) {
  const HeldBody<dim> body(scene, level, level);
  const double n_unknowns = body.space.dofs().n_dofs(),
               memory = static_cast<double>(body.multigrid.memory()) / n_unknowns;
  checks.between(name + ": bytes per unknown", memory, least, most);
  if (!checks.is_long())
    return;
  const DualVector b = body.random_vector(5);
  DualVector x(b);
  unsigned int n_steps = 0;
  const double set_up = time_of([&] { StiffnessMultigrid<dim>(body.space, body.scene); }),
               product = time_of([&] { body.multigrid.vmult(x, b); }),
               cycle = time_of([&] { body.multigrid.precondition(x, b); }),
               solve = time_of([&] { n_steps = conjugate_gradients(body.multigrid, x, b); });
  table << '"' << name << "\"," << std::lround(n_unknowns) << ',' << std::setprecision(2) << set_up
        << ',' << std::lround(1e9 * product / std::pow(2., dim * level)) << ','
        << std::lround(1e9 * cycle / n_unknowns) << ',' << n_steps << ',' << solve << ','
        << std::lround(memory) << std::endl;
}

void cost(Checks &checks) {
  std::ofstream table("multigrid_cost.csv");
  table << "body,unknowns,set_up_s,product_ns_per_cell,v_cycle_ns_per_unknown,steps,solve_s,"
           "bytes_per_unknown\n";
  const std::string held = "Boundary/Clamped = top\nBoundary/Contact = bottom\n";
  const unsigned int plane = checks.is_long() ? 10 : 7, space = checks.is_long() ? 6 : 5;
  check(checks, table, "square", scene_of(held), plane, 40., 54.);
  check(checks, table, "square, distorted", scene_of(held + "Geometry/Distortion = 0.2\n"), plane,
        50., 70.);
  check(checks, table, "square, E(x)", scene_of(held + "Material/Young's modulus = 1 + x\n"),
        checks.is_long() ? 10 : 6, 200., 300.);
  Scene<3> cube = make_box_scene(scalar([](const auto &) { return 0.; }),
                                 field([](const dealii::Point<3> &) { return Vector3(); }));
  for (const char *side : {"left", "right", "front", "back"})
    cube.boundary[cube.geometry.find_side(side)].role = Role::free;
  check(checks, table, "cube", cube, space, 40., 60.);
  cube.geometry.distortion = 0.2;
  check(checks, table, "cube, distorted", cube, space, 50., 75.);
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv, {cost});
}
