// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/solvers/contact/dual_problem.h>

#include <optional>
#include <vector>

namespace Signorini {
/** The state of an unknown: at the lower end of its interval, inside, or at the upper end. */
enum class State : char { lower, inside, upper };
using States = std::vector<State>;

inline State state_of(const AdmissibleSet &K, const unsigned int i, const double p) {
  return K.is_inside(i, p) ? State::inside : p >= K[i].upper ? State::upper : State::lower;
}

inline States states_of(const AdmissibleSet &K, const dealii::Vector<double> &P) {
  States states(K.size());
  for (unsigned int i = 0; i < K.size(); ++i)
    states[i] = state_of(K, i, P[i]);
  return states;
}

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
  void add(const double factor, const dealii::Vector<double> &change,
           dealii::Vector<double> &to) const {
    for (unsigned int r = 0; r < A.size(); ++r)
      to[A[r]] += factor * change[r];
    for (const Follower &follower : followers)
      to[follower.P_t] += factor * follower.factor * change[follower.P_n];
  }

  ComplianceOperator::Indices A;
  std::vector<Follower> followers;
  dealii::Vector<double> P;
};

/** A pressure and free motions, and the slipping unknown that stops first in a motion that the
 * states leave free. */
struct Iterate {
  dealii::Vector<double> P, z;
  std::optional<unsigned int> stopping = {};
};

/**
 * Solves C_AA P_A + B_A z = F_A - C_AI e_I, P_I = e_I, K z - Bᵀ P = b by block elimination, with
 * the Schur complement S of the motions. With motions or followers three passes more solve for what
 * rounding leaves: rows of patches on tiny faces are small, and LU does not scale rows. In a motion
 * that neither K nor patches of A resist the body moves until a slipping patch stops, or not at
 * all.
 * @throws ExceptionBase if C_AA is not positive definite.
 */
Iterate solve_on_set(const BoundConstrainedQP &qp, const States &states);

/**
 * Solves the problem of Coulomb's friction in the plane along a path: of the solutions of problems
 * between the given one (τ = 0) and one with open gaps and without loads (τ = 1), which P = 0
 * solves. It consists of straight pieces, one for each set of states. A piece ends where the first
 * inequality of an unknown becomes an equality; the next one leads to where the inequality of its
 * new state holds, so that τ may grow again. This is Lemke's method, written for intervals that
 * move: as a linear complementarity problem Coulomb's has a copositive matrix, and then the path
 * leads to τ = 0 for every f (R. Cottle, J.-S. Pang, R. Stone: The Linear Complementarity Problem,
 * 1992, section 4.4). A step costs some products with a matrix of the size of C.
 *
 * @return the states at τ = 0; nothing where rounding leads elsewhere.
 */
std::optional<States> follow_solutions(const BoundConstrainedQP &qp);
} // namespace Signorini
