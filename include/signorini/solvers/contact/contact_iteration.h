// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/discretization/space/multiplier_space.h>
#include <signorini/solvers/contact/boundary_model.h>
#include <signorini/solvers/stiffness/stiffness_inverse.h>

#include <optional>
#include <string>

namespace Signorini {
/** U_free, or a functional on it: a rank has the rows that it owns. P, W and the like are whole on
 * every rank. */
using NodalVector = StiffnessOperator::Vector;

/** The system (5) without entries of A; all must outlive its use. With U = T U_free + k the unknown
 * is U_free, which is zero in constrained rows. */
struct ContactSystem {
  const StiffnessOperator &A;
  /** The condensed f, reduced by the contribution of k (force). */
  const NodalVector &f;
  /** The condensed coupling Tᵀ D. */
  const Coupling &condensed_D;
  /** The gap G - Dᵀ k (length^dim). */
  const dealii::Vector<double> &gap;
  /** The model Ĉ_1. */
  const BoundaryModel &model;
  /** The norm |Tᵀ loads|_2; f is far larger where large displacements are prescribed (force). */
  double loads = 0.;

  /** Returns r = f + D P - A U. */
  NodalVector residual(const NodalVector &U, const dealii::Vector<double> &P) const;
  /** Returns W = Dᵀ U - G. */
  dealii::Vector<double> opening(const NodalVector &U) const;
};

/** The options of the iteration. */
struct ContactIterationOptions {
  /** The tolerance of the KKT residual: that of the dual problem with t Ĉ_1 instead of C and the
   * true W. */
  double tolerance = 1e-10;
  /** The tolerance of |f + D P - A U|_2 relative to max(|D P|_2, loads), but to not less than a
   * thousandth of the largest of its terms; and of |P.W| relative to P.t Ĉ_1 P. Residuals at the
   * level of rounding are accepted. */
  double stationarity = 1e-9;
  /** The limit of the number of V-cycles, those of MINRES included. */
  unsigned int maximum_cycles = 1000;
  /** The scale t; zero: from estimate_scale(). */
  double scale = 0.;
};

/** The result of the iteration. */
struct ContactIterationResult {
  /** The solution U_free. */
  NodalVector U;
  dealii::Vector<double> P;
  /** The scale t. */
  double scale = 0.;
  /** The number of V-cycles of the iteration, and of those for t. */
  unsigned int cycles = 0, cycles_for_scale = 0;
  double kkt_residual = 0.;
  double stationarity = 0.;
  /** The complementarity |P.W| relative to P.t Ĉ_1 P. */
  double complementarity = 0.;
  /** The part of the last two that is due to rounding. */
  double rounding_of_stationarity = 0., rounding_of_complementarity = 0.;
  /** The unit roundoff times an approximation of |A|. */
  double rounding_of_A = 0.;
  /** The energy r.V r/2, from the residual before the last step: approximately the part of the
   * duality gap that the stationarity leaves (energy). */
  double energy_of_residual = 0.;
  bool converged = false;
  /** The reason why MINRES took over; empty if it did not. */
  std::optional<std::string> stalled;
};

/**
 * Returns the scale t of t Ĉ_1 for the iteration: 0.6 times the largest eigenvalue of Ĉ_1⁻¹ Dᵀ
 * V D, where V ≤ A⁻¹ replaces A⁻¹. The iteration needs t > lambda_max(Ĉ_1⁻¹ C)/2.
 * @param n_steps of the power method; each is one V-cycle. It finds some 95 % of the eigenvalue.
 */
double estimate_scale(const ContactSystem &system, unsigned int n_steps);

/**
 * Solves A U - D P = f, P ≤ 0, W = Dᵀ U - G ≤ 0, P.W = 0 by V-cycles, each followed by a problem
 * on the boundary:
 *
 *     U <- U + V (f + D P - A U),
 *     P <- Q ≤ 0 with W + t Ĉ_1 (Q - P) ≤ 0, Q.(W + t Ĉ_1 (Q - P)) = 0,
 *
 * Anderson's acceleration is used while {P < 0} stays the same (two differences, 24 bytes per
 * degree of freedom).
 *
 * Where steps grow, t is doubled, up to twice. Where they shrink by less than a fifth per step for
 * long, MINRES takes over (see solve_by_minres()), and ContactIterationResult::stalled has the
 * reason.
 *
 * The problem on the boundary is solved on rank 0. Collective.
 *
 * @param U, P the start; U is zero in constrained rows, P ≤ 0.
 */
ContactIterationResult solve_contact_by_cycles(const ContactSystem &system, const NodalVector &U,
                                               const dealii::Vector<double> &P,
                                               const ContactIterationOptions &options);
} // namespace Signorini
