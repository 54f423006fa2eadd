// SPDX-License-Identifier: LGPL-2.1-or-later
// What contact costs beside a linear solve, both counted in V-cycles; flat in h.

#include "../../driver/box/box.h"
#include "../stiffness/v_cycle.h"
#include "iterated.h"
#include "one_level.h"
#include "tests.h"

using namespace Signorini;

namespace {
/** Contact takes few V-cycles more than a linear solve with its pressure, and no MINRES. */
template <int dim>
void compare(Checks &checks, const std::string &name, const Iterated<dim> &iterated) {
  checks.about(name);
  ContactIterationOptions options;
  options.tolerance = 1e-8;
  options.stationarity = 1e-8;
  const ContactIterationResult result = iterated.solve(options);
  DualVector x = iterated.A.make_vector();
  const unsigned int linear =
    conjugate_gradients(iterated.A, x, iterated.contact.residual(x, result.P));
  checks.that("no MINRES", result.converged && !result.stalled);
  checks.between("contact/linear", double(result.cycles) / linear, 0.5, 2.5);
}

const std::string block = R"(
subsection Boundary
 set Clamped = top
 set Contact = bottom
end
subsection Load
 set Body force = 0; -0.2
end
subsection Contact
 set Gap = 2*(x-0.4)^2-0.02
end
)";
} // namespace

int main(int argc, char **argv) {
  return run_tests(
    argc, argv, {[](Checks &checks) {
      for (unsigned int level = 4; level < 8; ++level) {
        const OneLevel problem(block, level);
        const Discretization<2> &d = problem.discretization;
        compare(checks, "plane, level " + std::to_string(level),
                Iterated<2>(d.space, problem.scene, d.multipliers, d.D, d.condensed_D, d.G));
      }
      Scene<3> scene = make_box_scene(
        scalar([](const dealii::Point<3> &x) {
          return 0.5 * ((x[0] - 0.57) * (x[0] - 0.57) + (x[1] - 0.44) * (x[1] - 0.44)) - 0.02;
        }),
        field([](const auto &) { return Vector3(); }));
      for (const char *side : {"left", "right", "front", "back"})
        scene.boundary[scene.geometry.find_side(side)].role = Role::free;
      for (unsigned int level = 3; level < 6; ++level) {
        const Box box(scene, level, 2);
        compare(checks, "cube, n = " + std::to_string(1U << level),
                Iterated<3>(box.space, scene, box.multipliers, box.D, box.condensed_D, box.G));
      }
    }});
}
