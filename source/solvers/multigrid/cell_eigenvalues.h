// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/solvers/multigrid/cell_matrices.h>

namespace Signorini
{
/** Returns a bound of the eigenvalues of B A, with the inverse B of the diagonal blocks of nodes:
 * the largest eigenvalue of all cells. With the diagonal blocks D_K of the matrix A_K of a cell,
 * x.A x = sum x.A_K x ≤ λ sum x.D_K x = λ x.D x, whatever conditions hold. */
template <int dim>
double largest_eigenvalue_of_cells(const CellMatrices<dim, float> &matrices,
                                   const BlockGrid<dim> &grid);
} // namespace Signorini
