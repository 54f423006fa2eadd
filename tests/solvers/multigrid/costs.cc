// SPDX-License-Identifier: LGPL-2.1-or-later
// Memory of multigrid per unknown, as doc/multigrid.md states it. With two levels as arguments, of
// a square and of a cube: a table of its seconds.

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <iomanip>

#include "driver/box/box.h"
#include "v_cycle.h"

using namespace Signorini;

namespace
{
double cpu_seconds()
{
  timespec time = {};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

double seconds_of(const std::function<void()> &work)
{
  const double begin = cpu_seconds();
  work();
  return cpu_seconds() - begin;
}

/** The smallest of several times. */
double best_of(const std::function<void()> &work)
{
  double best = seconds_of(work);
  for (unsigned int i = 0; i < 9; ++i)
    best = std::min(best, seconds_of(work));
  return best;
}

Scene<2> square(const std::string &other = "")
{
  return make_scene<2>(parse_parameters(
    "subsection Boundary\nset Clamped = top\nset Contact = bottom\nend\n" + other, "test"));
}

Scene<3> cube(const double distortion = 0.)
{
  Scene<3> scene = make_box_scene(scalar([](const auto &) { return 0.; }),
                                  field([](const dealii::Point<3> &) { return Vector3(); }),
                                  {1., 1., 1.});
  scene.geometry.distortion = distortion;
  return scene;
}

template <int dim>
double bytes_per_unknown(const Scene<dim> &scene, const unsigned int level)
{
  const HeldBody<dim> body(scene, level, level);
  return static_cast<double>(body.multigrid.memory()) / body.multigrid.size();
}

template <int dim>
void print_costs(const std::string &name, const Scene<dim> &scene, const unsigned int level)
{
  const Mesh<dim> mesh(scene.geometry, level, level, MPI_COMM_SELF);
  const DisplacementSpace<dim> space(mesh, scene);
  std::unique_ptr<const StiffnessMultigrid<dim>> multigrid;
  const double setup =
    seconds_of([&]() { multigrid = std::make_unique<StiffnessMultigrid<dim>>(space, scene); });
  dealii::Vector<double> b = RandomNumbers(1).vector(multigrid->size()), x(b);
  space.constraints().set_zero(b);
  const double product = best_of([&]() { multigrid->vmult(x, b); });
  const double cycle = best_of([&]() { multigrid->precondition(x, b); });
  unsigned int n_steps = 0;
  const double solve = seconds_of([&]() { n_steps = conjugate_gradients(*multigrid, x, b); });
  const double n_cells = mesh.triangulation().n_active_cells();
  std::cout << std::setprecision(3) << name << ", level " << level << ": " << multigrid->size()
            << " unknowns, set-up " << setup << " s, A x " << 1e9 * product / n_cells
            << " ns per cell, V-cycle " << 1e9 * cycle / multigrid->size() << " ns per unknown, "
            << n_steps << " steps in " << solve << " s, "
            << static_cast<double>(multigrid->memory()) / multigrid->size() << " bytes per unknown"
            << std::endl;
}

void check_memory(Checks &checks)
{
  checks.between("square", bytes_per_unknown<2>(square(), 7), 40., 54.);
  checks.between("cube", bytes_per_unknown<3>(cube(), 5), 40., 60.);
  checks.between("distorted square",
                 bytes_per_unknown<2>(square(entry("Geometry", "Distortion", "0.2")), 7),
                 50.,
                 68.);
  checks.between("distorted cube", bytes_per_unknown<3>(cube(0.2), 5), 50., 75.);
  checks.between("square, E(x)",
                 bytes_per_unknown<2>(square(entry("Material", "Young's modulus", "1 + x")), 6),
                 200.,
                 300.);
}
} // namespace

int main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  Checks checks;
  check_memory(checks);
  if (argc == 3)
  {
    const auto plane = static_cast<unsigned int>(std::atoi(argv[1])),
               space = static_cast<unsigned int>(std::atoi(argv[2]));
    print_costs<2>("square", square(), plane);
    print_costs<2>("square, distorted", square(entry("Geometry", "Distortion", "0.2")), plane);
    print_costs<2>(
      "square, E(x)", square(entry("Material", "Young's modulus", "1 + x^2 + y")), plane);
    print_costs<3>("cube", cube(), space);
    print_costs<3>("cube, distorted", cube(0.2), space);
  }
  return checks.exit_code();
}
