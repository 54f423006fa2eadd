// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/columns.h>
#include <signorini/base/dealii.h>
#include <signorini/discretization/space/internal_forces.h>
#include <signorini/error_control/estimate/pressure_correction.h>

#include <optional>

namespace Signorini {
/** The parts of an error that neither π^{2h} nor a recovered pressure shows (energy norms). */
struct OtherErrors {
  /** The error that the contact solver leaves, see algebraic_error(). */
  double algebra = 0.;
  /** The error in contact, see contact_part(). */
  double contact = 0.;
};

/**
 * A posteriori estimates of the error. Let p be a better pressure than p_H, and z_h in V^h its
 * contribution to u_h (PressureCorrection). With the exact pressure u_h + z_h is the best
 * approximation of u, so that u - u_h - z_h is orthogonal to V^h, and
 *
 *     |||u - u_h|||² = |||u - (u_h + z_h)|||² + |||z_h|||².
 *
 * The first part is estimated by the distance to π^{2h}. The errors of u_h and p_H against the
 * solution on this mesh, and errors that no recovered pressure shows, come on top (OtherErrors).
 * Energy norms are roots of force x length^{dim-1}. An estimate that comes from elsewhere has no
 * parts.
 */
struct ErrorEstimate {
  /** The distance ‖π^{2h} u_h - u_h‖_{1,Ω}, which estimates ‖u - u_h‖_1. It is asymptotically
   * exact where π^{2h} u_h superconverges and |||z_h||| is small. */
  std::optional<double> h1;
  /** The estimate of |||u - u_h|||: the root of the sum of the squares of all parts, of
   * those of pressure and contact of the larger one, as both show the error of p_H. */
  double energy = 0.;
  /** The estimate divided by EnergyScale::of(): it depends neither on units nor on translations. */
  double relative = 0.;
  /** The part of the mesh, |||π^{2h} v - v||| for v = u_h + z_h. */
  std::optional<double> mesh;
  /** The part of the pressure, |||z_h|||. */
  std::optional<double> pressure;
  /** The parts of OtherErrors. */
  std::optional<double> algebra = {}, contact = {};
  /** In 2-D the energy |||π^{2h} u_h|||², by the same rule. */
  std::optional<double> post_strain = {};

  static Columns<ErrorEstimate> columns();
};

/** Estimates the error: compares u_h and u_h + z_h with their interpolations on T^{2h}. Needs
 * Mesh::has_parents(). Runs on all threads given, and the sums do not depend on their number.
 * Collective. */
template <int dim>
ErrorEstimate estimate_error(const DisplacedBody<dim> &body, const EnergyScale &scale,
                             const PressureCorrection &correction = {},
                             const OtherErrors &others = {});

/** Returns the number of generations with which PatchInterpolation comes closest to u: 2 (degree
 * four) where it changes π^{2h} u_h by less than 2/3 of the change from u_h to π^{2h} u_h, else 1
 * (degree two, π^{2h} itself); 0 (u_h) where there is no T^{2h}. On meshes that are too coarse for
 * the solution the quartic oscillates more than that. Collective. */
template <int dim>
unsigned int best_interpolation(const DisplacementSpace<dim> &space, const Displacement &U);
} // namespace Signorini
