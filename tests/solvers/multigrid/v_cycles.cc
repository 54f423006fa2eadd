// SPDX-License-Identifier: LGPL-2.1-or-later
// How many steps of conjugate gradients with one V-cycle each reduce the residual by 1e-8: flat in
// h.

#include <deal.II/base/mpi.h>

#include "driver/box/box.h"
#include "v_cycle.h"

using namespace Signorini;

namespace
{
const std::string held = "subsection Boundary\nset Clamped = top\nset Contact = bottom\nend\n";

template <int dim>
unsigned int n_steps(const HeldBody<dim> &body)
{
  dealii::Vector<double> x(body.space.dofs().n_dofs());
  const dealii::Vector<double> b = body.random_vector(5);
  return conjugate_gradients(body.multigrid, x, b);
}

void plane(Checks &checks,
           const std::string &name,
           const std::string &text,
           const unsigned int coarsest_level,
           const unsigned int level,
           const unsigned int most)
{
  checks.between(
    name,
    n_steps(HeldBody<2>(make_scene<2>(parse_parameters(text, "test")), coarsest_level, level)),
    1,
    most);
}

template <int dim>
void memory(Checks &checks,
            const std::string &name,
            const Scene<dim> &scene,
            const unsigned int level,
            const double lower,
            const double upper)
{
  const HeldBody<dim> body(scene, level, level);
  checks.between(name + ": bytes per unknown",
                 static_cast<double>(body.multigrid.memory()) / body.multigrid.size(),
                 lower,
                 upper);
}

Scene<2> square(const std::string &other)
{
  return make_scene<2>(parse_parameters(held + other, "test"));
}
} // namespace

int main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  Checks checks;
  for (const unsigned int level : {4U, 5U, 6U, 7U, 8U})
    plane(checks, "square, level " + std::to_string(level), held, level, level, 8);
  for (const unsigned int level : {4U, 5U, 6U, 7U})
    plane(checks,
          "distorted, level " + std::to_string(level),
          held + entry("Geometry", "Distortion", "0.2"),
          3,
          level,
          11);
  plane(checks, "distorted last", held + entry("Geometry", "Distortion", "0.2"), 6, 6, 11);
  for (const unsigned int level : {4U, 5U, 6U})
    plane(checks, "half disc, level " + std::to_string(level), named_scene("E3"), 2, level, 15);
  plane(checks,
        "contrast 1000",
        held + entry("Material", "Young's modulus", "if((x-0.4)^2 + (y-0.6)^2 < 0.05, 1000, 1)"),
        6,
        6,
        17);
  plane(checks, "nu = 0.45", held + entry("Material", "Poisson's ratio", "0.45"), 6, 6, 14);
  plane(checks, "cells of 1 by 4", held + entry("Geometry", "Upper right", "4, 1"), 6, 6, 29);
  // Bending has so little energy that matrices in single precision are not positive definite.
  plane(checks, "cells of 1 by 8", held + entry("Geometry", "Upper right", "1, 8"), 7, 7, 64);
  plane(checks, "cells of 1 by 32", held + entry("Geometry", "Upper right", "1, 32"), 5, 5, 400);
  for (const unsigned int level : {2U, 4U})
    plane(checks,
          "a body of 1 by 20, level " + std::to_string(level),
          held + entry("Geometry", "Upper right", "1, 20") + entry("Geometry", "Cells", "1, 20"),
          level,
          level,
          20);
  Scene<3> scene = make_box_scene(scalar([](const auto &) { return 0.; }),
                                  field([](const dealii::Point<3> &) { return Vector3(); }),
                                  {1., 1., 1.});
  for (const unsigned int level : {3U, 4U, 5U})
    checks.between(
      "cube, level " + std::to_string(level), n_steps(HeldBody<3>(scene, level, level)), 1, 8);
  memory<3>(checks, "cube", scene, 5, 40., 60.);
  scene.geometry.distortion = 0.2;
  checks.between("distorted cube", n_steps(HeldBody<3>(scene, 2, 4)), 1, 14);
  memory<2>(checks, "square", square(""), 7, 40., 54.);
  memory<2>(
    checks, "distorted square", square(entry("Geometry", "Distortion", "0.2")), 7, 50., 70.);
  memory<2>(
    checks, "square, E(x)", square(entry("Material", "Young's modulus", "1 + x")), 6, 200., 300.);
  memory<3>(checks, "distorted cube", scene, 5, 50., 75.);
  return checks.exit_code();
}
