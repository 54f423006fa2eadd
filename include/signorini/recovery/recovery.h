// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/multiplier/coupling.h>
#include <signorini/stiffness_inverse/stiffness_inverse.h>

namespace Signorini
{
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
