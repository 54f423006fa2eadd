// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/multiplier/coupling.h>
#include <signorini/stiffness_inverse/stiffness_inverse.h>

#include <functional>
#include <optional>

namespace Signorini
{
/** What u_h lacks because p_H is constant on patches: z_h in V^h, and its energy norm. */
struct PressureCorrection
{
  /** Nodal values of z_h, zero where displacements are prescribed; empty: zero. */
  NodalVector z;
  /** |||z_h||| (root of force x length^{dim-1}). */
  double energy_norm = 0.;
};

/** P of the dual problem with C = D^T A^{-1} D for a D and its condensed form, with F, from a
 * start; none where the solver fails. */
using DualProblem =
  std::function<std::optional<dealii::Vector<double>>(const Coupling &D,
                                                      const Coupling &condensed_D,
                                                      const dealii::Vector<double> &F,
                                                      const dealii::Vector<double> &start)>;

/** What a correction is computed from; all must outlive the call. */
template <int dim>
struct PressureData
{
  const DisplacementSpace<dim> &space;
  const Scene<dim> &scene;
  const MultiplierSpace<dim> &multipliers;
  /** U_0 = A^{-1} f, complete, and P. */
  const NodalVector &U_free;
  const dealii::Vector<double> &P;
  const Coupling &condensed_D;
  const StiffnessInverse &inverse;
  /** Gauss points per direction for the gap, as in the dual problem. */
  unsigned int n_points;
  /** For patches longer than two faces; empty: their own pressure is recovered. */
  DualProblem solve_dual;
};

/** b_j = int_{Gamma_c} p v_n for v = phi_j, condensed, for the recovered pressure p of @p P,
 * shifted to the means of @p P and cut off at zero: a coupling with a single column. */
template <int dim>
Coupling recovered_load(const DisplacementSpace<dim> &space,
                        const MultiplierSpace<dim> &multipliers,
                        const dealii::Vector<double> &P);

/**
 * z_h = A^{-1}(b - D P) for b = int p v_n: with p = sigma_n(u), u_h + z_h would be the best
 * approximation of u in V^h. p is the RecoveredPressure of p_H with the means of p_H, see
 * recovered_load(). Where patches are longer than two faces, V^h sees more of the pressure than p_H
 * does. Then p is recovered from the solution on patches of two faces per direction (the same A,
 * one more dual problem). It does not penetrate between the means of the given patches, either.
 *
 * One solve; none, and zero, where the pressure vanishes. Patches shorter than two faces are not
 * corrected: p_H swings on them, and no function of V^h sees the difference. Collective.
 */
template <int dim>
PressureCorrection correct_pressure(const PressureData<dim> &data);
} // namespace Signorini
