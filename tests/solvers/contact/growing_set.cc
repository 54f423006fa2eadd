// SPDX-License-Identifier: LGPL-2.1-or-later
// The dual problem with columns on demand: the same answer from fewer columns.

#include <signorini/solvers/contact/dual_solver.h>

#include <cmath>
#include <memory>

#include "columns_on_demand.h"
#include "random_numbers.h"
#include "tests.h"

using namespace Signorini;
using Vector = dealii::Vector<double>;
using Matrix = dealii::FullMatrix<double>;

namespace {
QPResult by_active_set(const BoundConstrainedQP &qp, const Vector &start) {
  return solve_by_active_set(qp, start, IterationOptions());
}

/** Solves with columns on demand and compares with the whole matrix. @return the columns asked for.
 */
unsigned int compare(Checks &checks, const std::string &name, const Matrix &C, const Vector &F,
                     const Vector &start) {
  const BoundConstrainedQP qp(C, F);
  const QPResult whole = by_active_set(qp, Vector());
  // solve_dual_problem() sees that columns are expensive.
  const auto columns = std::make_shared<const ColumnsOnDemand>(C);
  const QPResult found =
    solve_dual_problem(columns, F, AdmissibleSet::nonpositive(F.size()), start, {});
  Vector difference = found.P;
  difference -= whole.P;
  checks.near(name + ": P", difference.linfty_norm(), 0., 1e-10 * whole.P.linfty_norm());
  checks.that(name + ": converged", found.converged);
  checks.near(name + ": KKT residual of the whole problem", qp.kkt_residual(found.P), 0., 1e-12);
  bool needed = true;
  for (unsigned int j = 0; j < F.size(); ++j)
    needed = needed && (whole.P[j] == 0. || columns->asked().count(j) == 1);
  checks.that(name + ": every pressing patch was asked for", needed);
  return columns->asked().size();
}

/** Like a compliance: positive definite, entries that decay away from the diagonal. */
Matrix make_compliance(const unsigned int m) {
  Matrix C(m, m);
  for (unsigned int i = 0; i < m; ++i)
    for (unsigned int j = 0; j < m; ++j)
      C(i, j) = std::exp(-0.2 * std::abs(double(i) - double(j)));
  return C;
}

/** solve_dual_problem() by both methods, and where C is singular. */
void choice(Checks &checks, const Matrix &C, const Vector &F) {
  const unsigned int m = F.size();
  DualSolverOptions psor;
  psor.method = ContactSolver::psor;
  const auto by = [](const Matrix &matrix, const Vector &load, const DualSolverOptions &options) {
    return solve_dual_problem(std::make_shared<const DenseCompliance>(matrix), load,
                              AdmissibleSet::nonpositive(load.size()), Vector(), options);
  };
  const QPResult sets = by(C, F, DualSolverOptions()), sweeps = by(C, F, psor);
  Vector difference = sets.P;
  difference -= sweeps.P;
  checks.near("both methods", difference.linfty_norm(), 0., 1e-8);
  checks.that("the one that was chosen", sets.increment_iterations == 0 &&
                                           sweeps.increment_iterations > 0 &&
                                           !sets.active_set_failure && !sweeps.active_set_failure);
  // All entries 1: only the sum of P is known, and it is -1.
  Matrix ones(m, m);
  Vector load(m);
  for (unsigned int i = 0; i < m; ++i) {
    load[i] = -1.;
    for (unsigned int j = 0; j < m; ++j)
      ones(i, j) = 1.;
  }
  DualSolverOptions singular;
  singular.may_be_singular = true;
  const QPResult replaced = by(ones, load, singular);
  checks.that("C is singular: projected SOR answers, and it is said",
              replaced.converged && replaced.active_set_failure.has_value());
  checks.that("C is singular: the answer is not unique", !replaced.unique);
  checks.near("C is singular: the sum of P", replaced.P.mean_value() * m, -1., 1e-8);
}
} // namespace

int main() {
  return run_tests({[](Checks &checks) {
    const unsigned int m = 40;
    const Matrix C = make_compliance(m);

    Vector F(m);
    for (unsigned int i = 0; i < m; ++i)
      F[i] = std::pow((double(i) - 20.) / 20., 2) - 0.1;
    const unsigned int n = compare(checks, "a dent", C, F, Vector());
    checks.between("a dent: columns", n, 1, 20);

    // Pulled down at one point, with negative couplings to patches that were open: they close.
    Matrix coupled = C;
    for (unsigned int i = 0; i < m; ++i)
      for (unsigned int j = 0; j < m; ++j)
        coupled(i, j) = (i == j ? 2. : 0.) - (std::abs(int(i) - int(j)) == 1 ? 0.9 : 0.);
    Vector pulled(m);
    for (unsigned int i = 0; i < m; ++i)
      pulled[i] = i == 20 ? -1. : 0.01;
    const unsigned int joined = compare(checks, "patches that join", coupled, pulled, Vector());
    checks.between("patches that join: columns", joined, 5, m - 5);

    RandomNumbers random(7);
    for (unsigned int k = 0; k < 20; ++k) {
      const Vector shifted = random.vector(m);
      compare(checks, "random " + std::to_string(k), C, shifted,
              k % 2 == 0 ? Vector() : random.vector(m));
    }

    const auto columns = std::make_shared<const ColumnsOnDemand>(C);
    Vector open(m);
    open = 1.;
    const QPResult nothing =
      solve_dual_problem(columns, open, AdmissibleSet::nonpositive(m), Vector(), {});
    checks.that("nothing touches: no column",
                columns->asked().empty() && nothing.P.linfty_norm() == 0.);
    choice(checks, C, F);
  }});
}
