// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/error_control/stress/edge_tractions.h>
#include <signorini/error_control/stress/star_solver.h>

#include <vector>

namespace Signorini
{
/**
 * Brings cells into exact balance. Around a cell, @p moments balance R_K^i - rest(i) (EdgeMoments),
 * where rest is the residual of the linear solver in the Galerkin rows. Each cell passes the force
 * and the moment that it lacks through one edge to a neighbour, and so on to an edge that may carry
 * any traction; in a body on rollers, to two rollers with different normals. Then only rounding
 * remains.
 *
 * @return whether such edges exist; if not, moments are not changed.
 */
bool balance_cells(const EdgeMesh &mesh,
                   const std::vector<Tensor<1, 2>> &rest,
                   std::vector<double> &moments);

/**
 * Returns the change b of moments with the least 1/2 bᵀ S b - rᵀ b among all that disturb the
 * balance of no cell: with the force and moment of every cell as constraints B b = 0,
 *
 *     ( S  Bᵀ ) ( b )   ( r )
 *     ( B  0  ) ( l ) = ( 0 ),
 *
 * These are about eleven equations per cell, solved by sparse LU factors. b is the limit of
 * conjugate gradients with StarSolver, which need many steps where a body or its cells are long and
 * thin.
 *
 * Where edges that may carry tractions leave rigid motions to the body, Bᵀ vanishes on them: l is
 * taken without them in the first cell, which changes nothing of b.
 *
 * Returns nothing if the factorisation fails, or leaves more than rounding.
 */
std::vector<double> optimal_change(const EdgeMesh &mesh,
                                   const CellEnergies &energies,
                                   const std::vector<double> &r);
} // namespace Signorini
