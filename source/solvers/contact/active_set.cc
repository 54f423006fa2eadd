// SPDX-License-Identifier: LGPL-2.1-or-later
// The active set method, and what its last linear system says about uniqueness with friction.

#include <signorini/solvers/contact/dual_solver.h>
#include <signorini/solvers/contact/projected_methods.h>

#include <deal.II/lac/exceptions.h>
#include <deal.II/lac/lapack_full_matrix.h>

#include <algorithm>
#include <limits>
#include <random>
#include <set>

namespace Signorini {
namespace {
using Vector = dealii::Vector<double>;
using Indices = ComplianceOperator::Indices;

/** The state of an unknown: at the lower end of its interval, inside, or at the upper end. */
enum class State : char { lower, inside, upper };
using States = std::vector<State>;

State state_of(const AdmissibleSet &K, const unsigned int i, const double p) {
  return K.is_inside(i, p) ? State::inside : p >= K[i].upper ? State::upper : State::lower;
}

States states_of(const AdmissibleSet &K, const Vector &P) {
  States states(K.size());
  for (unsigned int i = 0; i < K.size(); ++i)
    states[i] = state_of(K, i, P[i]);
  return states;
}

/** A pressure and free motions, and the slipping unknown that stops first in a motion that the
 * states leave free. */
struct Iterate {
  Vector P, z;
  std::optional<unsigned int> stopping = {};
};

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

/**
 * Solves C_AA P_A + B_A z = F_A - C_AI e_I, P_I = e_I, K z - Bᵀ P = b by block elimination, with
 * the Schur complement S of the motions. With motions or followers three passes more solve for what
 * rounding leaves: rows of patches on tiny faces are small, and LU does not scale rows. In a motion
 * that neither K nor patches of A resist the body moves until a slipping patch stops, or not at
 * all.
 * @throws ExceptionBase if C_AA is not positive definite.
 */
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

/** Returns the states of P - W/diag C, which the solution x for @p states predicts. In x, W
 * vanishes on active unknowns. */
States improve(const BoundConstrainedQP &qp, const States &states, const Iterate &x) {
  const Vector W = qp.gradient(x.P, x.z);
  Vector predicted(x.P);
  for (unsigned int i = 0; i < qp.size(); ++i)
    if (states[i] != State::inside)
      predicted[i] -= W[i] / qp.diagonal[i];
  States next = states_of(qp.K.at(predicted), predicted);
  if (x.stopping)
    next[*x.stopping] = State::inside;
  return next;
}

/** Returns the residual that rounding leaves after a solve with C_AA. */
double rounding_level(const BoundConstrainedQP &qp) {
  return (qp.size() + 10) * std::numeric_limits<double>::epsilon();
}

/** Moves P towards the wanted one; where an unknown would leave its interval, only to the first end
 * that is met, which that unknown keeps. @return whether P is the wanted one. */
bool step_to_first_end(const BoundConstrainedQP &qp, const Vector &wanted, Vector &P,
                       States &states) {
  const AdmissibleSet &K = qp.K;
  double size = 0.;
  for (const double b : qp.balances.b)
    size = std::max(size, std::abs(b));
  for (unsigned int i = 0; i < P.size(); ++i)
    if (states[i] == State::inside)
      size = std::max({size, std::abs(wanted[i]), std::abs(qp.F[i]) / qp.diagonal[i]});
  const double rounding = 1e-13 * size;
  double part = 1.;
  unsigned int leaving = P.size();
  for (unsigned int i = 0; i < P.size(); ++i)
    if (states[i] == State::inside && std::abs(wanted[i] - K.project(i, wanted[i])) > rounding) {
      const double here = (K.project(i, wanted[i]) - P[i]) / (wanted[i] - P[i]);
      if (leaving == P.size() || here < part) {
        part = here;
        leaving = i;
      }
    }
  P.sadd(1. - part, part, wanted);
  K.project(P);
  if (leaving == P.size())
    return true;
  P[leaving] = K.project(leaving, wanted[leaving]);
  states[leaving] = P[leaving] >= K[leaving].upper ? State::upper : State::lower;
  return false;
}

/** Sets other states where a set that moves came back, because no energy falls there: those after
 * sweeps of projected SOR, which help for moderate coefficients, or random ones. */
void restart(const BoundConstrainedQP &qp, const Vector &P, std::minstd_rand &random,
             States &states) {
  if (random() % 2 == 0) {
    const Vector swept = solve_by_psor(qp, P, {1e-6, 100, 1., {}}).P;
    states = states_of(qp.K.at(swept), swept);
    return;
  }
  for (unsigned int i = 0; i < states.size(); ++i)
    states[i] = static_cast<State>(qp.K.coefficient(i) > 0. ? random() % 3 : 1 + random() % 2);
}

/** Lets the unknown join whose residual is largest. @return whether there is one above rounding. */
bool join_deepest(const BoundConstrainedQP &qp, const Iterate &x, States &states) {
  const Vector W = qp.gradient(x.P, x.z);
  double largest = 0.;
  for (unsigned int i = 0; i < qp.size(); ++i)
    largest = std::max({largest, std::abs(qp.F[i]), std::abs(qp.F[i] + W[i])});
  double deepest = 0.;
  unsigned int joining = qp.size();
  for (unsigned int i = 0; i < qp.size(); ++i) {
    const double inward = std::abs(qp.K.inward(i, x.P[i], W[i]));
    if (states[i] != State::inside && inward > 1e-13 * largest &&
        inward > deepest * qp.diagonal[i]) {
      deepest = inward / qp.diagonal[i];
      joining = i;
    }
  }
  if (joining < qp.size())
    states[joining] = State::inside;
  return joining < qp.size();
}
} // namespace

QPResult solve_by_active_set(const BoundConstrainedQP &qp, const Vector &start,
                             const IterationOptions &options) {
  const bool moves = qp.balances.size() > 0;
  QPResult result;
  Iterate x;
  States states =
    start.size() == 0 ? States(qp.size(), State::inside) : states_of(qp.K.at(start), start);
  std::set<States> visited;
  std::minstd_rand random;
  const unsigned int max_solves = std::min(options.maximum_iterations, 20 * qp.size() + 100);
  for (bool settled = false; !settled && result.iterations < max_solves;) {
    ++result.iterations;
    const Iterate wanted = solve_on_set(qp, states);
    // Where P and W vanish together, rounding changes the set each time, although P is the
    // solution.
    Vector projected = wanted.P;
    qp.K.at(projected).project(projected);
    const double residual =
      qp.kkt_residual(projected, wanted.z, qp.gradient(projected, wanted.z), false);
    if (!result.cycled) {
      x = wanted;
      visited.insert(states);
      const States next = improve(qp, states, x);
      const bool came_back = visited.count(next) > 0;
      settled = residual <= rounding_level(qp) ||
                (next == states && (!moves || residual <= options.tolerance)) ||
                (came_back && residual <= 1e-3 * options.tolerance);
      result.cycled = came_back && !settled;
      states = next;
      if (result.cycled && qp.K.moves()) {
        restart(qp, projected, random, states);
        result.cycled = false;
      } else if (result.cycled) {
        if (moves)
          x.P = qp.balances.P;
        qp.K.project(x.P);
        states = states_of(qp.K, x.P);
      }
    } else {
      settled = residual <= std::max(rounding_level(qp), 1e-3 * options.tolerance);
      if (settled || step_to_first_end(qp, wanted.P, x.P, states)) {
        x = wanted;
        settled = settled || !join_deepest(qp, x, states);
      }
    }
  }
  qp.K.at(x.P).project(x.P);
  result.P = x.P;
  result.z = x.z;
  result.kkt_residual = qp.kkt_residual(result.P, result.z);
  result.converged = result.kkt_residual <= options.tolerance;
  return result;
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
