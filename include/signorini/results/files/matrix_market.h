// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/discretization/multiplier/multiplier_space.h>

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <ostream>
#include <string>
#include <vector>

namespace Signorini
{
/** Writes the lower triangle of a symmetric dense matrix in Matrix Market's array format (columns
 * one after another). */
void write_symmetric_matrix_market(std::ostream &stream, const FullMatrix<double> &matrix);

/** Writes a dense matrix in Matrix Market's array format. */
void write_matrix_market(std::ostream &stream, const FullMatrix<double> &matrix);

/** Writes a vector as an m x 1 matrix. */
void write_matrix_market(std::ostream &stream, const dealii::Vector<double> &vector);

/** Returns the lower triangle of factor × matrix, symmetric and sparse: lines "i j value" for the
 * rows of this rank. */
std::string lower_triangle(const TrilinosWrappers::SparseMatrix &matrix, double factor);

/** Writes a symmetric matrix in coordinate format from the lower_triangle() of every rank. */
void write_symmetric_matrix_market(std::ostream &stream,
                                   types::global_dof_index n,
                                   const std::vector<std::string> &parts);

/** Writes D in coordinate format, @p n_rows x m. */
void write_matrix_market(std::ostream &stream, const Coupling &D, types::global_dof_index n_rows);
} // namespace Signorini
