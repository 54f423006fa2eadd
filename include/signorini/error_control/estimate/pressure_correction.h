// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/solvers/methods/level_operators.h>
#include <signorini/solvers/methods/solved.h>

namespace Signorini {
/** The correction z_h in V^h of u_h for p_H being constant on patches, and its energy norm. */
struct PressureCorrection {
  /** The nodal values of z_h, zero where displacements are prescribed; if there are none, z_h = 0.
   */
  Displacement z;
  /** The energy norm |||z_h||| (root of force x length^{dim-1}). */
  double energy_norm = 0.;
};

/** Returns b_j = ∫_{Γ_c} p v_n for v = φ_j, condensed, as a coupling with a single column.
 * p is the recovered pressure of @p P, shifted to the means of @p P and cut off at zero. */
template <int dim>
Coupling recovered_load(const DisplacementSpace<dim> &space,
                        const MultiplierSpace<dim> &multipliers, const Pressure &P);

/**
 * Returns z_h = A⁻¹(b - D P) with b_j = ∫ p v_n: with p = σ_n(u), u_h + z_h would be the
 * best approximation of u in V^h. p is the RecoveredPressure of p_H with the means of p_H, see
 * recovered_load(). With friction b contains q v_t, where q is recovered like p and cut off at the
 * bound of friction.
 *
 * The correction costs one solve. It is zero, without a solve, where the pressure vanishes. Patches
 * shorter than two faces are not corrected: p_H oscillates on them, and no function of V^h sees the
 * difference. Collective.
 */
template <int dim>
PressureCorrection correct_pressure(const Solved<dim> &solved,
                                    const LevelOperators<dim> &operators);

/**
 * Returns the same for a pressure that is better where patches are longer than two faces: V^h
 * resolves more of the pressure there than p_H does. Then p is recovered from the solution on
 * patches of two faces per direction, which costs one more dual problem with the same A (not after
 * V-cycles, where each column of C would be a linear solve, and not with friction). That solution
 * does not penetrate between the means of the given patches, either. Collective.
 */
template <int dim>
PressureCorrection correct_by_finer_patches(const Solved<dim> &solved,
                                            const LevelOperators<dim> &operators);
} // namespace Signorini
