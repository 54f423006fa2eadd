// SPDX-License-Identifier: LGPL-2.1-or-later
// Unknowns of high degree, which CHOLMOD eliminates before the contact unknowns.

#include <signorini/base/errors.h>
#include <signorini/discretization/space/linear_system.h>
#include <signorini/solvers/contact/compliance.h>
#include <signorini/solvers/stiffness/condensed_inverse.h>

#include "error_control/hp/graded.h"
#include "random_numbers.h"
#include "tests.h"

using namespace Signorini;

namespace {
const std::string clamped = "subsection Boundary\nset Clamped = top\nset Contact = bottom\nend\n";

/** b = A x is solved for x, for several right-hand sides; C does not depend on the solver. */
void compare(Checks &checks, const std::string &name, const MeshPlan &plan) {
  checks.about(name);
  const GradedLevel level(clamped, plan);
  const auto A = std::move(assemble_linear_system(level.space(), level.scene, 3).matrix);
  const Coupling &D = level.discretization.condensed_D;
  const auto condensed = factorise(A, 1., LinearSolver::condensed, contact_unknowns(D));
  const auto klu = factorise(A, 1., LinearSolver::amesos_klu);
  std::vector<DualVector> exact, b, x;
  double error = 0.;
  for (const unsigned int seed : {1U, 2U, 3U}) {
    const dealii::Vector<double> values = RandomNumbers(seed).vector(A.m());
    exact.push_back(level.space().make_vector());
    std::copy(values.begin(), values.end(), exact.back().begin());
    level.space().constraints().set_zero(exact.back());
    b.push_back(level.space().make_vector());
    x.push_back(level.space().make_vector());
    A.vmult(b.back(), exact.back());
  }
  condensed->solve(x, b);
  for (unsigned int k = 0; k < x.size(); ++k) {
    x[k] -= exact[k];
    error = std::max(error, x[k].linfty_norm());
  }
  checks.near("known answers", error, 0., 1e-11);
  checks.that("C is read from the factor",
              condensed->trailing_factor(contact_unknowns(D)).has_value());
  dealii::FullMatrix<double> difference(make_compliance(*condensed, D)->dense());
  const dealii::FullMatrix<double> C = make_compliance(*klu, D)->dense();
  difference.add(-1., C);
  checks.near("C", difference.linfty_norm() / C.linfty_norm(), 0., 1e-11);
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
  return run_tests(argc, argv, {[](Checks &checks) {
                     for (const unsigned int degree : {2U, 3U, 4U, 6U, 9U})
                       compare(checks, "degree " + std::to_string(degree), uniform_plan(2, degree));
                     MeshPlan graded = uniform_plan(1, 7);
                     graded.singularities = {corner({0., 0.}, 6.)};
                     compare(checks, "graded", graded);
                     for (const unsigned int degree : {2U, 5U, 8U})
                       singular(checks, degree);
                   }});
}
