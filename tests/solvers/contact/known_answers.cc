// SPDX-License-Identifier: LGPL-2.1-or-later
// min 1/2 P^T C P - P^T F over P <= 0, and over a set with two components, on small problems solved
// by hand.

#include <signorini/solvers/contact/dual_solver.h>
#include <signorini/solvers/contact/projected_methods.h>

#include <stdexcept>
#include <vector>

#include "tests.h"

using namespace Signorini;

namespace {
struct Problem {
  std::string name;
  std::vector<std::vector<double>> C;
  std::vector<double> F;
  std::vector<double> P;
};

/** In each, W = C P - F <= 0 and P W = 0 can be checked by eye. */
const std::vector<Problem> problems = {
  {"both press", {{2, 1}, {1, 2}}, {-3, -3}, {-1, -1}},
  {"one presses", {{2, 1}, {1, 2}}, {-2, 1}, {-1, 0}},
  {"nothing touches", {{2, 1}, {1, 2}}, {1, 2}, {0, 0}},
  {"touching without pressure", {{2, 1}, {1, 2}}, {-2, -1}, {-1, 0}},
  {"middle opens", {{4, 3, 1}, {3, 5, 3}, {1, 3, 4}}, {-5, -5, -5}, {-1, 0, -1}}};

BoundConstrainedQP make_qp(const Problem &problem, const AdmissibleSet &K) {
  const unsigned int m = problem.F.size();
  dealii::FullMatrix<double> C(m, m);
  for (unsigned int i = 0; i < m; ++i)
    for (unsigned int j = 0; j < m; ++j)
      C(i, j) = problem.C[i][j];
  return BoundConstrainedQP(std::make_shared<const DenseCompliance>(C),
                            dealii::Vector<double>(problem.F.begin(), problem.F.end()), K);
}

BoundConstrainedQP make_qp(const Problem &problem) {
  return make_qp(problem, AdmissibleSet::nonpositive(problem.F.size()));
}

void solve(const Problem &problem, const BoundConstrainedQP &qp, Checks &checks) {
  const dealii::Vector<double> zero(qp.size());
  for (const auto &[method, result, tolerance] :
       {std::tuple("psor", solve_by_psor(qp, zero, {1e-12, 1000, 1.1}), 1e-10),
        std::tuple("active set", solve_by_active_set(qp, {}, {1e-12, 100}), 1e-14),
        std::tuple("active set from zero", solve_by_active_set(qp, zero, {1e-12, 100}), 1e-14)}) {
    checks.about(problem.name + ", " + method);
    checks.near("P", std::vector<double>(result.P.begin(), result.P.end()), problem.P, tolerance);
    checks.that("converged", result.converged);
  }
}

/** One patch with a normal unknown, P_0 <= 0, and a tangential one, |P_1| <= 1. */
const std::vector<Problem> two_components = {{"sticks", {{2, 1}, {1, 2}}, {-1.5, 0}, {-1, 0.5}},
                                             {"slides", {{2, 1}, {1, 2}}, {-1, 3}, {-1, 1}},
                                             {"slides back", {{2, 1}, {1, 2}}, {-3, -5}, {-1, -1}},
                                             {"opens", {{2, 1}, {1, 2}}, {2, 4}, {0, 1}}};

/** A patch in space that slips: C P - F = (0, -3, -4) is opposite to P_t = (0.6, 0.8). */
const Problem disc = {"slips", {{3, 1, 0}, {1, 2, 1}, {0, 1, 4}}, {-2.4, 4, 7.8}, {-1, 0.6, 0.8}};

void solve_in_space(Checks &checks) {
  dealii::Vector<double> one(1), none(1);
  one = 1.;
  for (const AdmissibleSet &K : {AdmissibleSet::with_tangential_part(one, none, 2),
                                 AdmissibleSet::with_tangential_part(none, one, 2)}) {
    const BoundConstrainedQP qp = make_qp(disc, K);
    for (const QPResult &result :
         {solve_by_psor(qp, {}, {1e-12, 1000, 1.1}), solve_by_active_set(qp, {}, {1e-12, 1000})}) {
      checks.near("disc: P", std::vector<double>(result.P.begin(), result.P.end()), disc.P, 1e-10);
      checks.near("disc: dissipation", K.at(result.P).dissipation(qp.gradient(result.P)), 5., 1e-9);
    }
  }
}

/** The energy falls in every sweep for every omega in (0, 2). */
void descend(const Problem &problem, Checks &checks) {
  const BoundConstrainedQP qp = make_qp(problem);
  bool falls = true;
  for (const double omega : {0.02, 0.5, 1., 1.5, 1.99}) {
    dealii::Vector<double> P(qp.size());
    for (unsigned int sweep = 0; sweep < 50; ++sweep) {
      const double before = qp.energy(P);
      psor_sweep(qp, omega, P);
      falls = falls && qp.energy(P) <= before + 1e-14;
    }
  }
  checks.that(problem.name + ", energy falls in every sweep", falls);
}
} // namespace

int main() {
  return run_tests({[](Checks &checks) {
    for (const Problem &problem : problems) {
      solve(problem, make_qp(problem), checks);
      descend(problem, checks);
    }
    for (const Problem &problem : two_components)
      solve(problem, make_qp(problem, AdmissibleSet({Interval(), {-1., 1.}})), checks);
    solve_in_space(checks);
    const BoundConstrainedQP qp = make_qp(problems[0]);
    const dealii::Vector<double> zero(2);
    for (const double omega : {-1., 0., 2., 2.05})
      checks.throws<std::invalid_argument>("omega outside (0,2)", "between 0 and 2", [&]() {
        solve_by_psor(qp, zero, {1e-10, 10, omega});
      });
    // At the solution the residual vanishes; elsewhere it is the projected step.
    checks.near("residual at zero", qp.kkt_residual(zero), 1., 1e-15);
    // A gap far away on a tiny face, where F/C is 1e16, does not hide that the first set is wrong.
    const Problem far_away = {"", {{2, 1, 0}, {1, 2, 0}, {0, 0, 1e-16}}, {-2, 1, 1}, {-1, 0, 0}};
    const QPResult found = solve_by_active_set(make_qp(far_away), {}, {1e-12, 100});
    checks.near("a gap far away: P", std::vector<double>(found.P.begin(), found.P.end()),
                far_away.P, 1e-14);
    checks.that("sweeps run out", !solve_by_psor(qp, zero, {1e-12, 3, 0.1}).converged);
    dealii::FullMatrix<double> indefinite(1, 1);
    checks.throws<std::invalid_argument>("diagonal of C", "not positive", [&]() {
      BoundConstrainedQP(indefinite, dealii::Vector<double>(1));
    });
  }});
}
