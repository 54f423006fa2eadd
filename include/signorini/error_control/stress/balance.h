// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/error_control/stress/edge_tractions.h>
#include <signorini/error_control/stress/star_solver.h>

#include <vector>

namespace Signorini {
/**
 * Brings cells into exact balance. Around a cell, @p moments balance R_K^i - rest(i) (EdgeMoments),
 * where rest is the residual of the linear solver in the Galerkin rows. The edges that hold the
 * body take the resultant of all rests, with the least forces. Then each cell passes the force and
 * the moment that it lacks through one edge to a neighbour, and so on to the first cell. Only
 * rounding remains.
 *
 * @return whether the body is held; if not, moments are not changed.
 */
bool balance_cells(const EdgeMesh &mesh, const std::vector<Tensor<1, 2>> &rest,
                   std::vector<double> &moments);

/**
 * Returns the change b of moments with the least 1/2 bᵀ S b - rᵀ b among all that disturb the
 * balance of no cell, B b = 0 with the forces and the moment of every cell. b is the limit of
 * conjugate gradients with StarSolver, which need many steps where a body or its cells are long and
 * thin. It is found by the augmented Lagrangian: with multipliers l, zero at first,
 *
 *     (S + ρ Bᵀ B) b = r - Bᵀ l,   l += ρ B b,
 *
 * with one sparse factorisation, until only rounding is left of B b. Rigid motions that edges leave
 * to the body need no care: l only enters as Bᵀ l.
 *
 * Returns nothing if the factorisation fails, or leaves more than rounding.
 */
std::vector<double> optimal_change(const EdgeMesh &mesh, const CellEnergies &energies,
                                   const std::vector<double> &r);
} // namespace Signorini
