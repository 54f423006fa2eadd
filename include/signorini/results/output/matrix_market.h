// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/discretization/space/multiplier_space.h>

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <ostream>
#include <string>
#include <vector>

namespace Signorini {
/** Writes a dense matrix, or the lower triangle of a symmetric one, in Matrix Market's array format
 * (columns one after another). */
void write_matrix_market(std::ostream &stream, const FullMatrix<double> &matrix,
                         bool symmetric = false);

/** Returns the lower triangle of factor × matrix, symmetric and sparse: lines "i j value". */
std::string lower_triangle(const TrilinosWrappers::SparseMatrix &matrix, double factor);

/** Returns the entries of D in the same way. */
std::string entries_of(const Coupling &D);

/** Writes a matrix in coordinate format from its entries, or the lower triangle of a @p symmetric
 * one. @param entries lines "i j value". */
void write_matrix_market(std::ostream &stream, types::global_dof_index n_rows,
                         types::global_dof_index n_columns, const std::string &entries,
                         bool symmetric = false);
} // namespace Signorini
