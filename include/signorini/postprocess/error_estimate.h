// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/columns.h>
#include <signorini/elasticity/displacement_space.h>

namespace Signorini
{
/** An a posteriori estimate of ‖u - u_h‖_{1,Omega}. */
struct ErrorEstimate
{
  /** ‖pi^{2h} u_h - u_h‖_{1,Omega}; asymptotically exact where pi^{2h} u_h superconverges. */
  double absolute;
  /** The same divided by ‖pi^{2h} u_h‖_{1,Omega}, both with the body's size as the unit of length:
   * it does not depend on the units of the scene. */
  double relative;

  static Columns<ErrorEstimate> columns();
};

/**
 * Compares u_h with pi^{2h} u_h. Needs Mesh::has_parents(). Runs on all threads given, with the
 * same sums for any number of them. Collective.
 */
template <int dim>
ErrorEstimate estimate_error(const DisplacementSpace<dim> &space, const NodalVector &U);

/**
 * The number of generations with which PatchInterpolation comes closest to u: 2 (degree four) where
 * it changes pi^{2h} u_h by less than 2/3 of what pi^{2h} changes u_h, else 1 (degree two, pi^{2h}
 * itself); 0 (u_h) where there is no T^{2h}. On meshes that are too coarse for a solution the
 * quartic swings more than that. Collective.
 */
template <int dim>
unsigned int best_interpolation(const DisplacementSpace<dim> &space, const NodalVector &U);
} // namespace Signorini
