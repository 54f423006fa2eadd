// SPDX-License-Identifier: LGPL-2.1-or-later
// The linear system of a set of states, and what it says about uniqueness with friction.

#include <signorini/solvers/contact/active_set.h>
#include <signorini/solvers/contact/dual_solver.h>

#include <deal.II/lac/exceptions.h>

#include <limits>

namespace Signorini {
namespace {
using Vector = dealii::Vector<double>;
using Indices = ComplianceOperator::Indices;

/** A bound that follows a pressure: P_t changes by the factor times the change of P_n. */
struct Follower {
  unsigned int P_t;
  /** The place of P_n among the active unknowns. */
  unsigned int P_n;
  double factor;
};

/** The active unknowns A, the bounds that follow them, and the rest of P. */
struct ActiveSet {
  ActiveSet(const AdmissibleSet &K, const States &states)
    : P(K.size()) {
    std::vector<unsigned int> place(K.size());
    const unsigned int n_patches = K.size() / 2;
    for (unsigned int i = 0; i < K.size(); ++i)
      if (states[i] == State::inside) {
        place[i] = A.size();
        A.push_back(i);
      } else {
        P[i] = states[i] == State::upper ? K[i].upper : K[i].lower;
        if (const double f = K.coefficient(i); f > 0. && states[i - n_patches] == State::inside)
          followers.push_back({i, place[i - n_patches], states[i] == State::upper ? -f : f});
      }
  }
  /** Adds a change of the active unknowns to a P. */
  void add(const double factor, const Vector &change, Vector &to) const {
    for (unsigned int r = 0; r < A.size(); ++r)
      to[A[r]] += factor * change[r];
    for (const Follower &follower : followers)
      to[follower.P_t] += factor * follower.factor * change[follower.P_n];
  }

  Indices A;
  std::vector<Follower> followers;
  Vector P;
};

/** Returns C_AA, which contains the columns of followers. */
FullMatrix<double> matrix_of(const ComplianceOperator &C, const ActiveSet &set) {
  FullMatrix<double> C_AA = submatrix(C, set.A);
  for (const Follower &follower : set.followers)
    for (unsigned int r = 0; r < set.A.size(); ++r)
      C_AA(r, follower.P_n) += follower.factor * C.dense()(set.A[r], follower.P_t);
  return C_AA;
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
    LAPACKFullMatrix<double> svd(n);
    svd = S;
    svd.compute_svd();
    FullMatrix<double> null(n, n), held(n, n);
    for (unsigned int k = 0; k < n; ++k)
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < n; ++j)
          (svd.singular_value(k) > rounding * svd.singular_value(0) ? held : null)(i, j) +=
            svd.get_svd_vt()(k, i) * svd.get_svd_vt()(k, j);
    if (svd.singular_value(n - 1) <= rounding * svd.singular_value(0)) {
      // No pressure of the set balances a free motion: that equation is left out.
      FullMatrix<double> rest(n, n);
      held.mmult(rest, S);
      S = rest;
      free = null;
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
  Vector friction(x.z.size()), motion(x.z.size()), slip(qp.size());
  for (unsigned int i = 0; i < qp.size(); ++i)
    for (unsigned int j = 0; j < friction.size() && states[i] != State::inside; ++j)
      friction[j] += qp.balances.B(i, j) * x.P[i];
  free.vmult(motion, friction);
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

Iterate solve_on_set(const BoundConstrainedQP &qp, const States &states) {
  const unsigned int n = qp.balances.size();
  const ActiveSet set(qp.K, states);
  const Indices &A = set.A;
  Iterate x = {set.P, Vector(n)};
  if (A.empty() && n == 0)
    return x;
  const LAPACKFullMatrix<double> C_AA =
    set.followers.empty() ? cholesky(matrix_of(*qp.C, set)) : lu(matrix_of(*qp.C, set));
  MotionResistance resistance(qp.balances, A, C_AA);
  for (const Follower &follower : set.followers)
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        resistance.S(i, j) +=
          qp.balances.B(follower.P_t, i) * follower.factor * resistance.X[j][follower.P_n];
  const InvertedResistance S(resistance.S);
  const unsigned int n_passes = n > 0 || !set.followers.empty() ? 4 : 1;
  for (unsigned int pass = 0; pass < n_passes; ++pass) {
    const Vector W = qp.gradient(x.P, x.z);
    Vector dP(A.size()), dz(n);
    for (unsigned int r = 0; r < A.size(); ++r)
      dP[r] = -W[A[r]];
    if (!A.empty())
      C_AA.solve(dP);
    set.add(1., dP, x.P);
    if (n == 0)
      continue;
    S.inverse.vmult(dz, qp.imbalance(x.P, x.z));
    x.z += dz;
    for (unsigned int j = 0; j < n; ++j)
      set.add(-dz[j], resistance.X[j], x.P);
  }
  // Sums over the passes round: exactly at their bounds, followers slip.
  for (const Follower &follower : set.followers)
    x.P[follower.P_t] = set.P[follower.P_t] + follower.factor * x.P[A[follower.P_n]];
  if (S.free.m() > 0 && qp.size() > 0)
    move_until_one_stops(qp, states, S.free, x);
  return x;
}

// Uniqueness with Coulomb's friction.

namespace {
/** Returns the slipping part of -H_0⁻¹ H_1, where H_0 + λ H_1 is the linear system of a set with
 * the balances. @throws ExceptionBase if H_0 is singular. */
FullMatrix<double> slipping_part(const BoundConstrainedQP &qp, const ActiveSet &set) {
  const unsigned int n = qp.balances.size(), n_slip = set.followers.size();
  const LAPACKFullMatrix<double> C_AA = cholesky(submatrix(*qp.C, set.A));
  const MotionResistance resistance(qp.balances, set.A, C_AA);
  FullMatrix<double> inverse(resistance.S);
  if (n > 0)
    inverse.gauss_jordan();
  FullMatrix<double> part(n_slip, n_slip);
  for (unsigned int j = 0; j < n_slip; ++j) {
    const Follower &follower = set.followers[j];
    Vector y(set.A.size()), rest(n), z(n);
    for (unsigned int r = 0; r < set.A.size(); ++r)
      y[r] = follower.factor * qp.C->dense()(set.A[r], follower.P_t);
    C_AA.solve(y);
    for (unsigned int i = 0; i < n; ++i) {
      rest[i] = -follower.factor * qp.balances.B(follower.P_t, i);
      for (unsigned int r = 0; r < set.A.size(); ++r)
        rest[i] += qp.balances.B(set.A[r], i) * y[r];
    }
    if (n > 0)
      inverse.vmult(z, rest);
    for (unsigned int i = 0; i < n; ++i)
      y.add(-z[i], resistance.X[i]);
    for (unsigned int i = 0; i < n_slip; ++i)
      part(i, j) = -y[set.followers[i].P_n];
  }
  return part;
}
} // namespace

std::optional<Regularity> examine_regularity(const BoundConstrainedQP &qp, const Vector &P) {
  if (!qp.K.moves())
    return {};
  const ActiveSet set(qp.K, states_of(qp.K.at(P), P));
  Regularity regularity;
  if (set.followers.empty())
    return regularity;
  LAPACKFullMatrix<double> part(set.followers.size());
  try {
    part = slipping_part(qp, set);
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
      regularity.has_sign_of_no_friction ^= eigenvalue.real() > 1.;
    }
  }
  if (largest > 0.)
    regularity.critical_factor = 1. / largest;
  return regularity;
}
} // namespace Signorini
