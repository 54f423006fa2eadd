// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/discretization/space/linear_system.h>
#include <signorini/solvers/stiffness/stiffness_inverse.h>

#include <memory>
#include <vector>

namespace Signorini {
/**
 * Returns the inverse of A by the factors of a system's matrix. Where cells are condensed, a solve
 * eliminates their inner unknowns before, and finds them afterwards; residuals are those of the
 * matrix, whose factors also make C: so U and C agree. The system and the space must outlive the
 * result. Collective.
 *
 * @param contact_unknowns see factorise() of a matrix.
 * @throws ComputationError if the factorisation fails.
 */
template <int dim>
std::unique_ptr<StiffnessInverse> make_stiffness_inverse(
  const LinearSystem<dim> &system, const DisplacementSpace<dim> &space, LinearSolver solver,
  const std::vector<types::global_dof_index> &contact_unknowns);
} // namespace Signorini
