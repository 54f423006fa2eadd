// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/elasticity/displacement_space.h>

#include <deal.II/lac/trilinos_sparse_matrix.h>

namespace Signorini
{
/** A matrix of V^h with the couplings of A, rows distributed, entries zero. Collective. */
template <int dim>
dealii::TrilinosWrappers::SparseMatrix make_matrix(const DisplacementSpace<dim> &space);

/**
 * Adds matrices of cells to a matrix of V^h that make_matrix() made, condensing the constraints.
 *
 * On one rank, entries are added to the stored rows directly, which is several times faster than
 * Trilinos' own search.
 */
template <int dim>
class MatrixScatter
{
public:
  using Indices = std::vector<dealii::types::global_dof_index>;

  /** Both must outlive the object. */
  MatrixScatter(const DisplacementSpace<dim> &space,
                dealii::TrilinosWrappers::SparseMatrix &matrix);

  /** matrix(indices, indices) += cell_matrix. */
  void add(const dealii::FullMatrix<double> &cell_matrix, const Indices &indices);
  /** The same, with vector(indices) += cell_vector, reduced by prescribed displacements. */
  void add(const dealii::FullMatrix<double> &cell_matrix,
           const dealii::Vector<double> &cell_vector,
           const Indices &indices,
           DistributedVector &vector);

private:
  bool has_constraints(const Indices &indices) const;
  void add_to_rows(const dealii::FullMatrix<double> &cell_matrix, const Indices &indices);
  /**
   * T^T K T and T^T (b - K k) of a cell with constraints, U = T U_free + k, in condensed_ and
   * condensed_vector_, for the indices in masters_.
   */
  void condense(const dealii::FullMatrix<double> &cell_matrix,
                const dealii::Vector<double> &cell_vector,
                const Indices &indices);
  /** condense(), with the matrix added to the rows. */
  void add_condensed(const dealii::FullMatrix<double> &cell_matrix,
                     const dealii::Vector<double> &cell_vector,
                     const Indices &indices);
  /** A positive number on the diagonal of a constrained row. */
  void add_diagonals(const dealii::FullMatrix<double> &cell_matrix, const Indices &indices);

  const dealii::AffineConstraints<double> &constraints_;
  dealii::TrilinosWrappers::SparseMatrix &matrix_;
  bool one_rank_;
  /** The rows as Trilinos stores them: row i has the entries start[i] to start[i + 1]. */
  int *start_ = nullptr;
  int *column_ = nullptr;
  double *value_ = nullptr;
  dealii::FullMatrix<double> half_condensed_, condensed_;
  dealii::Vector<double> condensed_vector_;
  Indices masters_;
};
} // namespace Signorini
