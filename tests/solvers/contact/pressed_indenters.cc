// SPDX-License-Identifier: LGPL-2.1-or-later
// Parabolas pressed into a half-plane by a force, free to rotate: against the same problem with the
// motions prescribed; columns on demand, singular compliances.

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "columns_on_demand.h"
#include "matrices.h"
#include "motion_problem.h"
#include "tests.h"

using namespace Signorini;
using Vector = dealii::Vector<double>;
using Matrix = dealii::FullMatrix<double>;

namespace {
/** A parabola, pressed by a force at the position e, that may rotate. */
MotionProblem indenter(const unsigned int m, const double curvature, const double force,
                       const double e) {
  MotionProblem problem{logarithmic_kernel(m), Vector(m), {Matrix(m, 2), Matrix(2, 2), Vector(2)}};
  for (unsigned int i = 0; i < m; ++i) {
    const double x = (i + 0.5) / m - 0.5;
    problem.F[i] = curvature * x * x / m;
    problem.motions.B(i, 0) = 1. / m;
    problem.motions.B(i, 1) = x / m;
  }
  problem.motions.b[0] = force;
  problem.motions.b[1] = force * e;
  return problem;
}

void indenters(Checks &checks) {
  for (const double e : {0., 0.1, 0.3})
    for (const double curvature : {0., 50., 2000.}) {
      const unsigned int m = 64;
      const MotionProblem problem = indenter(m, curvature, 1., e);
      const MotionResult found = solve(problem);
      // The same with the motions prescribed.
      Vector F = problem.F;
      for (unsigned int i = 0; i < m; ++i)
        for (unsigned int j = 0; j < 2; ++j)
          F[i] -= problem.motions.B(i, j) * found.q[j];
      const auto C = std::make_shared<const DenseCompliance>(problem.C);
      const QPResult held =
        solve_dual_problem(C, F, AdmissibleSet::nonpositive(F.size()), Vector(), {});
      checks.that("indenter: converged", found.qp.converged);
      checks.near("indenter: the held one has the same P", difference(held.P, found.qp.P), 0.,
                  1e-9 * held.P.linfty_norm());
      checks.near("indenter: force", found.qp.P.mean_value(), -1., 1e-11);
      checks.between("indenter: linear solves", found.qp.iterations, 1., 2. * held.iterations + 6.);
      const auto columns = std::make_shared<const ColumnsOnDemand>(problem.C);
      const MotionResult few =
        solve_dual_problem(columns, problem.F, AdmissibleSet::nonpositive(problem.F.size()),
                           problem.motions, Vector(), {});
      checks.near("indenter: columns on demand", difference(few.qp.P, found.qp.P), 0.,
                  1e-9 * held.P.linfty_norm());
      unsigned int pressing = 0;
      for (const double P_i : found.qp.P)
        pressing += P_i < 0. ? 1 : 0;
      checks.between("indenter: columns", columns->asked().size(), pressing, 1.5 * pressing + 10);
      const MotionResult warm = solve(problem, ContactSolver::active_set, found.qp.P);
      checks.that("indenter: its own start costs one solve", warm.qp.iterations == 1);
      const MotionResult sweeps = solve(problem, ContactSolver::psor);
      checks.near("indenter: psor", difference(sweeps.qp.P, found.qp.P), 0.,
                  1e-6 * held.P.linfty_norm());
    }
}

/** Two patches at each position: only the sum of their pressures is known. */
void singular_compliance(Checks &checks) {
  const unsigned int m = 10;
  const MotionProblem single = indenter(m, 10., 1., 0.05);
  MotionProblem twice = indenter(2 * m, 0., 1., 0.05);
  for (unsigned int i = 0; i < 2 * m; ++i) {
    twice.F[i] = single.F[i / 2];
    for (unsigned int j = 0; j < 2; ++j)
      twice.motions.B(i, j) = single.motions.B(i / 2, j);
    for (unsigned int j = 0; j < 2 * m; ++j)
      twice.C(i, j) = single.C(i / 2, j / 2);
  }
  DualSolverOptions options;
  options.may_be_singular = true;
  const auto by = [&](const MotionProblem &problem) {
    return solve_dual_problem(std::make_shared<const DenseCompliance>(problem.C), problem.F,
                              AdmissibleSet::nonpositive(problem.F.size()), problem.motions,
                              Vector(), options);
  };
  const MotionResult found = by(twice), expected = by(single);
  Vector sums(m);
  for (unsigned int i = 0; i < 2 * m; ++i)
    sums[i / 2] += found.qp.P[i];
  checks.near("singular C: sums of P", difference(sums, expected.qp.P), 0., 1e-6);
  checks.near("singular C: q", difference(found.q, expected.q), 0., 1e-7);
  checks.that("singular C: converged, not unique, and it is said",
              found.qp.converged && !found.qp.unique && found.qp.active_set_failure);
  checks.that("regular C: unique",
              expected.qp.converged && expected.qp.unique && !expected.qp.active_set_failure);
}
} // namespace

int main() {
  return run_tests({indenters, singular_compliance});
}
