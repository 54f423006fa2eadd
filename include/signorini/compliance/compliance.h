// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/elasticity/linear_system.h>
#include <signorini/multiplier/coupling.h>
#include <signorini/stiffness_inverse/stiffness_inverse.h>

#include <deal.II/lac/full_matrix.h>

#include <functional>

namespace Signorini
{
/** The body without contact pressure, and what the foundation lacks or leaves. */
struct FreeState
{
  /** U_0 = A^{-1} f, complete. */
  NodalVector U;
  /** F = G - D^T U_0: free opening of each patch (length^dim). Nothing touches if F >= 0. */
  dealii::Vector<double> F;
};

/** F = G - D^T A^{-1} f, one solve. Collective. */
template <int dim>
FreeState solve_free_state(const StiffnessInverse &inverse,
                           const DisplacementSpace<dim> &space,
                           const DistributedVector &f,
                           const Coupling &D,
                           const dealii::Vector<double> &G);

/** The rows of D that are not zero, in ascending order: the contact unknowns of factorise(). */
std::vector<dealii::types::global_dof_index> contact_unknowns(const Coupling &condensed_D);

/** Whether C can be read from the factors without a solve. */
bool holds_compliance(const StiffnessInverse &inverse, const Coupling &condensed_D);

/**
 * The columns C_tau = D^T A^{-1} D_tau for the given tau, one solve each, and the same rows,
 * written into the m x m matrix C on every rank. @p progress is called with the number of finished
 * columns. Collective.
 */
template <int dim>
void compute_compliance_columns(const StiffnessInverse &inverse,
                                const DisplacementSpace<dim> &space,
                                const Coupling &condensed_D,
                                const std::vector<unsigned int> &columns,
                                dealii::FullMatrix<double> &C,
                                const std::function<void(unsigned int)> &progress = {});

/**
 * C = D^T A^{-1} D with the condensed coupling; m x m, symmetric, on every rank.
 *
 * From a CondensedInverse that eliminates the contact unknowns last it is C = D^T S^{-1} D, S =
 * L_22 L_22^T, without a solve; from any other, one solve per column, symmetrised. @p progress is
 * called with the number of finished columns. Collective.
 */
template <int dim>
dealii::FullMatrix<double>
compute_compliance(const StiffnessInverse &inverse,
                   const DisplacementSpace<dim> &space,
                   const Coupling &condensed_D,
                   const std::function<void(unsigned int)> &progress = {});
} // namespace Signorini
