// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/discretization/elasticity/linear_system.h>
#include <signorini/discretization/multiplier/multiplier_space.h>

#include <algorithm>
#include <optional>
#include <vector>

namespace Signorini
{
/** A node of a multiplier on its side. */
struct SideNode
{
  /** The arc length (length). */
  double s;
  bool presses;
};

/** The nodes of one side in the order of arc length. */
struct SideNodes
{
  /** The number of the side in the geometry. */
  unsigned int number = 0;
  double length = 0.;
  bool closed = false;
  std::vector<SideNode> nodes;
};

/** Returns the nodes of all multipliers, side after side; those below pressing_threshold(P) press.
 */
std::vector<SideNodes> nodes_by_side(const MultiplierSpace<2> &multipliers, const Pressure &P);

/** The forces at all degrees of freedom j (force per thickness); every rank stores all of them.
 * They are integrals over cells; the assembled and factorised A is not used. */
struct NodalForces
{
  /** The internal forces a(u_h, φ_j). */
  DualVector internal;
  /** The loads ∫ f.φ_j + ∫_{Γ_F} t.φ_j. */
  DualVector loads;
  /** The contact forces ∫_{Γ_c} p_H φ_j.n. */
  DualVector contact;
  /** The residual internal - loads - contact: zero on free, the reaction on constrained degrees of
   * freedom. */
  DualVector residual;
  /** The size |A| |U| of the terms that make up the internal forces. */
  double magnitude = 0.;

  /** The result of norm_of_rigid_motion(); if there is one, all forces are rounding. */
  std::optional<double> rigid;

  /** Returns the norm of the largest of the forces. */
  double largest() const;
  /** Returns the scale of residuals: the largest of the forces, or, where the body moves rigidly,
   * the size of the terms that cancel. */
  double scale() const
  {
    return rigid ? std::max(magnitude, largest()) : largest();
  }
  /** Returns the smallest scale of energies: zero where the body is strained. */
  double rigid_energy() const
  {
    return rigid.value_or(0.) * rigid.value_or(0.);
  }
};

/**
 * Computes the forces. Collective.
 * @param loads LinearSystem::loads.
 */
template <int dim>
NodalForces nodal_forces(const DisplacementSpace<dim> &space,
                         const Scene<dim> &scene,
                         const DistributedVector &loads,
                         const Coupling &D,
                         const Displacement &U,
                         const Pressure &P);

/** Returns ∫ p_H n and ∫ p_H x × n over a piece of Γ_c. */
template <int dim>
Resultant<dim> contact_resultant(const MultiplierSpace<dim> &multipliers,
                                 const Pressure &P,
                                 const Piece<dim> &piece);

/** The force and the moment that act on the body through a plate (per thickness). */
struct PlateForce
{
  /** The force along the plate's direction. */
  double force = 0.;
  /** The moment about the plate's centre, counter-clockwise. */
  double moment = 0.;
};

/** Returns the force and the moment of every plate of the scene: the work of NodalForces::residual
 * on its motions. A node at the end of the plate belongs to the plate. */
template <int dim>
std::vector<PlateForce> plate_forces(const DisplacementSpace<dim> &space,
                                     const Scene<dim> &scene,
                                     const NodalForces &forces);
} // namespace Signorini
