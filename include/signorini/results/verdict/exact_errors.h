// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/columns.h>

#include <optional>

namespace Signorini {
/** The distances of the discrete from the exact displacement; h1 is the full norm ‖.‖_{1,Ω}. */
struct DisplacementErrors {
  /** The error ‖u - u_h‖_{1,Ω}. */
  double h1;
  /** The error ‖u - u_h‖_{0,Ω}. */
  double l2;
  /** The distance ‖I^h u - u_h‖_{1,Ω}. */
  double superclose_h1;
  /** The error ‖u - π^{2h} u_h‖_{1,Ω}; empty where there is no T^{2h}. */
  std::optional<double> post_h1;
  /** The error ‖u - π₄^{4h} u_h‖_{1,Ω} of the interpolation of degree four on cells of
   * T^{4h}; empty where there is no T^{4h}. */
  std::optional<double> post4_h1;
  /** The error |||u - u_h|||, with the strain of u_h itself and Hooke's tensor at quadrature points
   * (root of force x length^{dim-1}). */
  double energy = 0.;

  static Columns<DisplacementErrors> columns();
};

/** The distances of the discrete from the exact contact pressure. */
struct PressureErrors {
  /** The error ‖p - p_H‖_{0,Γ_c}. */
  double l2;
  /** The error of the continuous pressure recovered from p_H. */
  double post_l2;

  static Columns<PressureErrors> columns();
};

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
} // namespace Signorini
