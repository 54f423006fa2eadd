// SPDX-License-Identifier: LGPL-2.1-or-later
// The certificate of a correct answer vanishes, and each of its residuals notices its own kind of
// error.

#include <signorini/error_control/estimate/certificate.h>
#include <signorini/postprocessing/fields/nodal_forces.h>
#include <signorini/results/verdict/judge.h>

#include <cmath>

#include "solved_level.h"
#include "tests.h"

using namespace Signorini;

namespace {
struct CertifiedLevel : public SolvedLevel {
  using SolvedLevel::SolvedLevel;

  Certificate judge(const Displacement &displacement, const Pressure &pressure,
                    const LinearSystem<2> &linear_system) const {
    const ContactSolution found = contact(displacement, pressure);
    const Solved<2> solved(discretization, scene, found);
    const NodalForces forces = nodal_forces(solved, linear_system.loads, discretization.D);
    return certify(solved, linear_system.applied, forces,
                   energies_of(solved, MotionModes<2>(), forces));
  }
  Certificate judge(const Displacement &displacement, const Pressure &pressure) const {
    return judge(displacement, pressure, system);
  }
};

/** Pressed onto a parabola: some patches press, others do not. */
const std::string block = "Scene/Name = block on parabola\n";

const std::string loaded = "subsection Boundary\nset Clamped = top\nset Contact = bottom\n"
                           "set Traction = right: 0.1; 0.2*y\nend\n"
                           "Load/Body force = 0.1; -0.5*x\n"
                           "Contact/Gap = 0.01*x\n";

const std::string oblique = "subsection Geometry\nset Shape = polygon\n"
                            "set Vertices = 0,0; 2,0; 2.5,1.5; 1,2.5; -0.5,1\nend\n"
                            "subsection Boundary\nset Contact = side0 side4\nset Rollers = side1\n"
                            "set Displacement = side3: 0.01; -0.02\nend\n"
                            "Load/Body force = -0.1; -0.2\n";

void correct_answers(Checks &checks) {
  const std::pair<const char *, std::string> scenes[] = {{"block on parabola", block},
                                                         {"D1", "Scene/Name = D1\n"},
                                                         {"loads", loaded},
                                                         {"oblique sides", oblique}};
  for (const auto &scene : scenes) {
    const CertifiedLevel solved(scene.second, 3);
    const Certificate c = solved.judge(solved.U, solved.P);
    checks.near(std::string(scene.first) + ": sign", c.sign, 0., 0.);
    checks.near(std::string(scene.first) + ": all residuals",
                {c.stationarity, c.penetration, c.complementarity, c.duality_gap, c.force_balance,
                 c.moment_balance, max_residual(c).value},
                std::vector<double>(7, 0.), 1e-12);
    checks.that("worst is the largest", max_residual(c).value >= c.stationarity);
  }
}

/** J = -f(u)/2 + [p, g]/2, because a(u, u) = f(u) + [p, g] where nothing is displaced. */
void energies(Checks &checks) {
  const CertifiedLevel solved(loaded, 3);
  const double work = solved.U * solved.system.loads;
  const double expected = -0.5 * work + 0.5 * (solved.P * solved.discretization.G);
  const Certificate c = solved.judge(solved.U, solved.P);
  checks.near("energy", c.energy, expected, 1e-13 * std::abs(expected));
  checks.that("energy is not zero", std::abs(expected) > 1e-4);
}

/** A node inside the body, or on the middle of the bottom: its second degree of freedom. */
dealii::types::global_dof_index dof_at(const DisplacementSpace<2> &space,
                                       const dealii::Point<2> &x) {
  for (const auto &cell : space.dofs().active_cell_iterators())
    for (const unsigned int v : cell->vertex_indices())
      if (cell->vertex(v).distance(x) < 1e-10)
        return cell->vertex_dof_index(v, 1);
  return dealii::numbers::invalid_dof_index;
}

void wrong_displacements(Checks &checks, const CertifiedLevel &solved) {
  Displacement U = solved.U;
  U[dof_at(solved.space(), {0., 0.5})] += 1e-5;
  Certificate c = solved.judge(U, solved.P);
  checks.that("a moved node disturbs equilibrium", c.stationarity > 1e-5);
  checks.that("a moved node disturbs the force balance", max_residual(c).value > 1e-5);
  U = solved.U;
  U[dof_at(solved.space(), {0., 0.})] -= 1e-3;
  c = solved.judge(U, solved.P);
  checks.that("a node below the foundation penetrates", c.penetration > 1e-3);
  checks.that("a node below the foundation opens the duality gap", c.duality_gap > 1e-6);
  checks.that("a node below the foundation disturbs complementarity", c.complementarity > 1e-5);
  U = solved.U;
  U *= 1.0001;
  checks.that("stretched displacements", solved.judge(U, solved.P).stationarity > 1e-6);
}

void wrong_pressures(Checks &checks, const CertifiedLevel &solved) {
  Pressure P = solved.P;
  checks.that("the last patch does not press", P[P.size() - 1] == 0.);
  P[P.size() - 1] = 1e-3 * P.linfty_norm();
  checks.near("a pulling foundation", solved.judge(solved.recover(P), P).sign, 1e-3, 1e-12);

  for (const double factor : {0.9, 1.1}) {
    P = solved.P;
    P *= factor;
    checks.about(factor < 1. ? "too little pressure" : "too much pressure");
    const Certificate c = solved.judge(solved.recover(P), P);
    checks.near("in equilibrium", c.stationarity, 0., 1e-12);
    checks.that("complementarity", c.complementarity > 1e-3);
    checks.that("penetration", (c.penetration > 1e-3) == (factor < 1.));
    // Both objectives are off their optimum: the gap is P.W.
    checks.that("not in balance with the old displacement",
                solved.judge(solved.U, P).stationarity > 1e-3);
  }
}

void wrong_loads(Checks &checks, const CertifiedLevel &solved) {
  LinearSystem<2> system = assemble_linear_system(solved.space(), solved.scene, 3);
  system.applied[0].force[0] += 1e-4;
  Certificate c = solved.judge(solved.U, solved.P, system);
  checks.that("wrong resultant: force balance", c.force_balance > 1e-5);
  system.applied[0].force[0] -= 1e-4;
  system.applied[0].moment[0] += 1e-4;
  c = solved.judge(solved.U, solved.P, system);
  checks.near("wrong moment: force balance", c.force_balance, 0., 1e-12);
  checks.that("wrong moment: moment balance", c.moment_balance > 1e-5);
  system.applied[0].moment[0] -= 1e-4;
  system.loads *= 1.001;
  c = solved.judge(solved.U, solved.P, system);
  checks.that("wrong load vector: stationarity", c.stationarity > 1e-6);
}

/** P and W = D^T U - G by hand, at rest: U = 0, G = (0, 0, 1, ...). */
void degenerate(Checks &checks, CertifiedLevel &solved) {
  const Displacement U = solved.space().zero();
  Pressure P(solved.P.size());
  dealii::Vector<double> &G = solved.discretization.G;
  G = 1.;
  G[0] = G[1] = G[2] = 0.;
  P[0] = -1.;
  checks.that("two patches touch without pressure", solved.judge(U, P).degenerate_patches == 2);
  P[0] = 0.;
  checks.that("three patches touch where nothing presses",
              solved.judge(U, P).degenerate_patches == 3);
  G[1] = G[2] = 1e-4;
  P[0] = -1e-17;
  checks.that("rounding is not a pressure, a small gap is an opening",
              solved.judge(U, P).degenerate_patches == 1);
}

/** A body at rest on its foundation: F = 0, so that C is not computed. */
void at_rest(Checks &checks) {
  const OneLevel level("subsection Boundary\nset Clamped = top\nset Contact = bottom\nend\n"
                       "Load/Body force = 0; 0\n"
                       "Contact/Gap = max(0, x-0.5)\n",
                       3);
  const LevelSolution<2> solution = level.solve();
  checks.that("at rest: nothing presses", solution.record.contact.active == 0);
  checks.near("at rest: half of the patches touch", solution.record.certificate.degenerate_patches,
              0.5 * solution.record.sizes.multipliers, 0.);
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(argc, argv, {[](Checks &checks) {
                     correct_answers(checks);
                     energies(checks);
                     CertifiedLevel pressed(block, 3);
                     wrong_displacements(checks, pressed);
                     wrong_pressures(checks, pressed);
                     const CertifiedLevel with_loads(loaded, 3);
                     wrong_loads(checks, with_loads);
                     degenerate(checks, pressed);
                     at_rest(checks);
                   }});
}
