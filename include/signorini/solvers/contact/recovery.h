// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/discretization/elasticity/linear_system.h>
#include <signorini/discretization/multiplier/multiplier_space.h>
#include <signorini/solvers/stiffness/stiffness_inverse.h>

namespace Signorini
{
/** The body without contact pressure, and the opening that this leaves. */
struct FreeState
{
  /** U_0 = A^{-1} f, complete. */
  NodalVector U;
  /** F = G - D^T U_0: free opening of each patch, negative where the body penetrates
   * (length^dim). */
  dealii::Vector<double> F;

  /** Whether F >= 0: then P = 0 solves the dual problem, and C is not needed. */
  bool nothing_touches() const;
};

/** F = G - D^T A^{-1} f, one solve. Collective. */
template <int dim>
FreeState solve_free_state(const StiffnessInverse &inverse,
                           const DisplacementSpace<dim> &space,
                           const DistributedVector &f,
                           const Coupling &D,
                           const dealii::Vector<double> &G);

/** Step (iv) of the algorithm: U = A^{-1}(D P + f), (23). Collective. */
template <int dim>
NodalVector recover_displacement(const StiffnessInverse &inverse,
                                 const DisplacementSpace<dim> &space,
                                 const Coupling &condensed_D,
                                 const dealii::Vector<double> &P,
                                 const DistributedVector &f);

/** A^{-1} b with homogeneous essential conditions: what the forces b (compressed here) add to a
 * displacement. Collective. */
template <int dim>
NodalVector solve_homogeneous(const StiffnessInverse &inverse,
                              const DisplacementSpace<dim> &space,
                              DistributedVector &b);

/** k + A^{-1} T^T r: the displacement with what is prescribed, k, for r = f - A k. Every rank knows
 * all entries of both. Collective. */
template <int dim>
NodalVector solve_prescribed(const StiffnessInverse &inverse,
                             const DisplacementSpace<dim> &space,
                             const NodalVector &k,
                             const NodalVector &r);
} // namespace Signorini
