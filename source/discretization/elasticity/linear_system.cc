// SPDX-License-Identifier: LGPL-2.1-or-later
// The assembly of cell matrices into A.

#include <signorini/base/errors.h>
#include <signorini/discretization/elasticity/cell_stiffness.h>
#include <signorini/discretization/elasticity/integration.h>
#include <signorini/discretization/elasticity/linear_system.h>

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/lac/trilinos_sparsity_pattern.h>

#include <Epetra_CrsMatrix.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Signorini
{
template <int dim>
TrilinosWrappers::SparseMatrix make_matrix(const DisplacementSpace<dim> &space)
{
  const MPI_Comm communicator = space.mesh().communicator();
  const IndexSet &owned = space.locally_owned();
  TrilinosWrappers::SparsityPattern sparsity(owned, owned, communicator);
  DoFTools::make_sparsity_pattern(space.dofs(),
                                  sparsity,
                                  space.constraints(),
                                  false,
                                  Utilities::MPI::this_mpi_process(communicator));
  sparsity.compress();
  TrilinosWrappers::SparseMatrix matrix;
  matrix.reinit(sparsity);
  return matrix;
}

template <int dim>
MatrixScatter<dim>::MatrixScatter(const DisplacementSpace<dim> &space,
                                  TrilinosWrappers::SparseMatrix &matrix)
  : constraints_(space.constraints())
  , matrix_(matrix)
  , one_rank_(Utilities::MPI::n_mpi_processes(space.mesh().communicator()) == 1)
{
  const int error = matrix.trilinos_matrix().ExtractCrsDataPointers(start_, column_, value_);
  AssertThrow(error == 0, ExcTrilinosError(error));
}

template <int dim>
bool MatrixScatter<dim>::has_constraints(const Indices &indices) const
{
  return std::any_of(
    indices.begin(), indices.end(), [&](const auto i) { return constraints_.is_constrained(i); });
}

template <int dim>
void MatrixScatter<dim>::add_to_rows(const FullMatrix<double> &cell_matrix, const Indices &indices)
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
      Assert(entry != end && *entry == column, ExcInternalError());
      value_[entry - column_] += cell_matrix(i, j);
    }
  }
}

template <int dim>
void MatrixScatter<dim>::condense(const FullMatrix<double> &cell_matrix,
                                  const dealii::Vector<double> &cell_vector,
                                  const Indices &indices)
{
  const unsigned int n = indices.size();
  // followed[i] are the masters of each degree of freedom: number in masters_ and weight.
  std::vector<std::vector<std::pair<unsigned int, double>>> followed(n);
  masters_.clear();
  const auto index_in_masters = [&](const types::global_dof_index index) {
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
        followed[i].emplace_back(index_in_masters(index), weight);

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
void MatrixScatter<dim>::add_diagonals(const FullMatrix<double> &cell_matrix,
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
void MatrixScatter<dim>::add_condensed(const FullMatrix<double> &cell_matrix,
                                       const dealii::Vector<double> &cell_vector,
                                       const Indices &indices)
{
  condense(cell_matrix, cell_vector, indices);
  add_to_rows(condensed_, masters_);
  add_diagonals(cell_matrix, indices);
}

template <int dim>
void MatrixScatter<dim>::add(const FullMatrix<double> &cell_matrix, const Indices &indices)
{
  if (!one_rank_)
    constraints_.distribute_local_to_global(cell_matrix, indices, matrix_);
  else if (!has_constraints(indices))
    add_to_rows(cell_matrix, indices);
  else
    add_condensed(cell_matrix, dealii::Vector<double>(indices.size()), indices);
}

template <int dim>
void MatrixScatter<dim>::add(const FullMatrix<double> &cell_matrix,
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

template TrilinosWrappers::SparseMatrix make_matrix(const DisplacementSpace<2> &);
template TrilinosWrappers::SparseMatrix make_matrix(const DisplacementSpace<3> &);
template class MatrixScatter<2>;
template class MatrixScatter<3>;

// A and f of (22): one pass over the cells, in chunks that threads share.

namespace
{
/** Integrates f_i of one cell: body force and tractions. */
template <int dim>
class CellLoads
{
public:
  CellLoads(const DisplacementSpace<dim> &space,
            const Scene<dim> &scene,
            const unsigned int n_points)
    : scene_(scene)
    , cell_values_(space.mesh().mapping(), space, scene.kinks, n_points, flags())
    , face_values_(space.mesh().mapping(), space, scene.kinks, n_points, flags())
  {
  }

  /** Adds the loads of a cell to @p vector and to @p resultant. */
  void add(const typename FaceValues<dim>::CellIterator &cell,
           dealii::Vector<double> &vector,
           Resultant<dim> &resultant)
  {
    if (scene_.body_force != nullptr)
      add_force(cell_values_.reinit(cell), *scene_.body_force, "the body force", vector, resultant);
    if (!cell->at_boundary())
      return;
    for (const unsigned int f : cell->face_indices())
    {
      if (!cell->face(f)->at_boundary())
        continue;
      const BoundaryCondition<dim> &condition = scene_.boundary[cell->face(f)->boundary_id()];
      if (condition.role != Role::traction)
        continue;
      add_force(face_values_.reinit(cell, f), *condition.data, "the traction", vector, resultant);
    }
  }

private:
  static UpdateFlags flags()
  {
    return update_values | update_quadrature_points | update_JxW_values;
  }

  /** Adds Σ_q force(x_q).φ_i(x_q) JxW_q to vector_i. */
  void add_force(const FEValuesBase<dim> &values,
                 const Function<dim> &force,
                 const char *name,
                 dealii::Vector<double> &vector,
                 Resultant<dim> &resultant)
  {
    const auto &element = values.get_fe();
    const std::vector<Point<dim>> &points = values.get_quadrature_points();
    if (force_.size() != points.size())
      force_.assign(points.size(), dealii::Vector<double>(dim));
    force.vector_value_list(points, force_);
    for (const unsigned int q : values.quadrature_point_indices())
    {
      check_finite(force_[q], points[q], name);
      Tensor<1, dim> weighted;
      for (unsigned int d = 0; d < dim; ++d)
        weighted[d] = force_[q][d] * values.JxW(q);
      resultant.add(weighted, points[q]);
      for (unsigned int i = 0; i < vector.size(); ++i)
        vector[i] +=
          weighted[element.system_to_component_index(i).first] * values.shape_value(i, q);
    }
  }

  static void check_finite(const dealii::Vector<double> &value,
                           const Point<dim> &x,
                           const char *name)
  {
    for (const double component : value)
      if (!std::isfinite(component))
      {
        std::ostringstream message;
        message << name << " has the value " << component << " at (" << x
                << "), allowed: finite values on the whole body.";
        throw InputError(message.str());
      }
  }

  const Scene<dim> &scene_;
  CellValues<dim> cell_values_;
  FaceValues<dim> face_values_;
  /** The force at the quadrature points. */
  std::vector<dealii::Vector<double>> force_;
};

/** The integrals a(φ_j, φ_i) and f_i on the cells of a chunk. */
template <int dim>
struct ChunkIntegrals
{
  const Cells<dim> *cells;
  std::vector<typename CellStiffness<dim>::Matrix> stiffness;
  std::vector<dealii::Vector<double>> loads;
  Resultant<dim> resultant;
};

template <int dim>
ChunkIntegrals<dim> integrate(const Cells<dim> &cells,
                              const DisplacementSpace<dim> &space,
                              const Scene<dim> &scene,
                              const unsigned int n_points)
{
  CellStiffness<dim> cell_stiffness(space, scene);
  CellLoads<dim> cell_loads(space, scene, n_points);
  ChunkIntegrals<dim> integrals;
  integrals.cells = &cells;
  integrals.stiffness.reserve(cells.size());
  integrals.loads.reserve(cells.size());
  for (std::size_t k = 0; k < cells.size(); ++k)
  {
    integrals.stiffness.push_back(cell_stiffness.share(cells[k]));
    integrals.loads.emplace_back(integrals.stiffness[k]->m());
    cell_loads.add(cells[k], integrals.loads[k], integrals.resultant);
  }
  return integrals;
}

/** Adds all owned cells to A, f and loads; the resultant is that of this rank. */
template <int dim>
void add_cells(const DisplacementSpace<dim> &space,
               const Scene<dim> &scene,
               const unsigned int n_points,
               LinearSystem<dim> &system)
{
  MatrixScatter<dim> scatter(space, system.matrix);
  std::vector<types::global_dof_index> indices;
  dealii::Vector<double> in_matrix_units;
  integrate_by_chunks<ChunkIntegrals<dim>, dim>(
    space,
    [&](const Cells<dim> &cells) { return integrate(cells, space, scene, n_points); },
    [&](const ChunkIntegrals<dim> &integrals) {
      for (std::size_t k = 0; k < integrals.cells->size(); ++k)
      {
        indices.resize(integrals.loads[k].size());
        (*integrals.cells)[k]->get_dof_indices(indices);
        system.loads.add(indices, integrals.loads[k]);
        in_matrix_units = integrals.loads[k];
        in_matrix_units /= system.unit;
        scatter.add(*integrals.stiffness[k], in_matrix_units, indices, system.f);
      }
      system.applied += integrals.resultant;
    });
}

/**
 * Adds f_i of all owned cells.
 * @return the resultant of this rank.
 */
template <int dim>
Resultant<dim> add_loads(const DisplacementSpace<dim> &space,
                         const Scene<dim> &scene,
                         const unsigned int n_points,
                         DistributedVector &loads)
{
  CellLoads<dim> cell_loads(space, scene, n_points);
  Resultant<dim> resultant;
  dealii::Vector<double> cell_data;
  std::vector<types::global_dof_index> indices;
  for (const auto &cell : space.dofs().active_cell_iterators())
    if (cell->is_locally_owned() && (scene.body_force != nullptr || cell->at_boundary()))
    {
      indices.resize(cell->get_fe().n_dofs_per_cell());
      cell->get_dof_indices(indices);
      cell_data.reinit(indices.size());
      cell_loads.add(cell, cell_data, resultant);
      loads.add(indices, cell_data);
    }
  return resultant;
}

/** Subtracts a(k, φ_i)/unit, where k are the prescribed values. Only cells on sides contribute.
 */
template <int dim>
void subtract_prescribed(const DisplacementSpace<dim> &space,
                         const Scene<dim> &scene,
                         DualVector &functional)
{
  const Displacement k = space.prescribed(scene);
  if (k.linfty_norm() == 0.)
    return;
  CellStiffness<dim> stiffness(space, scene);
  dealii::Vector<double> cell_data, forces;
  std::vector<types::global_dof_index> indices;
  for (const auto &cell : space.dofs().active_cell_iterators())
  {
    if (!cell->is_locally_owned())
      continue;
    const unsigned int n = cell->get_fe().n_dofs_per_cell();
    cell_data.reinit(n);
    cell->get_dof_values(k, cell_data);
    if (cell_data.linfty_norm() == 0.)
      continue;
    indices.resize(n);
    cell->get_dof_indices(indices);
    forces.reinit(n);
    stiffness(cell).vmult(forces, cell_data);
    forces *= -1.;
    functional.add(indices, forces);
  }
  functional.compress(VectorOperation::add);
}
} // namespace

template <int dim>
LinearSystem<dim> assemble_linear_system(const DisplacementSpace<dim> &space,
                                         const Scene<dim> &scene,
                                         const unsigned int n_points)
{
  const MPI_Comm communicator = space.mesh().communicator();
  LinearSystem<dim> system = {make_matrix(space),
                              stiffness_unit(space, *scene.material),
                              space.make_vector(),
                              space.make_vector(),
                              {}};
  agree(communicator, [&]() { add_cells(space, scene, n_points, system); });
  system.matrix.compress(VectorOperation::add);
  system.f.compress(VectorOperation::add);
  // Prescribed displacements were eliminated in units of the matrix.
  system.f *= system.unit;
  system.loads.compress(VectorOperation::add);
  system.applied = sum_over_ranks(system.applied, communicator);
  return system;
}

template <int dim>
LinearSystem<dim> assemble_right_hand_side(const DisplacementSpace<dim> &space,
                                           const Scene<dim> &scene,
                                           const unsigned int n_points)
{
  LinearSystem<dim> system = {
    {}, stiffness_unit(space, *scene.material), space.make_vector(), space.make_vector(), {}};
  system.applied = add_loads(space, scene, n_points, system.loads);
  system.loads.compress(VectorOperation::add);
  DualVector functional = space.dual(system.loads);
  functional /= system.unit;
  subtract_prescribed(space, scene, functional);
  functional *= system.unit;
  const DualVector condensed = space.condense(functional);
  for (const auto i : space.locally_owned())
    system.f(i) = condensed(i);
  system.f.compress(VectorOperation::insert);
  return system;
}

template <int dim>
DistributedVector assemble_loads(const DisplacementSpace<dim> &space,
                                 const Scene<dim> &scene,
                                 const unsigned int n_points)
{
  DistributedVector loads = space.make_vector();
  agree(space.mesh().communicator(), [&]() { add_loads(space, scene, n_points, loads); });
  loads.compress(VectorOperation::add);
  return loads;
}

template DistributedVector assemble_loads(const DisplacementSpace<2> &,
                                          const Scene<2> &,
                                          unsigned int);
template DistributedVector assemble_loads(const DisplacementSpace<3> &,
                                          const Scene<3> &,
                                          unsigned int);
template LinearSystem<2> assemble_right_hand_side(const DisplacementSpace<2> &,
                                                  const Scene<2> &,
                                                  unsigned int);
template LinearSystem<3> assemble_right_hand_side(const DisplacementSpace<3> &,
                                                  const Scene<3> &,
                                                  unsigned int);
template LinearSystem<2> assemble_linear_system(const DisplacementSpace<2> &,
                                                const Scene<2> &,
                                                unsigned int);
template LinearSystem<3> assemble_linear_system(const DisplacementSpace<3> &,
                                                const Scene<3> &,
                                                unsigned int);
} // namespace Signorini
