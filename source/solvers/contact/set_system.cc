// SPDX-License-Identifier: LGPL-2.1-or-later
// The linear system of a set of states, and uniqueness with Coulomb's friction.

#include <signorini/solvers/contact/active_set.h>
#include <signorini/solvers/contact/dual_solver.h>

#include <deal.II/lac/exceptions.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <limits>

namespace Signorini {
namespace {
using Vector = dealii::Vector<double>;
using Indices = ComplianceOperator::Indices;

/** A direction of few unknowns: their numbers and its components. */
using Direction = boost::container::small_vector<std::pair<unsigned int, double>, 2>;

double product(const Direction &direction, const Vector &v) {
  double sum = 0.;
  for (const auto &[unknown, component] : direction)
    sum += component * v[unknown];
  return sum;
}

/**
 * The linear system of a set: P = P_0 + Σ_j y_j trial_j with test_j·W + stiffness_j y_j = 0. With
 * Coulomb's law the bound of a P_t that slips follows its P_n: there trial_j is test_j and the
 * change of that P_t.
 */
struct ActiveSet {
  /** Collects the unknowns, see solve_on_set(). */
  ActiveSet(const BoundConstrainedQP &qp, const States &states, const Vector &a)
    : P_0(qp.size()) {
    const AdmissibleSet &K = qp.K, K_at_a = K.n_discs() > 0 ? K.at(a) : AdmissibleSet();
    std::vector<unsigned int> index_in_test(states.size());
    for (unsigned int i = 0; i < states.size(); ++i) {
      const unsigned int second = i + K.n_discs();
      const double end = states[i] == State::lower ? K[i].lower : K[i].upper, f = K.coefficient(i);
      Direction e = {{i, 1.}};
      if (states[i] == State::inside) {
        index_in_test[i] = test.size();
        add(e);
        if (K.is_disc(i))
          add({{second, 1.}});
        continue;
      }
      if (K.is_disc(i)) {
        const double size = K.length(i, a), s = K_at_a[i].upper;
        if (!(s > 0.))
          continue;
        e = {{i, a[i] / size}, {second, a[second] / size}};
        add({{i, -e[1].second}, {second, e[0].second}}, (size / s - 1.) * qp.diagonal[i]);
      }
      for (const auto &[unknown, component] : e) {
        P_0[unknown] = end * component;
        if (f > 0. && states[i - K.n_normal()] == State::inside)
          trial[index_in_test[i - K.n_normal()]].emplace_back(
            unknown, (states[i] == State::upper ? -f : f) * component);
      }
    }
  }

  unsigned int size() const {
    return test.size();
  }
  Vector P(const Vector &y) const {
    Vector P(P_0);
    for (unsigned int j = 0; j < size(); ++j)
      for (const auto &[unknown, component] : trial[j])
        P[unknown] += component * y[j];
    return P;
  }
  /** Returns the numbers of the unknowns that bounds follow. */
  Indices followed() const {
    Indices numbers;
    for (unsigned int j = 0; j < size(); ++j)
      if (trial[j].size() > test[j].size())
        numbers.push_back(j);
    return numbers;
  }
  /** Returns the matrix for trial directions: all of them, or test without followers. */
  FullMatrix<double> matrix(const FullMatrix<double> &C,
                            const std::vector<Direction> &directions) const {
    FullMatrix<double> result = tested(C, directions);
    for (unsigned int j = 0; j < size(); ++j)
      result(j, j) += stiffness[j];
    return result;
  }
  /** Returns test_i·M d_j. */
  FullMatrix<double> tested(const FullMatrix<double> &M,
                            const std::vector<Direction> &directions) const {
    FullMatrix<double> result(size(), directions.size());
    for (unsigned int i = 0; i < size(); ++i)
      for (unsigned int j = 0; j < directions.size(); ++j)
        for (const auto &[row, weight] : test[i])
          for (const auto &[column, component] : directions[j])
            result(i, j) += weight * component * M(row, column);
    return result;
  }

  Vector P_0;
  std::vector<Direction> test, trial;
  std::vector<double> stiffness;

private:
  void add(const Direction &direction, const double with_stiffness = 0.) {
    test.push_back(direction);
    trial.push_back(direction);
    stiffness.push_back(with_stiffness);
  }
};

/** Returns d_j·B for directions d_j. */
FullMatrix<double> rows_of(const FullMatrix<double> &B, const std::vector<Direction> &directions) {
  FullMatrix<double> rows(directions.size(), B.n());
  for (unsigned int j = 0; j < directions.size(); ++j)
    for (const auto &[unknown, component] : directions[j])
      for (unsigned int k = 0; k < B.n(); ++k)
        rows(j, k) += component * B(unknown, k);
  return rows;
}

/** Factorises a matrix that is not symmetric. @throws LACExceptions::ExcSingular */
LAPACKFullMatrix<double> lu(const FullMatrix<double> &M) {
  LAPACKFullMatrix<double> factor(M.m());
  factor = M;
  factor.compute_lu_factorization();
  return factor;
}

/** The pseudoinverse of the Schur complement S of the motions, and the projector on the motions
 * that the set leaves free; empty where there are none. */
struct InvertedResistance {
  explicit InvertedResistance(FullMatrix<double> S)
    : inverse(S.m()) {
    constexpr double rounding = 1e-13;
    const unsigned int n = S.m();
    if (n == 0)
      return;
    const Splitting by_S(S, rounding * S.frobenius_norm());
    if (by_S.null.n() > 0) {
      // No pressure of the set balances a free motion: that equation is left out.
      FullMatrix<double> rest(n, n);
      projector_on(by_S.rest, n).mmult(rest, S);
      S = rest;
      free = projector_on(by_S.null, n);
    }
    inverse = S;
    inverse.compute_inverse_svd(rounding);
  }

  LAPACKFullMatrix<double> inverse;
  FullMatrix<double> free;
};

/**
 * Moves x along the free motion that friction drives. It comes from far away, where everything
 * slips against that motion, and ends where the first unknown stops (the ratio test of pivoting
 * methods: in the plane Coulomb's problem is a linear complementarity problem).
 */
void move_until_one_stops(const BoundConstrainedQP &qp, const States &states,
                          const FullMatrix<double> &free, Iterate &x) {
  Vector pull(x.z.size()), motion(x.z.size()), slip(qp.size());
  for (unsigned int i = 0; i < qp.size(); ++i)
    for (unsigned int j = 0; j < pull.size() && states[i] != State::inside; ++j)
      pull[j] += qp.balances.B(i, j) * x.P[i];
  free.vmult(motion, pull);
  qp.balances.B.vmult(slip, motion);
  const Vector W = qp.gradient(x.P, x.z);
  constexpr double rounding = 1e-10;
  double nearest = std::numeric_limits<double>::max();
  for (unsigned int i = 0; i < qp.size(); ++i)
    if (states[i] != State::inside && x.P[i] * slip[i] > 0. &&
        std::abs(slip[i]) > rounding * slip.linfty_norm() && -W[i] / slip[i] < nearest) {
      nearest = -W[i] / slip[i];
      x.stopping = i;
    }
  if (x.stopping)
    x.z.add(nearest, motion);
}
} // namespace

Iterate solve_on_set(const BoundConstrainedQP &qp, const States &states, const Vector &a) {
  const unsigned int n = qp.balances.size();
  const ActiveSet set(qp, states, a);
  Iterate x = {set.P_0, Vector(n)};
  if (set.size() == 0 && n == 0)
    return x;
  const bool follows = !set.followed().empty();
  const FullMatrix<double> matrix = set.matrix(qp.C->dense(), set.trial);
  const LAPACKFullMatrix<double> factor = follows ? lu(matrix) : cholesky(matrix, qp.rounding());
  const MotionResistance resistance(qp.balances.K, rows_of(qp.balances.B, set.test),
                                    rows_of(qp.balances.B, set.trial), factor);
  const InvertedResistance S(resistance.S);
  const unsigned int n_passes = n > 0 || follows ? 4 : 1;
  Vector y(set.size()), dy(y), dz(n);
  for (unsigned int pass = 0; pass < n_passes; ++pass) {
    const Vector W = qp.gradient(x.P, x.z);
    for (unsigned int j = 0; j < y.size(); ++j)
      dy[j] = -product(set.test[j], W) - set.stiffness[j] * y[j];
    if (y.size() > 0) {
      factor.solve(dy);
      y += dy;
    }
    x.P = set.P(y);
    if (n == 0)
      continue;
    S.inverse.vmult(dz, qp.imbalance(x.P, x.z));
    x.z += dz;
    for (unsigned int j = 0; j < n && y.size() > 0; ++j)
      y.add(-dz[j], resistance.X[j]);
    x.P = set.P(y);
  }
  if (S.free.m() > 0 && qp.size() > 0)
    move_until_one_stops(qp, states, S.free, x);
  return x;
}

namespace {
/** Returns the slipping part of -H_0⁻¹ H_1, where H_0 + λ H_1 is the linear system of a set with
 * the balances. @throws ExceptionBase if H_0 is singular. */
FullMatrix<double> slipping_part(const BoundConstrainedQP &qp, const ActiveSet &set,
                                 const Indices &slipping) {
  const unsigned int n = qp.balances.size(), n_slip = slipping.size();
  const LAPACKFullMatrix<double> factor = cholesky(set.matrix(qp.C->dense(), set.test));
  std::vector<Direction> followers;
  for (const unsigned int j : slipping)
    followers.emplace_back(set.trial[j].begin() + set.test[j].size(), set.trial[j].end());
  const FullMatrix<double> B_A = rows_of(qp.balances.B, set.test),
                           B_F = rows_of(qp.balances.B, followers),
                           C_F = set.tested(qp.C->dense(), followers);
  const MotionResistance resistance(qp.balances.K, B_A, B_A, factor);
  FullMatrix<double> inverse(resistance.S);
  if (n > 0)
    inverse.gauss_jordan();
  FullMatrix<double> part(n_slip, n_slip);
  for (unsigned int j = 0; j < n_slip; ++j) {
    Vector y(set.size()), rest(n), z(n);
    for (unsigned int r = 0; r < y.size(); ++r)
      y[r] = C_F(r, j);
    factor.solve(y);
    for (unsigned int i = 0; i < n; ++i) {
      rest[i] = -B_F(j, i);
      for (unsigned int r = 0; r < y.size(); ++r)
        rest[i] += B_A(r, i) * y[r];
    }
    if (n > 0)
      inverse.vmult(z, rest);
    for (unsigned int i = 0; i < n; ++i)
      y.add(-z[i], resistance.X[i]);
    for (unsigned int i = 0; i < n_slip; ++i)
      part(i, j) = -y[slipping[i]];
  }
  return part;
}
} // namespace

std::optional<Regularity> examine_regularity(const BoundConstrainedQP &qp, const Vector &P) {
  if (!qp.K.moves())
    return {};
  const ActiveSet set(qp, states_of(qp.K.at(P), P), P);
  const Indices slipping = set.followed();
  Regularity regularity;
  if (slipping.empty())
    return regularity;
  LAPACKFullMatrix<double> part(slipping.size());
  try {
    const FullMatrix<double> found = slipping_part(qp, set, slipping);
    // Where the slipping set leaves a motion free, H_0 is singular, and LAPACK would print.
    if (!std::isfinite(found.frobenius_norm()))
      return {};
    part = found;
  } catch (const ExceptionBase &) {
    return {};
  }
  part.compute_eigenvalues();
  constexpr double rounding = 1e-10;
  double largest = 0.;
  for (unsigned int i = 0; i < part.m(); ++i) {
    const auto eigenvalue = part.eigenvalue(i);
    regularity.fixed_point_rate = std::max(regularity.fixed_point_rate, std::abs(eigenvalue));
    if (eigenvalue.real() > 0. && std::abs(eigenvalue.imag()) <= rounding * eigenvalue.real()) {
      largest = std::max(largest, eigenvalue.real());
      regularity.keeps_sign ^= eigenvalue.real() > 1.;
    }
  }
  if (largest > 0.)
    regularity.critical_factor = 1. / largest;
  return regularity;
}
} // namespace Signorini
