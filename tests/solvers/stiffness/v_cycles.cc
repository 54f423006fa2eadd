// SPDX-License-Identifier: LGPL-2.1-or-later
// How many steps of conjugate gradients with one V-cycle each reduce the residual by 1e-8: flat in
// h.

#include <deal.II/base/mpi.h>

#include "driver/box/box.h"
#include "v_cycle.h"

using namespace Signorini;

namespace {
const std::string held = "subsection Boundary\nset Clamped = top\nset Contact = bottom\nend\n";

template <int dim>
unsigned int n_steps(const HeldBody<dim> &body) {
  const DualVector b = body.random_vector(5);
  DualVector x(b);
  return conjugate_gradients(body.multigrid, x, b);
}

template <int dim>
void memory(Checks &checks, const std::string &name, const Scene<dim> &scene,
            const unsigned int level, const double lower, const double upper) {
  const HeldBody<dim> body(scene, level, level);
  checks.between(name + ": bytes per unknown",
                 static_cast<double>(body.multigrid.memory()) / body.space.dofs().n_dofs(), lower,
                 upper);
}

Scene<2> square(const std::string &other) {
  return scene_of(held + other);
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(
    argc, argv, {[](Checks &checks) {
      const std::string distorted = held + "Geometry/Distortion = 0.2\n";
      for (const auto &[name, text, coarsest, level, most] :
           {std::tuple("square", held, 4, 4, 8), std::tuple("square", held, 6, 6, 8),
            std::tuple("square", held, 8, 8, 8), std::tuple("distorted", distorted, 3, 4, 11),
            std::tuple("distorted", distorted, 3, 7, 11),
            std::tuple("distorted last", distorted, 6, 6, 11),
            std::tuple("half disc", named_scene("E3"), 2, 4, 15),
            std::tuple("half disc", named_scene("E3"), 2, 6, 15),
            std::tuple("contrast 1000",
                       held + "Material/Young's modulus = "
                              "if((x-0.4)^2 + (y-0.6)^2 < 0.05, 1000, 1)\n",
                       6, 6, 17),
            std::tuple("nu = 0.45", held + "Material/Poisson's ratio = 0.45\n", 6, 6, 14),
            std::tuple("cells of 1 by 4", held + "Geometry/Upper right = 4, 1\n", 6, 6, 29),
            // Bending has so little energy that matrices in single precision are not positive
            // definite.
            std::tuple("cells of 1 by 8", held + "Geometry/Upper right = 1, 8\n", 7, 7, 64),
            std::tuple("cells of 1 by 32", held + "Geometry/Upper right = 1, 32\n", 5, 5, 400),
            std::tuple("a body of 1 by 20",
                       held + "Geometry/Upper right = 1, 20\nGeometry/Cells = 1, 20\n", 4, 4, 20)})
        checks.between(std::string(name) + ", level " + std::to_string(level),
                       n_steps(HeldBody<2>(scene_of(text), coarsest, level)), 1, most);
      Scene<3> scene =
        make_box_scene(scalar([](const auto &) { return 0.; }),
                       field([](const dealii::Point<3> &) { return Vector3(); }), {1., 1., 1.});
      for (const unsigned int level : {3U, 4U, 5U})
        checks.between("cube, level " + std::to_string(level),
                       n_steps(HeldBody<3>(scene, level, level)), 1, 8);
      memory<3>(checks, "cube", scene, 5, 40., 60.);
      // More than 5000 unknowns of coarse cells: cycles of algebraic multigrid in place of factors.
      for (const auto &[name, length, n, m] :
           {std::tuple("cube", 1., 12U, 12U), std::tuple("beam", 10., 60U, 6U)}) {
        Scene<3> parts = scene;
        parts.geometry = make_box({0., 0., 0.}, {length, 1., 1.}, {n, m, m});
        checks.between(std::string("coarse cells of a ") + name, n_steps(HeldBody<3>(parts, 1, 1)),
                       1, 8);
      }
      scene.geometry.distortion = 0.2;
      checks.between("distorted cube", n_steps(HeldBody<3>(scene, 2, 4)), 1, 14);
      memory<2>(checks, "square", square(""), 7, 40., 54.);
      memory<2>(checks, "distorted square", square("Geometry/Distortion = 0.2\n"), 7, 50., 70.);
      memory<2>(checks, "square, E(x)", square("Material/Young's modulus = 1 + x\n"), 6, 200.,
                300.);
      memory<3>(checks, "distorted cube", scene, 5, 50., 75.);
    }});
}
