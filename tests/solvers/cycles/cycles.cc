// SPDX-License-Identifier: LGPL-2.1-or-later
// What contact costs beside a linear solve, both counted in V-cycles; flat in h.

#include <signorini/discretization/elasticity/cell_stiffness.h>
#include <signorini/discretization/elasticity/linear_system.h>
#include <signorini/solvers/cycles/boundary_model.h>
#include <signorini/solvers/cycles/contact_iteration.h>
#include <signorini/solvers/multigrid/stiffness_multigrid.h>

#include <algorithm>

#include "../../driver/box/box.h"
#include "../multigrid/v_cycle.h"
#include "one_level.h"
#include "tests.h"

using namespace Signorini;

namespace
{
struct Cycles
{
  unsigned int linear, contact;
  double scale;
  bool by_minres;
  double ratio() const
  {
    return double(contact) / linear;
  }
};

template <int dim>
Cycles count(const DisplacementSpace<dim> &space,
             const Scene<dim> &scene,
             const MultiplierSpace<dim> &multipliers,
             const Coupling &D,
             const Coupling &condensed_D,
             const dealii::Vector<double> &G)
{
  const StiffnessMultigrid<dim> A(space, scene);
  // f = T^T (loads - a(k, .)).
  const Displacement k = space.prescribed(scene);
  DualVector r = space.dual(assemble_loads(space, scene, 2));
  r -= space.dual(internal_forces(space, scene, k).forces);
  r = space.condense(r);
  const dealii::Vector<double> f(r.begin(), r.end());
  dealii::Vector<double> gap(G);
  gap -= D.transpose_product(k);
  const auto model = make_boundary_model(multipliers);
  const ContactSystem system = {A, f, condensed_D, gap, *model};
  ContactIterationOptions options;
  options.tolerance = 1e-8;
  options.stationarity = 1e-8;
  const ContactIterationResult result = solve_contact_by_cycles(
    system, dealii::Vector<double>(A.size()), dealii::Vector<double>(gap.size()), options);
  const dealii::Vector<double> pressed =
    system.residual(dealii::Vector<double>(A.size()), result.P);
  dealii::Vector<double> x(A.size());
  return {conjugate_gradients(A, x, pressed),
          result.converged ? result.cycles : 1000,
          result.scale,
          result.stalled.has_value()};
}

void report(Checks &checks, const std::string &name, const Cycles &cycles, const double most)
{
  checks.that(name + ": no MINRES", !cycles.by_minres);
  checks.between(name + ": contact/linear", cycles.ratio(), 0.5, most);
}

Cycles in_the_plane(const std::string &text, const unsigned int level)
{
  const OneLevel problem(text, level);
  const Discretization<2> &d = problem.discretization;
  return count(d.space, problem.scene, d.multipliers, d.D, d.condensed_D, d.G);
}

Cycles in_space(const Scene<3> &scene, const unsigned int level)
{
  const Box box(scene, level, 2);
  return count(box.space, scene, box.multipliers, box.D, box.condensed_D, box.G);
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

int main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  Checks checks;
  for (unsigned int level = 4; level < 8; ++level)
    report(checks, "plane, level " + std::to_string(level), in_the_plane(block, level), 2.5);
  Scene<3> scene = make_box_scene(
    scalar([](const dealii::Point<3> &x) {
      return 0.5 * ((x[0] - 0.57) * (x[0] - 0.57) + (x[1] - 0.44) * (x[1] - 0.44)) - 0.02;
    }),
    field([](const auto &) { return Vector3(); }));
  for (const char *side : {"left", "right", "front", "back"})
    scene.boundary[scene.geometry.find_side(side)].role = Role::free;
  for (unsigned int level = 3; level < 6; ++level)
    report(checks, "cube, n = " + std::to_string(1U << level), in_space(scene, level), 2.5);
  return checks.exit_code();
}
