// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/multiplier/coupling.h>

#include <deal.II/lac/full_matrix.h>

#include <ostream>

namespace Signorini
{
/** Dense matrix in Matrix Market's array format (columns one after another). */
void write_matrix_market(std::ostream &stream, const dealii::FullMatrix<double> &matrix);

/** A vector as an m x 1 matrix. */
void write_matrix_market(std::ostream &stream, const dealii::Vector<double> &vector);

/** D in coordinate format, @p n_rows x m. */
void write_matrix_market(std::ostream &stream,
                         const Coupling &D,
                         dealii::types::global_dof_index n_rows);
} // namespace Signorini
