// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/solvers/contact/dual_problem.h>

#include <optional>
#include <vector>

namespace Signorini {
/** The states of all blocks. */
using States = std::vector<State>;

/** Returns the states of P in a set that does not move. */
inline States states_of(const AdmissibleSet &K, const dealii::Vector<double> &P) {
  States states(K.n_blocks());
  for (unsigned int i = 0; i < states.size(); ++i)
    states[i] = K.state(i, K.length(i, P));
  return states;
}

/** Returns the set that follows a set of active unknowns over {P ≤ 0}, for P and W that may be
 * inexact: {P < 0} within it and {W > 0} outside. @param joins whether {W > 0} joins from inside,
 * too: the first set of a P. */
inline std::vector<bool> next_set(const std::vector<bool> &set, const dealii::Vector<double> &P,
                                  const dealii::Vector<double> &W, const bool joins = false) {
  std::vector<bool> next(set.size());
  for (unsigned int i = 0; i < next.size(); ++i)
    next[i] = (set[i] && P[i] < 0.) || ((joins || !set[i]) && W[i] > 0.);
  return next;
}

/** A pressure and free motions, and the slipping unknown that stops first in a motion that the
 * states leave free. */
struct Iterate {
  dealii::Vector<double> P, z;
  std::optional<unsigned int> stopping = {};
};

/**
 * Solves C_AA P_A + B_A z = F_A - C_AI e_I, P_I = e_I, K z - Bᵀ P = b by block elimination, with
 * the Schur complement S of the motions. With motions or followers three passes more solve for the
 * residuals of rounding: rows of patches on tiny faces are small, and LU does not scale rows. In a
 * motion that neither K nor patches of A resist the body moves until a slipping patch stops, or not
 * at all.
 *
 * A disc that slips along e = a_t/|a_t| has P_t = s e + y e⊥, and the derivative of the projection
 * onto the disc gives one equation more:  W_t·e⊥ + (|a_t|/s - 1) C_tt y = 0.
 * @param a the point P - W/diag C that has the states; read with discs only.
 * @throws ExceptionBase if C_AA is not positive definite.
 */
Iterate solve_on_set(const BoundConstrainedQP &qp, const States &states,
                     const dealii::Vector<double> &a = {});

/** Returns the stiffness of springs against free motions that is a millionth of the resistance of
 * separate patches. */
double weak_spring(const BoundConstrainedQP &qp);

/**
 * Solves the problem of Coulomb's friction in the plane by Lemke's method (R. Cottle, J.-S. Pang,
 * R. Stone: The Linear Complementarity Problem, 1992, chapter 4), written for intervals that move.
 * It follows the solutions of problems whose F and b go from those of open gaps without loads
 * (τ = 1, where only P = 0 is a solution) to the given ones (τ = 0). The path consists of straight
 * pieces, one for each set of states. A piece ends where the first inequality becomes an equality;
 * the next one leads to where the inequality of the new state holds, so that τ may grow again. All
 * solutions are bounded and the path cannot return to P = 0: in exact arithmetic, and where no two
 * inequalities end at once, it comes to τ = 0 for every f. A step costs some products with a matrix
 * of the size of C. Weak springs hold a free body where no patch does.
 *
 * @return the states at τ = 0; nothing where rounding leads elsewhere.
 */
std::optional<States> follow_solutions(const BoundConstrainedQP &qp);
} // namespace Signorini
