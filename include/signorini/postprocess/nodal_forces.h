// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/elasticity/linear_system.h>
#include <signorini/multiplier/coupling.h>
#include <signorini/multiplier/multiplier_space.h>

#include <algorithm>
#include <optional>

namespace Signorini
{
/** The forces at all degrees of freedom j (force per thickness), known to all ranks. They come from
 * integrals over cells; nothing here uses the assembled and factorised A. */
struct NodalForces
{
  /** a(u_h, phi_j). */
  NodalVector internal;
  /** int f.phi_j + int_{Gamma_F} t.phi_j. */
  NodalVector loads;
  /** int_{Gamma_c} p_H phi_j.n. */
  NodalVector contact;
  /** internal - loads - contact: zero on free, the reaction on constrained degrees of freedom. */
  NodalVector residual;
  /** |A| |U|: the size of the terms that make up the internal forces. */
  double magnitude = 0.;

  /** norm_of_rigid_motion(); if there is one, all forces are rounding. */
  std::optional<double> rigid;

  /** The norm of the largest of the forces. */
  double largest() const;
  /** What residuals are compared with: the largest of the forces, or, where the body moves rigidly,
   * the size of the terms that cancel. */
  double scale() const
  {
    return rigid ? std::max(magnitude, largest()) : largest();
  }
  /** What energies are compared with at least: zero where the body is strained. */
  double rigid_energy() const
  {
    return rigid.value_or(0.) * rigid.value_or(0.);
  }
};

/** @param loads LinearSystem::loads. Collective. */
template <int dim>
NodalForces nodal_forces(const DisplacementSpace<dim> &space,
                         const Scene<dim> &scene,
                         const DistributedVector &loads,
                         const Coupling &D,
                         const NodalVector &U,
                         const dealii::Vector<double> &P);

/** int p_H n and int p_H x × n over a piece of Gamma_c. */
template <int dim>
Resultant<dim> contact_resultant(const MultiplierSpace<dim> &multipliers,
                                 const dealii::Vector<double> &P,
                                 const Piece<dim> &piece);
} // namespace Signorini
