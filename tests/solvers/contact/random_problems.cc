// SPDX-License-Identifier: LGPL-2.1-or-later
// Projected SOR and the active set method on random and contact-like matrices; cycling,
// degenerate, shifted, scaled and empty problems.

#include <signorini/solvers/contact/dual_solver.h>
#include <signorini/solvers/contact/projected_methods.h>

#include <cmath>
#include <set>
#include <vector>

#include "matrices.h"
#include "random_numbers.h"
#include "tests.h"

using namespace Signorini;
using Vector = dealii::Vector<double>;
using Matrix = dealii::FullMatrix<double>;

namespace {
double distance(const Vector &a, const Vector &b) {
  Vector difference(a);
  difference -= b;
  return difference.size() == 0 ? 0. : difference.linfty_norm() / std::max(1., b.linfty_norm());
}

/** The worst violation of P in K, W <= 0 where P is above the lower end, W >= 0 where it is below
 * the upper end: P is the only solution if it is zero. */
double violation(const BoundConstrainedQP &qp, const Vector &P) {
  const Vector W = qp.gradient(P);
  double worst = 0.;
  for (unsigned int i = 0; i < qp.size(); ++i) {
    const double above = P[i] - qp.K[i].lower, below = qp.K[i].upper - P[i];
    worst = std::max({worst, -above, -below, std::min(above, W[i]), std::min(below, -W[i])});
  }
  return worst;
}

/** Zero as a bound, other bounds, and two bounds for some unknowns. */
void small_problems(Checks &checks) {
  RandomNumbers random(17);
  double worst = 0.;
  bool converged = true, lower = false, inside = false, upper = false;
  for (unsigned int trial = 0; trial < 200; ++trial) {
    const unsigned int m = 1 + trial % 13;
    const Vector F = random.vector(m), start = random.vector(m), bound = random.vector(m);
    std::vector<Interval> intervals(m);
    for (unsigned int i = 0; i < m && trial % 3 > 0; ++i) {
      intervals[i].upper = trial % 3 == 1 ? bound[i] : 0.3 * std::abs(bound[i]);
      if (trial % 3 == 2 && i % 2 == 0)
        intervals[i].lower = -0.3 * std::abs(bound[i]);
    }
    const BoundConstrainedQP qp(std::make_shared<const DenseCompliance>(random_matrix(m, random)),
                                F, AdmissibleSet(intervals));
    for (const QPResult &result :
         {solve_by_psor(qp, start, {1e-13, 10000, 1.2}), solve_by_active_set(qp, {}, {1e-12, 1000}),
          solve_by_active_set(qp, start, {1e-12, 1000})}) {
      worst = std::max(worst, violation(qp, result.P));
      converged = converged && result.converged;
      for (unsigned int i = 0; i < m; ++i)
        (qp.K.is_inside(i, result.P[i])                       ? inside
         : std::abs(result.P[i] - intervals[i].lower) < 1e-12 ? lower
                                                              : upper) = true;
    }
  }
  checks.that("200 random problems: every state occurs", lower && inside && upper);
  checks.that("200 random problems: all converge", converged);
  checks.near("200 random problems: all methods solve the problem", worst, 0., 1e-11);
}

/** Large problems with a prescribed answer: F = C P - W for P, W with P <= 0, W <= 0, P W = 0. */
void prescribed(Checks &checks, const std::string &name, const Matrix &C,
                const unsigned int degenerate, const double tolerance) {
  checks.about(name);
  const unsigned int m = C.m();
  RandomNumbers random(m);
  Vector P(m), W(m), F(m);
  for (unsigned int i = 0; i < m; ++i) {
    const double value = -std::abs(random()) - 0.1;
    if (degenerate > 0 && i % degenerate == 0)
      continue;
    (random() > 0. ? P : W)[i] = value;
  }
  W *= C(0, 0);
  C.vmult(F, P);
  F -= W;
  const BoundConstrainedQP qp(C, F);
  for (const auto &[method, result, factor] :
       {std::tuple("active set", solve_by_active_set(qp, {}, {1e-12, 200}), 1.),
        std::tuple("psor", solve_by_psor(qp, Vector(m), {1e-12, 100000, 1.3}), 100.)}) {
    checks.that(std::string("converges, ") + method, result.converged);
    checks.near(method, distance(result.P, P), 0., factor * tolerance);
  }
}

/** C_AA P_A = F_A - C_AI bound_I with the members of A as the bits of @p set. */
Vector solve_on(const BoundConstrainedQP &qp, const unsigned int set) {
  const unsigned int m = qp.size();
  Matrix system(m, m);
  Vector rhs(m), P(m);
  for (unsigned int i = 0; i < m; ++i) {
    const bool active = ((set >> i) & 1U) == 1;
    rhs[i] = active ? qp.F[i] : qp.K[i].upper;
    for (unsigned int j = 0; j < m; ++j)
      system(i, j) = active ? qp.C->dense()(i, j) : (i == j ? 1. : 0.);
  }
  system.gauss_jordan();
  system.vmult(P, rhs);
  return P;
}

/** The active set method without an end to cycles, as it stands in the literature. */
bool plain_method_cycles(const BoundConstrainedQP &qp, unsigned int set) {
  std::set<unsigned int> visited;
  while (visited.insert(set).second) {
    const Vector P = solve_on(qp, set), W = qp.gradient(P);
    unsigned int next = 0;
    for (unsigned int i = 0; i < qp.size(); ++i)
      if (P[i] - W[i] / qp.diagonal[i] < qp.K[i].upper - 1e-12)
        next |= 1U << i;
    if (next == set)
      return false;
    set = next;
  }
  return true;
}

/** A start value that presses exactly on @p set. */
Vector pressing_on(const unsigned int set, const BoundConstrainedQP &qp) {
  Vector start(qp.size());
  for (unsigned int i = 0; i < qp.size(); ++i)
    start[i] = qp.K[i].upper - (((set >> i) & 1U) == 1 ? 1. : 0.);
  return start;
}

/** Where the plain method goes in circles, single patches join and leave. */
void check_cycles(Checks &checks, const std::string &name,
                  const std::vector<BoundConstrainedQP> &problems) {
  checks.about(name);
  unsigned int n_cycles = 0;
  for (const BoundConstrainedQP &qp : problems)
    for (unsigned int set = 0; set < (1U << qp.size()); ++set) {
      const bool cycles = plain_method_cycles(qp, set);
      const QPResult result = solve_by_active_set(qp, pressing_on(set, qp), {1e-12, 1000});
      n_cycles += cycles ? 1 : 0;
      checks.that("cycles are reported, and nothing else", result.cycled == cycles);
      checks.near("right answer", violation(qp, result.P), 0., 1e-11);
    }
  checks.that("the plain method cycles", n_cycles > 0);
}

void cycling(Checks &checks) {
  // Positive definite (minors 4, 11, 2), all P > bound wanted at once.
  Matrix H(3, 3);
  const double entries[3][3] = {{4., 5., -5.}, {5., 9., -5.}, {-5., -5., 7.}};
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j < 3; ++j)
      H(i, j) = entries[i][j];
  const double F[] = {-2., -1., 3.};
  check_cycles(checks, "three unknowns", {BoundConstrainedQP(H, Vector(F, F + 3))});
  // Among nearly singular matrices of rank two a few cycle.
  RandomNumbers random(3);
  std::vector<BoundConstrainedQP> problems;
  for (unsigned int trial = 0; trial < 300; ++trial) {
    Matrix M(2, 5), C(5, 5);
    for (unsigned int i = 0; i < 5; ++i) {
      M(0, i) = random();
      M(1, i) = random();
    }
    M.Tmmult(C, M);
    for (unsigned int i = 0; i < 5; ++i)
      C(i, i) += 0.001;
    problems.emplace_back(C, random.vector(5));
  }
  check_cycles(checks, "300 random problems", problems);
}

/** Degenerate problems end quickly also at tolerances near rounding. */
void degenerate(Checks &checks) {
  const unsigned int m = 120;
  const Matrix C = logarithmic_kernel(m);
  Vector P(m), F(m);
  for (unsigned int i = 0; i < m / 3; ++i)
    P[i] = -1. / 3. - 0.01 * i;
  C.vmult(F, P);
  const BoundConstrainedQP qp(C, F);
  for (const double tolerance : {1e-10, 1e-13, 1e-15}) {
    const QPResult result = solve_by_active_set(qp, {}, {tolerance, 1000});
    checks.near("touching without pressure: answer", distance(result.P, P), 0., 1e-12);
    checks.between("touching without pressure: solves", result.iterations, 1, 60);
  }
}

void empty(Checks &checks) {
  RandomNumbers random(1);
  for (const BoundConstrainedQP &qp : {BoundConstrainedQP{Matrix(), Vector()},
                                       BoundConstrainedQP{random_matrix(3, random), Vector(3)}}) {
    const QPResult sets = solve_by_active_set(qp, {}, {1e-10, 10}),
                   psor = solve_by_psor(qp, Vector(qp.size()), {1e-10, 10, 1.1});
    for (const Vector &P : {sets.P, psor.P})
      checks.near("empty or F = 0: P", std::vector<double>(P.begin(), P.end()),
                  std::vector<double>(qp.size(), 0.), 0.);
    checks.that("empty or F = 0: converged",
                sets.converged && psor.converged && psor.iterations <= 1);
  }
}
} // namespace

int main() {
  return run_tests({[](Checks &checks) {
    small_problems(checks);
    for (const unsigned int m : {10U, 40U}) {
      RandomNumbers random(m);
      const std::string size = ", m = " + std::to_string(m);
      const Matrix C = random_matrix(m, random);
      prescribed(checks, "random matrix" + size, C, 0, 1e-12);
      prescribed(checks, "random matrix, degenerate" + size, C, 3, 1e-12);
      prescribed(checks, "logarithmic kernel" + size, logarithmic_kernel(m), 0, 1e-11);
      prescribed(checks, "logarithmic kernel, degenerate" + size, logarithmic_kernel(m), 4, 1e-11);
    }
    cycling(checks);
    degenerate(checks);
    empty(checks);
  }});
}
