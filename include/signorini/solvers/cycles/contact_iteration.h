// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/discretization/multiplier/multiplier_space.h>
#include <signorini/solvers/cycles/boundary_model.h>
#include <signorini/solvers/stiffness/stiffness_inverse.h>

#include <optional>
#include <string>

namespace Signorini
{
/** (5) without entries of A; all must outlive its use. With U = T U_free + k the unknown is U_free,
 * which is zero in constrained rows. */
struct ContactSystem
{
  const StiffnessOperator &A;
  /** f, condensed: reduced by what k contributes (force). */
  const NodalVector &f;
  /** T^T D. */
  const Coupling &condensed_D;
  /** G - D^T k (length^dim). */
  const dealii::Vector<double> &gap;
  /** C^_1. */
  const BoundaryModel &model;
  /** |T^T loads|_2; f is far larger where large displacements are prescribed (force). */
  double loads = 0.;

  /** r = f + D P - A U. */
  NodalVector residual(const NodalVector &U, const dealii::Vector<double> &P) const;
  /** W = D^T U - G. */
  dealii::Vector<double> opening(const NodalVector &U) const;
};

/** What the iteration is told. */
struct ContactIterationOptions
{
  /** On the KKT residual: that of the dual problem with t C^_1 in place of C and the true W. */
  double tolerance = 1e-10;
  /** On |f + D P - A U|_2 relative to max(|D P|_2, loads), but to not less than a thousandth of the
   * largest of its terms; and on |P.W| relative to P.t C^_1 P. What rounding leaves is enough. */
  double stationarity = 1e-9;
  /** If positive: end also when the energy norm of a step is below this part of that of U. */
  double energy_tolerance = 0.;
  /** V-cycles before giving up, those of MINRES included. */
  unsigned int maximum_cycles = 1000;
  /** t; zero: from Lanczos' method. */
  double scale = 0.;
};

/** What it has found. */
struct ContactIterationResult
{
  /** U_free. */
  NodalVector U;
  dealii::Vector<double> P;
  /** t. */
  double scale = 0.;
  /** V-cycles of the iteration, and those that went into t. */
  unsigned int cycles = 0, cycles_for_scale = 0;
  double kkt_residual = 0.;
  double stationarity = 0.;
  /** |P.W| relative to P.t C^_1 P. */
  double complementarity = 0.;
  /** What rounding makes of the last two. */
  double rounding_of_stationarity = 0., rounding_of_complementarity = 0.;
  /** The unit roundoff times about |A|. */
  double rounding_of_A = 0.;
  /** r.V r/2, from that before the last step: about the part of the duality gap that the
   * stationarity leaves (energy). */
  double energy_of_residual = 0.;
  bool converged = false;
  /** Why MINRES had to take over; empty if it had not. */
  std::optional<std::string> stalled;
};

/**
 * t C^_1 for the iteration: 0.6 times the largest eigenvalue of C^_1^{-1} D^T V D by Lanczos'
 * method, where V <= A^{-1} stands for A^{-1}. The iteration needs t > lambda_max(C^_1^{-1} C)/2.
 * @param n_steps of Lanczos' method; each is one V-cycle.
 */
double estimate_scale(const ContactSystem &system, unsigned int n_steps);

/**
 * Solves A U - D P = f, P <= 0, W = D^T U - G <= 0, P.W = 0 by V-cycles, each followed by a problem
 * on the boundary:
 *
 *     U <- U + V (f + D P - A U),
 *     P <- Q <= 0 with W + t C^_1 (Q - P) <= 0, Q.(W + t C^_1 (Q - P)) = 0,
 *
 * with Anderson's acceleration while {P < 0} stays the same (two differences, 24 bytes per degree
 * of freedom).
 *
 * Where steps grow, t is doubled, up to twice. Where they shrink by less than a fifth per step for
 * long, MINRES takes over (see solve_by_minres()), and the result says so.
 *
 * @param U, P the start; U is zero in constrained rows, P <= 0.
 */
ContactIterationResult solve_contact_by_cycles(const ContactSystem &system,
                                               const NodalVector &U,
                                               const dealii::Vector<double> &P,
                                               const ContactIterationOptions &options);
} // namespace Signorini
