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
bool MatrixScatter<dim>::has_constraints(const Indices &indices) const
{
  return std::any_of(
    indices.begin(), indices.end(), [&](const auto i) { return constraints_.is_constrained(i); });
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
void MatrixScatter<dim>::condense(const dealii::FullMatrix<double> &cell_matrix,
                                  const dealii::Vector<double> &cell_vector,
                                  const Indices &indices)
{
  const unsigned int n = indices.size();
  // The degrees of freedom that each one follows: number in masters_ and weight.
  std::vector<std::vector<std::pair<unsigned int, double>>> followed(n);
  masters_.clear();
  const auto number_of = [&](const dealii::types::global_dof_index index) {
    const auto found = std::find(masters_.begin(), masters_.end(), index);
    const auto number = static_cast<unsigned int>(found - masters_.begin());
    if (found == masters_.end())
      masters_.push_back(index);
    return number;
  };
  for (unsigned int i = 0; i < n; ++i)
    if (!constraints_.is_constrained(indices[i]))
    {
      followed[i].emplace_back(masters_.size(), 1.);
      masters_.push_back(indices[i]);
    }
  for (unsigned int i = 0; i < n; ++i)
    if (const auto *const line = constraints_.get_constraint_entries(indices[i]))
      for (const auto &[index, weight] : *line)
        followed[i].emplace_back(number_of(index), weight);

  const auto m = static_cast<unsigned int>(masters_.size());
  half_condensed_.reinit(m, n);
  condensed_vector_.reinit(m);
  condensed_.reinit(m, m);
  dealii::Vector<double> b(cell_vector);
  for (unsigned int j = 0; j < n; ++j)
    if (constraints_.is_inhomogeneously_constrained(indices[j]))
      for (unsigned int i = 0; i < n; ++i)
        b[i] -= cell_matrix(i, j) * constraints_.get_inhomogeneity(indices[j]);
  for (unsigned int i = 0; i < n; ++i)
    for (const auto &[master, weight] : followed[i])
    {
      condensed_vector_[master] += weight * b[i];
      for (unsigned int j = 0; j < n; ++j)
        half_condensed_(master, j) += weight * cell_matrix(i, j);
    }
  for (unsigned int i = 0; i < m; ++i)
    for (unsigned int j = 0; j < n; ++j)
      for (const auto &[master, weight] : followed[j])
        condensed_(i, master) += weight * half_condensed_(i, j);
}

template <int dim>
void MatrixScatter<dim>::add_diagonals(const dealii::FullMatrix<double> &cell_matrix,
                                       const Indices &indices)
{
  for (unsigned int i = 0; i < indices.size(); ++i)
    if (constraints_.is_constrained(indices[i]))
    {
      const int *const begin = column_ + start_[indices[i]];
      const int *const end = column_ + start_[indices[i] + 1];
      const int *const entry = std::lower_bound(begin, end, static_cast<int>(indices[i]));
      value_[entry - column_] += std::abs(cell_matrix(i, i));
    }
}

template <int dim>
void MatrixScatter<dim>::add_condensed(const dealii::FullMatrix<double> &cell_matrix,
                                       const dealii::Vector<double> &cell_vector,
                                       const Indices &indices)
{
  condense(cell_matrix, cell_vector, indices);
  add_to_rows(condensed_, masters_);
  add_diagonals(cell_matrix, indices);
}

template <int dim>
void MatrixScatter<dim>::add(const dealii::FullMatrix<double> &cell_matrix, const Indices &indices)
{
  if (!one_rank_)
    constraints_.distribute_local_to_global(cell_matrix, indices, matrix_);
  else if (!has_constraints(indices))
    add_to_rows(cell_matrix, indices);
  else
    add_condensed(cell_matrix, dealii::Vector<double>(indices.size()), indices);
}

template <int dim>
void MatrixScatter<dim>::add(const dealii::FullMatrix<double> &cell_matrix,
                             const dealii::Vector<double> &cell_vector,
                             const Indices &indices,
                             DistributedVector &vector)
{
  if (!one_rank_)
    constraints_.distribute_local_to_global(cell_matrix, cell_vector, indices, matrix_, vector);
  else if (!has_constraints(indices))
  {
    add_to_rows(cell_matrix, indices);
    vector.add(indices, cell_vector);
  }
  else
  {
    add_condensed(cell_matrix, cell_vector, indices);
    vector.add(masters_, condensed_vector_);
  }
}

template dealii::TrilinosWrappers::SparseMatrix make_matrix(const DisplacementSpace<2> &);
template dealii::TrilinosWrappers::SparseMatrix make_matrix(const DisplacementSpace<3> &);
template class MatrixScatter<2>;
template class MatrixScatter<3>;
} // namespace Signorini
