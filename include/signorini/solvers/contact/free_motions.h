// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/solvers/contact/dual_solver.h>

#include <memory>
#include <optional>
#include <vector>

namespace Signorini {
/** The data of k generalised displacements q beside the pressures: rigid motions of a body that
 * contact alone holds (K = 0), or travels of rigid plates (K is the resistance of the body). Each
 * q_j may have its own unit. */
struct FreeMotions {
  /** The entry B_ij is the amount by which motion j closes patch i, in the unit of W per unit of
   * q_j; m x k. */
  FullMatrix<double> B;
  /** The elastic resistance, symmetric and positive semi-definite, k x k. */
  FullMatrix<double> K;
  /** The work of the loads in the motions; k entries. */
  dealii::Vector<double> b;
  /** The sums of the absolute values of the terms of b_j; b_j has a rounding error relative to
   * them. Empty: |b_j|. */
  dealii::Vector<double> b_magnitude = {};
};

/**
 * The free motions in coordinates z without units: q = T z, where columns of B have norm one before
 * they are combined. Motions without any resistance (K v = 0, B v = 0) are left out.
 */
struct ReducedMotions {
  using Vector = dealii::Vector<double>;
  using Matrix = FullMatrix<double>;

  /**
   * Reduces the motions.
   * @param admissible the set of P.
   * @param stiffness a typical stiffness of the contact, the sum over all patches of |B_i|²/C_ii
   * with columns of B of norm one. K is zero where it is below 1e-12 of it.
   */
  ReducedMotions(const FreeMotions &motions, const AdmissibleSet &admissible, double stiffness);

  /** The balances of the n ≤ k reduced motions; without a pressure if a motion escapes. */
  Balances balances;
  /** The matrix T, k x n. */
  Matrix T;
  /**
   * A motion v with K v = 0, B v ≤ 0 (it opens or slides everywhere) and b.v > 0, if there is one.
   * Its largest part is one in units in which the columns of B have norm one.
   *
   * b has to lie in the cone {-Bᵀ P : P ≤ 0}, with friction in {-Bᵀ P : P in K(P)}, as far as the
   * stiffness K does not resist. Nonnegative least squares
   * with rows of B of norm one decide this (a cone depends on directions only): the remainder of b
   * is the motion that escapes. Remainders below 1e-9 of b are rounding: a load just above the edge
   * of a body does not tip it.
   */
  std::optional<Vector> escape;
  /** The motions v with K v = 0, B v = 0 and b.v = 0: nothing determines them, and q has no part of
   * them. They are scaled like the escape. */
  std::vector<Vector> neutral;
};

/** Steady sliding: a motion v along which contact sides slide, with the work of the loads in it,
 * and that of friction. */
struct Sliding {
  dealii::Vector<double> v;
  double load, resistance;
  /** The pressure, which balances in all motions but v. */
  dealii::Vector<double> P = {};

  /** Returns whether the loads keep it up; at the limit they do not. */
  bool lasts() const {
    constexpr double rounding = 1e-12;
    return resistance < (1. - rounding) * load;
  }
};

/** The solution of a dual problem with free motions, or the reason why there is none. */
struct MotionResult {
  /** The pressure P. Without a solution P = 0, not converged. */
  QPResult qp;
  /** The k motions. */
  dealii::Vector<double> q;
  /** See ReducedMotions. With friction the cone is larger than that of loads which elastic patches
   * carry, so that a body that slides may be seen later: then this is the motion of its sliding. */
  std::optional<dealii::Vector<double>> escape;
  std::vector<dealii::Vector<double>> neutral;
  /** With friction: the sliding of a body that escapes along its contact sides. */
  std::optional<Sliding> sliding;
};

/**
 * Solves the dual problem with free motions: P and q with
 *
 *     W = C P + B q - F,  P in K,  Wᵀ(Q - P) ≥ 0 for all Q in K,   R q - Bᵀ P = b
 *
 * with the resistance R = FreeMotions::K.
 *
 * Existence is decided first (ReducedMotions::escape); then the reduced motions are the multipliers
 * of Balances.
 *
 * @param start a pressure to start from; empty: none.
 */
MotionResult solve_dual_problem(const std::shared_ptr<const ComplianceOperator> &C,
                                const dealii::Vector<double> &F, const AdmissibleSet &K,
                                const FreeMotions &motions, const dealii::Vector<double> &start,
                                const DualSolverOptions &options);

/** Returns the regularity of a solution with Coulomb's friction, see examine_regularity(). */
std::optional<Regularity> examine_regularity(const std::shared_ptr<const ComplianceOperator> &C,
                                             const FreeMotions &motions, const AdmissibleSet &K,
                                             const dealii::Vector<double> &P);
} // namespace Signorini
