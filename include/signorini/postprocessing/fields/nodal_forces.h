// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/discretization/space/internal_forces.h>
#include <signorini/discretization/space/linear_system.h>
#include <signorini/discretization/space/multiplier_space.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace Signorini {
/** The forces at all degrees of freedom j (force per thickness); every rank stores all of them.
 * They are integrals over cells; the assembled and factorised A is not used. */
struct NodalForces {
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

  /** The energy a(u_h, u_h)/2, without the translation of the whole body: that has no strain
   * energy, but its product with rounding of forces may be large. */
  double strain_energy = 0.;
  /** The largest displacement, relative to the largest without this translation. */
  double translation = 1.;
  /** The size of u_h; where it is rigid, all forces are rounding. */
  EnergyScale energy;

  /** Returns the norm of the largest of the forces. */
  double largest() const;
  /** Returns the scale of residuals: the largest of the forces, or, where the body moves rigidly,
   * the size of the terms that cancel. */
  double scale() const {
    return energy.rigid ? std::max(magnitude, largest()) : largest();
  }
  /** Returns the smallest scale of energies: zero where the body is strained. */
  double rigid_energy() const {
    return std::pow(energy.rigid.value_or(0.), 2);
  }
};

/**
 * Computes the forces. Collective.
 * @param loads LinearSystem::loads.
 */
template <int dim>
NodalForces nodal_forces(const BodyInContact<dim> &body, const DualVector &loads,
                         const Coupling &D);

/** Returns the force and the moment of every plate of the scene: the work of NodalForces::residual
 * on its motions. A node at the end of the plate belongs to the plate. */
template <int dim>
std::vector<PlateForce<dim>> plate_forces(const DisplacementSpace<dim> &space,
                                          const Scene<dim> &scene, const NodalForces &forces);
} // namespace Signorini
