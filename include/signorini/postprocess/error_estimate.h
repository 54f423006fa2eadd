// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/elasticity/displacement_space.h>

namespace Signorini
{
/** An a posteriori estimate of ‖u - u_h‖_{1,Omega}. */
struct ErrorEstimate
{
  /** ‖pi^{2h} u_h - u_h‖_{1,Omega}; asymptotically exact where pi^{2h} u_h superconverges. */
  double absolute;
  /** The same divided by ‖pi^{2h} u_h‖_{1,Omega}. */
  double relative;
};

/** Compares u_h with pi^{2h} u_h. Needs Mesh::has_parents(). Collective. */
template <int dim>
ErrorEstimate estimate_error(const DisplacementSpace<dim> &space, const NodalVector &U);
} // namespace Signorini
