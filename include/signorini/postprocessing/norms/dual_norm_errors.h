// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/columns.h>
#include <signorini/base/dealii.h>
#include <signorini/discretization/space/displacement_space.h>
#include <signorini/discretization/space/multiplier_space.h>
#include <signorini/postprocessing/norms/cosine_norm.h>
#include <signorini/problem/parameters/options.h>

#include <map>
#include <optional>

namespace Signorini {
/** The errors of the contact pressure in |||.|||_{-1/2,Γ_c}, the root of the sum of squares
 * over the contact sides. */
struct DualNormErrors {
  /** The error |||p - p_H||| in the cosine norm and in the paper's (Sobolev-Slobodeckij) norm. */
  double spectral;
  std::optional<double> slobodeckij;
  /** The distance |||R^H p - p_H||| in the same norms. */
  double superclose_spectral;
  std::optional<double> superclose_slobodeckij;

  static Columns<DualNormErrors> columns();
};

/** The exact pressure on the contact sides, prepared for the norms of all levels. */
template <int dim>
class ExactPressure {
public:
  /** Computes 8192 cosine coefficients per side; in 3-D 256 in each direction. Needs
   * Scene::has_exact_pressure(). */
  explicit ExactPressure(const Scene<dim> &scene);

  /** Returns the errors. The paper's norm is Richardson's extrapolation of grids with 8 m and 16 m
   * cells, m the patches of the side. It is left out where a side has more than 128 of them (its
   * cost grows like m³), on arcs (distances are not arc lengths there), and in 3-D. */
  DualNormErrors errors(const MultiplierSpace<dim> &space, const Pressure &P) const;

  /** Returns R^H p: the mean of p on every patch. */
  dealii::Vector<double> project(const MultiplierSpace<dim> &space) const;

private:
  const Scene<dim> &scene_;
  std::map<unsigned int, typename CosineNorm<dim>::Modes> coefficients_;
};

/** The left-hand sides of the paper's lemmas and auxiliary bounds for one level. */
struct LemmaNumbers {
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
LemmaNumbers compute_lemma_numbers(const DisplacementSpace<2> &space, const Scene<2> &scene,
                                   const MultiplierSpace<2> &multipliers, const Coupling &D,
                                   const ExactPressure<2> &pressure, const DualVector &loads,
                                   LinearSolver linear_solver, unsigned int n_points);
} // namespace Signorini
