// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/elasticity/linear_system.h>
#include <signorini/multiplier/coupling.h>
#include <signorini/stiffness_inverse/stiffness_inverse.h>

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
} // namespace Signorini
