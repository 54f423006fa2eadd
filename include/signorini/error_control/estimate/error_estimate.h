// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/columns.h>
#include <signorini/base/dealii.h>
#include <signorini/discretization/elasticity/internal_forces.h>
#include <signorini/discretization/multiplier/multiplier_space.h>
#include <signorini/solvers/methods/contact_method.h>

#include <optional>

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
 * recovered_load(). Where patches are longer than two faces, V^h resolves more of the pressure than
 * p_H does. Then p is recovered from the solution on patches of two faces per direction, which
 * costs one more dual problem with the same A (not after V-cycles, where each column of C would be
 * a linear solve, and not with friction). That solution does not penetrate between the means of the
 * given patches, either.
 *
 * With friction b contains q v_t, where q is recovered like p and cut off at the bound of friction.
 *
 * The correction costs one solve. It is zero, without a solve, where the pressure vanishes. Patches
 * shorter than two faces are not corrected: p_H oscillates on them, and no function of V^h sees the
 * difference. Collective.
 */
template <int dim>
PressureCorrection correct_pressure(const Discretization<dim> &discretization,
                                    const Scene<dim> &scene, const ContactSolution<dim> &contact);

/** The parts of an error that neither π^{2h} nor a recovered pressure shows (energy norms). */
struct OtherErrors {
  /** The error that the contact solver leaves, see algebraic_error(). */
  double algebra = 0.;
  /** The error where u_h misses contact, see energy_of_missed_contact(). */
  double contact = 0.;
};

/**
 * A posteriori estimates of the error. Let p be a better pressure than p_H, and z_h in V^h what it
 * adds to u_h (PressureCorrection). With the exact pressure u_h + z_h is the best approximation of
 * u, so that u - u_h - z_h is orthogonal to V^h, and
 *
 *     |||u - u_h|||² = |||u - (u_h + z_h)|||² + |||z_h|||².
 *
 * The first part is estimated by the distance to π^{2h}. What u_h and p_H lack of the solution on
 * this mesh, and what no recovered pressure shows, comes on top (OtherErrors). Energy norms are
 * roots of force x length^{dim-1}. An estimate that comes from elsewhere has no parts.
 */
struct ErrorEstimate {
  /** The distance ‖π^{2h} u_h - u_h‖_{1,Ω}, which estimates ‖u - u_h‖_1. It is asymptotically
   * exact where π^{2h} u_h superconverges and |||z_h||| is small. */
  std::optional<double> h1;
  /** The estimate of |||u - u_h|||: the root of the sum of the squares of all parts. */
  double energy = 0.;
  /** The estimate divided by EnergyScale::of(): it depends neither on units nor on translations. */
  double relative = 0.;
  /** The part of the mesh, |||π^{2h} v - v||| for v = u_h + z_h. */
  std::optional<double> mesh;
  /** The part of the pressure, |||z_h|||. */
  std::optional<double> pressure;
  /** The parts of OtherErrors. */
  std::optional<double> algebra = {}, contact = {};

  static Columns<ErrorEstimate> columns();
};

/** Estimates the error: compares u_h and u_h + z_h with their interpolations on T^{2h}. Needs
 * Mesh::has_parents(). Runs on all threads given, and the sums do not depend on their number.
 * Collective. */
template <int dim>
ErrorEstimate estimate_error(const DisplacementSpace<dim> &space, const Scene<dim> &scene,
                             const Displacement &U, const EnergyScale &scale,
                             const PressureCorrection &correction = {},
                             const OtherErrors &others = {});

/** Returns the number of generations with which PatchInterpolation comes closest to u: 2 (degree
 * four) where it changes π^{2h} u_h by less than 2/3 of what π^{2h} changes u_h, else 1 (degree
 * two, π^{2h} itself); 0 (u_h) where there is no T^{2h}. On meshes that are too coarse for the
 * solution the quartic oscillates more than that. Collective. */
template <int dim>
unsigned int best_interpolation(const DisplacementSpace<dim> &space, const Displacement &U);

/**
 * Returns the energy norm of a w that removes the penetration of open patches which touch no
 * pressing one. There u_h may be deep in the foundation while u_n - g has a mean that is not
 * positive, and no recovered pressure shows it. With d = (u_n - g)_+ on a patch of length H, w has
 * about the energy of a half-space with waves of the length 4 H,
 *
 *     |||w|||² = modulus π/(2 H) ‖d‖_0².
 *
 * The function is for 3-D only: in 2-D the guaranteed bound has the energy of a true w.
 * @throws InputError where g has no value. Collective.
 */
double energy_of_missed_contact(const DisplacementSpace<3> &space,
                                const MultiplierSpace<3> &multipliers, const Scene<3> &scene,
                                const Displacement &U, const Pressure &P);
} // namespace Signorini
