// SPDX-License-Identifier: LGPL-2.1-or-later
// Unknowns of high degree, which CHOLMOD eliminates before the contact unknowns.

#include <signorini/base/errors.h>
#include <signorini/discretization/space/linear_system.h>
#include <signorini/solvers/contact/compliance.h>
#include <signorini/solvers/stiffness/cellwise_inverse.h>

#include "error_control/hp/graded.h"
#include "random_numbers.h"
#include "tests.h"

using namespace Signorini;

namespace {
const std::string clamped = "subsection Boundary\nset Clamped = top\nset Contact = bottom\nend\n";

/** b = A x is solved for x, for several right-hand sides. */
void known_answers(Checks &checks, const std::string &name, const GradedLevel &level,
                   const LinearSystem<2> &whole, const StiffnessInverse &inverse) {
  std::vector<DualVector> exact, b, x;
  double error = 0.;
  for (const unsigned int seed : {1U, 2U, 3U}) {
    const dealii::Vector<double> values = RandomNumbers(seed).vector(whole.matrix.m());
    exact.push_back(level.space().make_vector());
    std::copy(values.begin(), values.end(), exact.back().begin());
    level.space().constraints().set_zero(exact.back());
    b.push_back(level.space().make_vector());
    x.push_back(level.space().make_vector());
    whole.matrix.vmult(b.back(), exact.back());
    b.back() *= whole.unit;
  }
  inverse.solve(x, b);
  for (unsigned int k = 0; k < x.size(); ++k) {
    x[k] -= exact[k];
    error = std::max(error, x[k].linfty_norm());
  }
  checks.near("known answers, " + name, error, 0., 1e-11);
  checks.near("residual, " + name, inverse.max_residual(), 0., 1e-11);
}

/** All unknowns, or those on edges alone, are factorised; C does not depend on the solver. */
void compare(Checks &checks, const std::string &name, const MeshPlan &plan,
             const std::string &text = clamped) {
  checks.about(name);
  const GradedLevel level(text, plan);
  const DisplacementSpace<2> &space = level.space();
  const LinearSystem<2> whole = assemble_linear_system(space, level.scene, 3),
                        edges = assemble_linear_system(space, level.scene, 3, true);
  checks.that("cells are condensed on demand", whole.cells.empty() && !edges.cells.empty());
  const auto unknowns = contact_unknowns(level.discretization.condensed_D);
  const auto klu = make_stiffness_inverse(whole, space, LinearSolver::amesos_klu, unknowns);
  const dealii::FullMatrix<double> C =
    make_compliance(*klu, level.discretization.condensed_D)->dense();
  for (const LinearSystem<2> *const system : {&whole, &edges})
    for (const LinearSolver solver : {LinearSolver::condensed, LinearSolver::amesos_klu}) {
      const std::string by = std::string(to_text(solver)) + (system == &edges ? ", edges" : "");
      const auto inverse = make_stiffness_inverse(*system, space, solver, unknowns);
      known_answers(checks, by, level, whole, *inverse);
      checks.that("C is read from factors that keep it, " + by,
                  inverse->trailing_factor(unknowns).has_value() ==
                    (solver == LinearSolver::condensed));
      dealii::FullMatrix<double> difference(
        make_compliance(*inverse, level.discretization.condensed_D)->dense());
      difference.add(-1., C);
      checks.near("C, " + by, difference.linfty_norm() / C.linfty_norm(), 0., 1e-11);
    }
}

void singular(Checks &checks, const unsigned int degree) {
  GradedLevel level(clamped, uniform_plan(1, degree));
  for (auto &condition : level.scene.boundary)
    condition.role = Role::free;
  level.scene.contacts.clear();
  const DisplacementSpace<2> space(level.mesh(), level.scene, StrainOperator::symmetric_gradient,
                                   degree);
  const auto A = std::move(assemble_linear_system(space, level.scene, 3).matrix);
  checks.throws<ComputationError>("loose body, degree " + std::to_string(degree), "singular",
                                  [&]() { factorise(A, 1., LinearSolver::condensed); });
}
} // namespace

int main(int argc, char **argv) {
  return run_tests(
    argc, argv, {[](Checks &checks) {
      for (const unsigned int degree : {2U, 3U, 4U, 6U, 9U})
        compare(checks, "degree " + std::to_string(degree), uniform_plan(2, degree));
      MeshPlan graded = uniform_plan(1, 7);
      graded.singularities = {corner({0., 0.}, 6.)};
      for (const auto &[name, text] :
           {std::pair("graded", clamped),
            std::pair("moduli that vary", clamped + "Material/Young's modulus = 40 + 30*x*y\n"),
            std::pair("rollers and prescribed displacements",
                      std::string("Boundary/Rollers = left\nBoundary/Contact = "
                                  "bottom\nBoundary/Displacement = top: 0; x\n")),
            std::pair("body of revolution", clamped + "Material/Plane state = axisymmetric\n")})
        compare(checks, name, graded, text);
      for (const unsigned int degree : {2U, 5U, 8U})
        singular(checks, degree);
    }});
}
