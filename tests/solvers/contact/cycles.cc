// SPDX-License-Identifier: LGPL-2.1-or-later
// The cost of contact beside a linear solve, both counted in V-cycles; flat in h. The long test has
// bodies for which it is not, and counts the linear solves of other methods.

#include <signorini/solvers/contact/compliance.h>
#include <signorini/solvers/contact/dual_solver.h>

#include <cmath>
#include <fstream>

#include "../../driver/box/box.h"
#include "../stiffness/v_cycle.h"
#include "columns_on_demand.h"
#include "iterated.h"
#include "one_level.h"
#include "tests.h"

using namespace Signorini;

namespace {
/** V-cycles of a linear solve with the pressure of contact, and of contact. */
struct Cycles {
  unsigned int linear, contact;
};

/** Rows of cycles_from_zero.csv: a body, cells per side, V-cycles, and whether MINRES took over. */
template <int dim>
Cycles count(Checks &checks, std::ostream &table, const std::string &name, const unsigned int level,
             const Iterated<dim> &iterated, const bool may_stall) {
  checks.about(name + ", level " + std::to_string(level));
  ContactIterationOptions options;
  options.tolerance = 1e-8;
  options.stationarity = 1e-8;
  const ContactIterationResult result = iterated.solve(options);
  DualVector x = iterated.A.make_vector();
  const unsigned int linear =
    conjugate_gradients(iterated.A, x, iterated.contact.residual(x, result.P));
  checks.that("converged", result.converged);
  if (!may_stall) {
    checks.that("no MINRES", !result.stalled);
    checks.between("contact/linear", double(result.cycles) / linear, 0.5, 2.5);
  }
  table << '"' << name << "\"," << (1U << level) << ',' << linear << ',' << result.cycles << ','
        << result.stalled.has_value() << std::endl;
  return {linear, result.cycles};
}

/** A row of contact_methods.csv: linear solves of other methods, which compute columns of C. */
template <int dim>
void compare(Checks &checks, std::ostream &table, const std::string &name, const unsigned int level,
             const DisplacementSpace<dim> &space, const Scene<dim> &scene, const Coupling &D,
             const Coupling &condensed_D, const dealii::Vector<double> &G, const Cycles &cycles) {
  checks.about(name + ", level " + std::to_string(level));
  const LinearSystem<dim> system = assemble_linear_system(space, scene, 2);
  const auto inverse =
    factorise(system.matrix, system.unit, LinearSolver::condensed, contact_unknowns(condensed_D));
  const dealii::Vector<double> F = solve_free_state(*inverse, space, system.f, D, G).F;
  const auto C = make_compliance(*inverse, condensed_D);
  const auto columns = std::make_shared<const ColumnsOnDemand>(C->dense());
  DualSolverOptions options;
  options.tolerance = 1e-8;
  const auto solve = [&](const std::shared_ptr<const ComplianceOperator> &of) {
    return solve_dual_problem(of, F, AdmissibleSet::nonpositive(F.size()), {}, options);
  };
  checks.that("active set", solve(columns).converged);
  options.method = ContactSolver::psor;
  const QPResult sweeps = solve(C);
  checks.that("projected SOR", sweeps.converged);
  table << name << ',' << (1U << level) << ',' << F.size() << ',' << sweeps.iterations << ','
        << columns->asked().size() << ',' << std::round(10. * cycles.contact / cycles.linear) / 10.
        << std::endl;
}

const std::string block = "Boundary/Clamped = top\nBoundary/Contact = bottom\n"
                          "Load/Body force = 0; -0.2\nContact/Gap = 2*(x-0.4)^2-0.02\n";

void in_the_plane(Checks &checks, std::ostream &table, std::ostream &methods) {
  for (unsigned int level = 4; level < (checks.is_long() ? 9U : 8U); ++level) {
    const OneLevel problem(block, level);
    const Discretization<2> &d = problem.discretization;
    const Cycles cycles =
      count(checks, table, "block", level,
            Iterated<2>(d.space, problem.scene, d.multipliers, d.D, d.condensed_D, d.G), false);
    if (checks.is_long() && level > 4)
      compare(checks, methods, "block", level, d.space, problem.scene, d.D, d.condensed_D, d.G,
              cycles);
  }
}

void in_space(Checks &checks, std::ostream &table, std::ostream &methods) {
  Scene<3> scene = make_box_scene(
    scalar([](const dealii::Point<3> &x) {
      return 0.5 * ((x[0] - 0.57) * (x[0] - 0.57) + (x[1] - 0.44) * (x[1] - 0.44)) - 0.02;
    }),
    field([](const auto &) { return Vector3(); }));
  for (const char *side : {"left", "right", "front", "back"})
    scene.boundary[scene.geometry.find_side(side)].role = Role::free;
  for (unsigned int level = 3; level < 6; ++level) {
    const Box box(scene, level, 2);
    const Cycles cycles =
      count(checks, table, "cube", level,
            Iterated<3>(box.space, scene, box.multipliers, box.D, box.condensed_D, box.G), false);
    if (checks.is_long())
      compare(checks, methods, "cube", level, box.space, scene, box.D, box.condensed_D, box.G,
              cycles);
  }
}

/** Coarse patches, patches of one face, nearly incompressible, varying and long bodies. */
void other_blocks(Checks &checks, std::ostream &table) {
  const auto ratio = [](const std::string &n) { return "Discretization/Patch ratio = " + n; };
  const auto nu = [](const std::string &value) { return "Material/Poisson's ratio = " + value; };
  const auto E = [](const std::string &value) { return "Material/Young's modulus = " + value; };
  const auto size = [](const std::string &value) { return "Geometry/Upper right = " + value; };
  for (const auto &[name, text, coarsest] :
       {std::tuple("H = 3h", ratio("3"), 7U), std::tuple("H = 4h", ratio("4"), 7U),
        std::tuple("H = 8h", ratio("8"), 7U),
        std::tuple("H = h (not inf-sup stable)", ratio("1"), 5U),
        std::tuple("nu = 0.45", nu("0.45"), 7U), std::tuple("nu = 0.48", nu("0.48"), 7U),
        std::tuple("nu = 0.49", nu("0.49"), 5U), std::tuple("nu = 0.495", nu("0.495"), 5U),
        std::tuple("E = 10^(2x)", E("10^(2*x)"), 7U), std::tuple("E = 10^(4x)", E("10^(4*x)"), 7U),
        std::tuple("E = 10^(2y) (soft where it touches)", E("10^(2*y)"), 7U),
        std::tuple("E = 10^(-2y) (stiff where it touches)", E("10^(-2*y)"), 5U),
        std::tuple("E = 1 and 100 on two halves", E("if(x<0.5, 1, 100)"), 7U),
        std::tuple("E = 1 and 1000 on two halves", E("if(x<0.5, 1, 1000)"), 7U),
        std::tuple("4 by 1, of cells 4 by 1", size("4, 1"), 7U),
        std::tuple("1 by 4, of cells 1 by 4", size("1, 4"), 7U),
        std::tuple("16 by 1, of cells 16 by 1", size("16, 1"), 5U)})
    for (unsigned int level = coarsest; level < 8; ++level) {
      const OneLevel problem(block + text + "\n", level);
      const Discretization<2> &d = problem.discretization;
      count(checks, table, std::string("block, ") + name, level,
            Iterated<2>(d.space, problem.scene, d.multipliers, d.D, d.condensed_D, d.G), true);
    }
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv, {[](Checks &checks) {
                     std::ofstream table("cycles_from_zero.csv"), methods("contact_methods.csv");
                     table << "body,cells_per_side,linear_solve,contact,minres\n";
                     methods << "body,cells_per_side,projected_sor,sweeps,active_set,v_cycles\n";
                     in_the_plane(checks, table, methods);
                     in_space(checks, table, methods);
                     if (checks.is_long())
                       other_blocks(checks, table);
                   }});
}
