// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/discretization/elasticity/linear_system.h>
#include <signorini/discretization/multiplier/multiplier_space.h>
#include <signorini/solvers/stiffness/stiffness_inverse.h>

namespace Signorini
{
/** The displacement of the body without contact pressure, and the opening that it leaves. */
struct FreeState
{
  /** The complete nodal values U_0 = A⁻¹ f. */
  Displacement U;
  /** The free opening F = G - Dᵀ U_0 of each patch, negative where the body penetrates
   * (length^dim). */
  dealii::Vector<double> F;

  /** Returns whether F ≥ 0: then P = 0 solves the dual problem, and C is not needed. */
  bool nothing_touches() const;
};

/** Computes F = G - Dᵀ A⁻¹ f by one solve. Collective. */
template <int dim>
FreeState solve_free_state(const StiffnessInverse &inverse,
                           const DisplacementSpace<dim> &space,
                           const DistributedVector &f,
                           const Coupling &D,
                           const dealii::Vector<double> &G);

/** Returns U = A⁻¹(D P + f), (23): step (iv) of the algorithm. Collective. */
template <int dim>
Displacement recover_displacement(const StiffnessInverse &inverse,
                                  const DisplacementSpace<dim> &space,
                                  const Coupling &condensed_D,
                                  const dealii::Vector<double> &P,
                                  const DistributedVector &f);

/** Returns A⁻¹ b with homogeneous essential conditions: the displacement that the forces b
 * (compressed here) add. Collective. */
template <int dim>
Displacement solve_homogeneous(const StiffnessInverse &inverse,
                               const DisplacementSpace<dim> &space,
                               DistributedVector &b);

/** Returns k + A⁻¹ Tᵀ r: the displacement with the prescribed values k, for r = f - A k.
 * Collective. */
template <int dim>
Displacement solve_prescribed(const StiffnessInverse &inverse,
                              const DisplacementSpace<dim> &space,
                              const Displacement &k,
                              const DualVector &r);
} // namespace Signorini
