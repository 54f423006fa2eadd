// SPDX-License-Identifier: LGPL-2.1-or-later
// Cell matrices into A.

#include <signorini/elasticity/matrix_scatter.h>

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/lac/trilinos_sparsity_pattern.h>

#include <Epetra_CrsMatrix.h>

#include <algorithm>

namespace Signorini
{
template <int dim>
dealii::TrilinosWrappers::SparseMatrix make_matrix(const DisplacementSpace<dim> &space)
{
  const MPI_Comm communicator = space.mesh().communicator();
  const dealii::IndexSet &owned = space.locally_owned();
  dealii::TrilinosWrappers::SparsityPattern sparsity(owned, owned, communicator);
  dealii::DoFTools::make_sparsity_pattern(space.dofs(),
                                          sparsity,
                                          space.constraints(),
                                          false,
                                          dealii::Utilities::MPI::this_mpi_process(communicator));
  sparsity.compress();
  dealii::TrilinosWrappers::SparseMatrix matrix;
  matrix.reinit(sparsity);
  return matrix;
}

template <int dim>
MatrixScatter<dim>::MatrixScatter(const DisplacementSpace<dim> &space,
                                  dealii::TrilinosWrappers::SparseMatrix &matrix)
  : constraints_(space.constraints())
  , matrix_(matrix)
  , one_rank_(dealii::Utilities::MPI::n_mpi_processes(space.mesh().communicator()) == 1)
{
  const int error = matrix.trilinos_matrix().ExtractCrsDataPointers(start_, column_, value_);
  AssertThrow(error == 0, dealii::ExcTrilinosError(error));
}

template <int dim>
bool MatrixScatter<dim>::is_plain(const Indices &indices) const
{
  return one_rank_ && std::none_of(indices.begin(), indices.end(), [&](const auto i) {
           return constraints_.is_constrained(i);
         });
}

template <int dim>
void MatrixScatter<dim>::add_to_rows(const dealii::FullMatrix<double> &cell_matrix,
                                     const Indices &indices)
{
  const unsigned int n = indices.size();
  for (unsigned int i = 0; i < n; ++i)
  {
    const int *const begin = column_ + start_[indices[i]];
    const int *const end = column_ + start_[indices[i] + 1];
    const int *entry = begin;
    for (unsigned int j = 0; j < n; ++j)
    {
      const int column = static_cast<int>(indices[j]);
      // The unknowns of a node follow each other, also in the rows.
      if (j > 0 && indices[j] == indices[j - 1] + 1)
        ++entry;
      else
        entry = std::lower_bound(begin, end, column);
      Assert(entry != end && *entry == column, dealii::ExcInternalError());
      value_[entry - column_] += cell_matrix(i, j);
    }
  }
}

template <int dim>
void MatrixScatter<dim>::add(const dealii::FullMatrix<double> &cell_matrix, const Indices &indices)
{
  if (is_plain(indices))
    add_to_rows(cell_matrix, indices);
  else
    constraints_.distribute_local_to_global(cell_matrix, indices, matrix_);
}

template <int dim>
void MatrixScatter<dim>::add(const dealii::FullMatrix<double> &cell_matrix,
                             const dealii::Vector<double> &cell_vector,
                             const Indices &indices,
                             DistributedVector &vector)
{
  if (is_plain(indices))
  {
    add_to_rows(cell_matrix, indices);
    vector.add(indices, cell_vector);
  }
  else
    constraints_.distribute_local_to_global(cell_matrix, cell_vector, indices, matrix_, vector);
}

template dealii::TrilinosWrappers::SparseMatrix make_matrix(const DisplacementSpace<2> &);
template dealii::TrilinosWrappers::SparseMatrix make_matrix(const DisplacementSpace<3> &);
template class MatrixScatter<2>;
template class MatrixScatter<3>;
} // namespace Signorini
