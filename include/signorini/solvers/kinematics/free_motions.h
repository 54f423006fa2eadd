// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/solvers/contact/dual_solver.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace Signorini
{
/** The data of k generalised displacements q beside the pressures: rigid motions of a body that
 * contact alone holds (K = 0), or travels of rigid plates (K is the resistance of the body). Each
 * q_j may have its own unit. */
struct FreeMotions
{
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

/** The solution of a dual problem with free motions, or the reason why there is none. */
struct MotionResult
{
  /** The pressure P, its residual (see solve_dual_problem) and the linear solves or sweeps of all
   * inner problems; cycled, increment_iterations and active_set_failure are those of the last inner
   * problem. Without a solution P = 0, not converged. */
  QPResult qp;
  /** The k motions; one of several solutions where pressing patches leave a motion free (tipping
   * about an edge). */
  dealii::Vector<double> q;
  /** A motion v with K v = 0, B v ≤ 0 (it opens or slides everywhere) and b.v > 0, if there is no
   * solution. Its largest part is one in units in which the columns of B have norm one. */
  std::optional<dealii::Vector<double>> escape;
  /** The motions v with K v = 0, B v = 0 and b.v = 0: nothing determines them, and q has no part of
   * them. They are scaled like the escape. */
  std::vector<dealii::Vector<double>> unseen;
  /** The number of inner problems that were solved. */
  unsigned int outer_iterations = 0;
  /** The reason in one sentence, where there is neither convergence nor an escape. */
  std::optional<std::string> failure;
};

/**
 * Solves the dual problem with free motions: P and q with
 *
 * W = C P + B q - F ≤ 0,   P ≤ 0,   P.W = 0,   K q - Bᵀ P = b.
 *
 * Existence is decided first (ReducedMotions::escape). Then follows proximal iteration: with a
 * small matrix E,
 *
 * (K + E) q_new = b + Bᵀ P + E q_old,
 *
 * is inserted into W. This leaves a dual problem in P with the compliance C + B (K + E)⁻¹ Bᵀ,
 * which the chosen method solves (with columns on demand where they are expensive). E is 1e-4
 * (projected SOR: 0.3) of the stiffness B_Aᵀ C_AA⁻¹ B_A of the contact, so the error of q falls
 * by that factor. After each step, and for the start, P and q are computed exactly on the patches
 * that press (solve_on_pressing); the state with the smaller residual is kept. (R. T. Rockafellar,
 * Math. Oper. Res. 1 (1976) 97-116: convergence of proximal iteration for every E.)
 *
 * The KKT residual is that of BoundConstrainedQP with W as above, and with the imbalance r = b +
 * Bᵀ P - K q as further entries:
 *
 * (|P - min(0, P - W/diag C)|² + |r|²)^{1/2} / max(|P|, |F/diag C|, |b|),
 *
 * 0 if all vanish; r and b are divided by the norms of the columns of B, which gives them the unit
 * of P. F/diag C counts on patches that press or penetrate only: gaps far away are irrelevant.
 * Where columns of C are expensive, C_ii of patches that do not press is estimated from another
 * one.
 *
 * @param start a pressure to start from; empty: that of an elastic bedding of separate springs.
 * @throws std::invalid_argument if sizes do not fit together or K is not symmetric.
 */
MotionResult solve_dual_problem(const std::shared_ptr<const ComplianceOperator> &C,
                                const dealii::Vector<double> &F,
                                const FreeMotions &motions,
                                const dealii::Vector<double> &start,
                                const DualSolverOptions &options);
} // namespace Signorini
