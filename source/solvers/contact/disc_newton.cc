// SPDX-License-Identifier: LGPL-2.1-or-later
// Newton's method for friction in space, where tangential tractions lie in discs.

#include <signorini/solvers/contact/dual_solver.h>
#include <signorini/solvers/contact/projected_methods.h>

#include <deal.II/lac/exceptions.h>
#include <deal.II/lac/lapack_full_matrix.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace Signorini {
namespace {
using Vector = dealii::Vector<double>;

/** A direction of few unknowns: their numbers and its components. */
using Direction = std::vector<std::pair<unsigned int, double>>;

double product(const Direction &direction, const Vector &v) {
  double sum = 0.;
  for (const auto &[unknown, component] : direction)
    sum += component * v[unknown];
  return sum;
}

/** The linear system of the states: P = fixed + Σ y_j trial_j with test_j.W + stiffness_j y_j = 0.
 */
struct DiscStates {
  /** Computes the states of P - W/diag C. */
  DiscStates(const BoundConstrainedQP &qp, const Vector &P)
    : fixed(qp.size()) {
    const unsigned int m = qp.K.n_discs();
    const Vector W = qp.gradient(P);
    Vector a(P);
    for (unsigned int i = 0; i < a.size(); ++i)
      a[i] -= W[i] / qp.diagonal[i];
    const AdmissibleSet K = qp.K.at(a);
    for (unsigned int k = 0; k < m; ++k) {
      const bool presses = K.is_inside(k, a[k]);
      if (presses)
        add({{k, 1.}});
      add_tangential(qp, K, a, k, presses ? trial.size() : 0);
    }
  }

  unsigned int size() const {
    return trial.size();
  }

  Vector fixed;
  std::vector<Direction> trial, test;
  std::vector<double> stiffness;

private:
  void add(const Direction &direction, const double with_stiffness = 0.) {
    trial.push_back(direction);
    test.push_back(direction);
    stiffness.push_back(with_stiffness);
  }

  /** Adds the unknowns of P_t of patch @p k. @param pressing the number of its P_n plus one; zero
   * if it is open. */
  void add_tangential(const BoundConstrainedQP &qp, const AdmissibleSet &K, const Vector &a,
                      const unsigned int k, const unsigned int pressing) {
    const unsigned int m = K.n_discs(), first = m + k, second = first + m;
    const double size = K.length(first, a), s = K[first].upper;
    if (K.is_inside(first, size)) {
      add({{first, 1.}});
      add({{second, 1.}});
      return;
    }
    if (!(s > 0.))
      return;
    const double e[2] = {a[first] / size, a[second] / size};
    const double f = pressing > 0 ? qp.K.coefficient(first) : 0., given = qp.K[first].upper;
    fixed[first] = given * e[0];
    fixed[second] = given * e[1];
    // With Coulomb's law the bound follows P_n.
    if (f > 0.) {
      trial[pressing - 1].emplace_back(first, -f * e[0]);
      trial[pressing - 1].emplace_back(second, -f * e[1]);
    }
    add({{first, -e[1]}, {second, e[0]}}, (size / s - 1.) * qp.diagonal[first]);
  }
};

/** Returns the solution of the linear system. @throws LACExceptions::ExcSingular */
Vector solve_on_states(const BoundConstrainedQP &qp, const DiscStates &states) {
  const unsigned int n = states.size();
  Vector P(states.fixed);
  if (n == 0)
    return P;
  const FullMatrix<double> &C = qp.C->dense();
  const Vector W = qp.gradient(P);
  LAPACKFullMatrix<double> H(n);
  Vector y(n), column(qp.size());
  for (unsigned int j = 0; j < n; ++j) {
    column = 0.;
    // C is symmetric.
    for (const auto &[unknown, component] : states.trial[j])
      for (unsigned int i = 0; i < qp.size(); ++i)
        column[i] += component * C(unknown, i);
    for (unsigned int i = 0; i < n; ++i)
      H(i, j) = product(states.test[i], column);
    H(j, j) += states.stiffness[j];
    y[j] = -product(states.test[j], W);
  }
  H.compute_lu_factorization();
  H.solve(y);
  for (unsigned int j = 0; j < n; ++j)
    for (const auto &[unknown, component] : states.trial[j])
      P[unknown] += y[j] * component;
  return P;
}

/** Performs a step of Newton's method, shorter where that decreases the residual and the whole step
 * does not. @throws LACExceptions::ExcSingular */
void newton_step(const BoundConstrainedQP &qp, Vector &P) {
  const Vector wanted = solve_on_states(qp, DiscStates(qp, P));
  const double before = qp.kkt_residual(P);
  const auto at = [&](const double part) {
    Vector there(P);
    there.sadd(1. - part, part, wanted);
    qp.K.at(there).project(there);
    return there;
  };
  const Vector whole = at(1.);
  constexpr double shortest = 1e-2;
  for (double part = 1.; part > shortest; part *= 0.5)
    if (const Vector there = at(part); qp.kkt_residual(there) < before) {
      P = there;
      return;
    }
  P = whole;
}

/** Performs sweeps of projected SOR. */
void sweep(const BoundConstrainedQP &qp, const unsigned int n_sweeps, Vector &P) {
  for (unsigned int i = 0; i < n_sweeps; ++i)
    psor_sweep(qp, 1., P);
  qp.K.at(P).project(P);
}

/** Returns a random P. */
Vector random_start(const BoundConstrainedQP &qp, const double size, std::minstd_rand &random) {
  Vector P(qp.size());
  std::uniform_real_distribution<double> share(-1., 1.);
  for (double &p : P)
    p = size * share(random);
  qp.K.at(P).project(P);
  return P;
}
} // namespace

QPResult solve_by_disc_newton(const BoundConstrainedQP &qp, const Vector &start,
                              const IterationOptions &options) {
  constexpr unsigned int patience = 4;
  const double rounding = (qp.size() + 10) * std::numeric_limits<double>::epsilon();
  QPResult result;
  std::minstd_rand random;
  unsigned int n_sweeps = 10, all_sweeps = 0, idle = 0;
  Vector P = start.size() > 0 ? start : Vector(qp.size());
  sweep(qp, n_sweeps, P);
  result.P = P;
  result.kkt_residual = qp.kkt_residual(P);
  while (result.kkt_residual > rounding && all_sweeps < options.maximum_iterations) {
    if (idle < patience)
      try {
        ++idle;
        ++result.iterations;
        newton_step(qp, P);
      } catch (const LACExceptions::ExcSingular &) {
        idle = patience;
      }
    else {
      idle = 0;
      n_sweeps += 10;
      all_sweeps += n_sweeps;
      if (qp.K.moves() && random() % 2 == 0)
        P = random_start(qp, result.P.linfty_norm(), random);
      else
        sweep(qp, n_sweeps, P = result.P);
    }
    if (const double residual = qp.kkt_residual(P); residual < 0.9 * result.kkt_residual) {
      result.P = P;
      result.kkt_residual = residual;
      idle = 0;
    } else if (result.kkt_residual <= options.tolerance)
      // What is left is rounding.
      break;
  }
  result.converged = result.kkt_residual <= options.tolerance;
  return result;
}
} // namespace Signorini
