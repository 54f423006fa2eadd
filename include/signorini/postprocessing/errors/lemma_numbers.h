// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/columns.h>
#include <signorini/discretization/multiplier/multiplier_space.h>
#include <signorini/postprocessing/errors/dual_norm_errors.h>
#include <signorini/problem/parameters/options.h>

#include <optional>

namespace Signorini
{
/** The left-hand sides of the paper's lemmas and auxiliary bounds for one level. */
struct LemmaNumbers
{
  /** The norms of Lemma 2, ‖p - R^H p‖_{0,Γ_c} and |||p - R^H p|||_{-1/2} in the cosine norm.
   */
  double projection_l2;
  double projection_dual;
  /** The norm of Lemma 3, ‖u - I^h u‖_{1,Ω}. */
  double interpolation_h1;
  /** The norm of Lemma 3, |||B(u - I^h u)|||_{1/2,Γ_c} in the cosine norm of every contact
   * side. */
  double interpolation_trace;
  /** The supremum of Lemma 5, sup_v a(u - I^h u, v) / ‖v‖_1 over V^h. */
  double consistency;
  /** The supremum of (26), sup_v [p - R^H p, B v] / ‖v‖_1 over V^h. */
  double bound_26;
  /** The supremum of (27), sup_q [q, B(I^h u - u)] / |||q|||_{-1/2} over Q^H. */
  double bound_27;
  /** The norm of (30), ‖u - π^{2h} u‖_{1,Ω}; empty where there is no T^{2h}. */
  std::optional<double> bound_30;

  static Columns<LemmaNumbers> columns();
};

/**
 * Computes the numbers with one factorisation of the Gram matrix A_1 of V^h: sup_v b(v)/‖v‖_1 is
 * (bᵀ A_1⁻¹ b)^{1/2}. Needs the exact displacement and pressure. Collective.
 *
 * @param loads f_j = ∫ f.φ_j + ∫ t.φ_j, not condensed.
 * @param n_points number of Gauss points per direction for integrals of the exact solution.
 */
LemmaNumbers compute_lemma_numbers(const DisplacementSpace<2> &space,
                                   const Scene<2> &scene,
                                   const MultiplierSpace<2> &multipliers,
                                   const Coupling &D,
                                   const ExactPressure<2> &pressure,
                                   const DistributedVector &loads,
                                   LinearSolver linear_solver,
                                   unsigned int n_points);
} // namespace Signorini
