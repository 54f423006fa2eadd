// SPDX-License-Identifier: LGPL-2.1-or-later
// A and f of (22).

#include <signorini/base/errors.h>
#include <signorini/base/instantiate.h>
#include <signorini/discretization/space/body_measure.h>
#include <signorini/discretization/space/cell_stiffness.h>
#include <signorini/discretization/space/cell_values.h>
#include <signorini/discretization/space/internal_forces.h>
#include <signorini/discretization/space/linear_system.h>
#include <signorini/discretization/space/resultant.h>

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/lac/affine_constraints.templates.h>
#include <deal.II/lac/trilinos_sparsity_pattern.h>

#include <Epetra_CrsMatrix.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Signorini {
template <int dim>
TrilinosWrappers::SparseMatrix make_matrix(const DisplacementSpace<dim> &space) {
  const MPI_Comm communicator = space.mesh().communicator();
  const IndexSet &owned = space.locally_owned();
  TrilinosWrappers::SparsityPattern sparsity(owned, owned, communicator);
  DoFTools::make_sparsity_pattern(space.dofs(), sparsity, space.constraints(), false,
                                  Utilities::MPI::this_mpi_process(communicator));
  sparsity.compress();
  TrilinosWrappers::SparseMatrix matrix;
  matrix.reinit(sparsity);
  return matrix;
}

namespace {
/** The entries of a matrix that one rank stores, as deal.II adds to them. Trilinos looks up every
 * entry in its row, which took a third of a run of graded meshes to 1e-6; here one pass over a row
 * finds all columns of a cell. */
class OwnRows : public Subscriptor {
public:
  using size_type = types::global_dof_index;
  using value_type = double;

  explicit OwnRows(const Epetra_CrsMatrix &matrix)
    : size_(matrix.NumMyRows()) {
    const int error = matrix.ExtractCrsDataPointers(start_, column_, value_);
    AssertThrow(error == 0, ExcTrilinosError(error));
  }

  size_type m() const {
    return size_;
  }
  size_type n() const {
    return size_;
  }

  void add(const size_type row, const size_type column, const double value) {
    add(row, 1, &column, &value, false, true);
  }

  /** Adds to increasing columns. */
  void add(const size_type row, const size_type n, const size_type *const columns,
           const double *const values, bool, bool) {
    int entry = start_[row];
    for (size_type j = 0; j < n; ++j, ++entry) {
      while (column_[entry] < static_cast<int>(columns[j]))
        ++entry;
      value_[entry] += values[j];
    }
  }

private:
  size_type size_;
  int *start_, *column_;
  double *value_;
};
} // namespace

template <int dim>
void add_cell(const DisplacementSpace<dim> &space, const FullMatrix<double> &cell_matrix,
              const std::vector<types::global_dof_index> &indices,
              TrilinosWrappers::SparseMatrix &matrix, DualVector &reduction) {
  const auto add_to = [&](auto &rows) {
    space.constraints().distribute_local_to_global(
      cell_matrix, dealii::Vector<double>(indices.size()), indices, rows, reduction);
  };
  if (Utilities::MPI::n_mpi_processes(space.mesh().communicator()) > 1)
    return add_to(matrix);
  OwnRows rows(matrix.trilinos_matrix());
  add_to(rows);
}

namespace {
const UpdateFlags load_flags = update_values | update_quadrature_points | update_JxW_values;

/** The loads of some cells: f_i of each, and the resultants by body. */
template <int dim>
struct ChunkLoads {
  std::vector<std::pair<std::vector<types::global_dof_index>, dealii::Vector<double>>> cells;
  std::vector<Resultant<dim>> resultants;
};

/** Integrates f_i of one cell: body force and tractions. */
template <int dim>
class CellLoads {
public:
  CellLoads(const DisplacementSpace<dim> &space, const Scene<dim> &scene,
            const unsigned int n_points)
    : scene_(scene)
    , cell_values_(space.mesh().mapping(), space, scene.kinks, n_points, load_flags)
    , face_values_(space.mesh().mapping(), space, scene.kinks, n_points, load_flags) {}

  /** Adds the loads of a cell to @p vector and to @p resultant. */
  void add(const typename FaceValues<dim>::CellIterator &cell, dealii::Vector<double> &vector,
           Resultant<dim> &resultant) {
    if (scene_.body_force != nullptr)
      add_force(cell_values_.reinit(cell), *scene_.body_force, "the body force", vector, resultant);
    for (const unsigned int f : cell->face_indices())
      if (cell->face(f)->at_boundary()) {
        const auto side = cell->face(f)->boundary_id();
        if (scene_.boundary[side].role == Role::traction)
          add_force(face_values_.reinit(cell, f, scene_.geometry.sides[side]),
                    *scene_.boundary[side].data, "the traction", vector, resultant);
      }
  }

private:
  /** Adds Σ_q force(x_q).φ_i(x_q) dx_q to vector_i. */
  void add_force(const FEValuesBase<dim> &values, const Function<dim> &force, const char *name,
                 dealii::Vector<double> &vector, Resultant<dim> &resultant) {
    const std::vector<Point<dim>> &points = values.get_quadrature_points();
    force_.resize(points.size(), dealii::Vector<double>(dim));
    force.vector_value_list(points, force_);
    for (const unsigned int q : values.quadrature_point_indices()) {
      Tensor<1, dim> weighted;
      for (unsigned int d = 0; d < dim; ++d) {
        check_finite(force_[q][d], points[q], name);
        weighted[d] = force_[q][d] *= measure_at(values, q);
      }
      resultant.add(weighted, points[q]);
    }
    for (unsigned int i = 0; i < vector.size(); ++i) {
      const unsigned int component = values.get_fe().system_to_component_index(i).first;
      for (const unsigned int q : values.quadrature_point_indices())
        vector[i] += force_[q][component] * values.shape_value(i, q);
    }
  }

  static void check_finite(const double component, const Point<dim> &x, const char *name) {
    if (std::isfinite(component))
      return;
    std::ostringstream message;
    message << name << " has the value " << component << " at (" << x
            << "), allowed: finite values on the whole body.";
    throw InputError(message.str());
  }

  const Scene<dim> &scene_;
  CellValues<dim> cell_values_;
  FaceValues<dim> face_values_;
  /** The force at the quadrature points, then times the weights. */
  std::vector<dealii::Vector<double>> force_;
};

/**
 * Adds f_i of all owned cells; threads integrate them.
 * @return the resultants of this rank by body.
 */
template <int dim>
std::vector<Resultant<dim>> add_loads(const DisplacementSpace<dim> &space, const Scene<dim> &scene,
                                      const unsigned int n_points, DualVector &loads) {
  const unsigned int n_bodies = scene.geometry.n_bodies();
  std::vector<Resultant<dim>> resultants(n_bodies);
  integrate_by_chunks<ChunkLoads<dim>, dim>(
    space,
    [&](const Cells<dim> &cells) {
      CellLoads<dim> cell_loads(space, scene, n_points);
      ChunkLoads<dim> chunk = {{}, std::vector<Resultant<dim>>(n_bodies)};
      for (const auto &cell : cells)
        if (scene.body_force != nullptr || cell->at_boundary()) {
          chunk.cells.emplace_back(space.cell_dofs(cell), cell->get_fe().n_dofs_per_cell());
          cell_loads.add(cell, chunk.cells.back().second,
                         chunk.resultants[scene.geometry.body_of(cell)]);
        }
      return chunk;
    },
    [&](const ChunkLoads<dim> &chunk) {
      for (const auto &[indices, values] : chunk.cells)
        loads.add(indices, values);
      for (unsigned int body = 0; body < n_bodies; ++body)
        resultants[body] += chunk.resultants[body];
    });
  return resultants;
}

/** Adds the matrices of all owned cells, and -a(k, φ_i)/unit with the prescribed displacements k;
 * threads integrate them. */
template <int dim>
void add_stiffness(const DisplacementSpace<dim> &space, const Scene<dim> &scene,
                   TrilinosWrappers::SparseMatrix &matrix, DualVector &reduction) {
  using Matrices = std::vector<
    std::pair<std::vector<types::global_dof_index>, typename CellStiffness<dim>::Matrix>>;
  integrate_by_chunks<Matrices, dim>(
    space,
    [&](const Cells<dim> &cells) {
      CellStiffness<dim> stiffness(space, scene);
      Matrices matrices;
      for (const auto &cell : cells)
        matrices.emplace_back(space.cell_dofs(cell), stiffness.share(cell));
      return matrices;
    },
    [&](const Matrices &matrices) {
      for (const auto &[indices, cell_matrix] : matrices)
        add_cell(space, *cell_matrix, indices, matrix, reduction);
    });
}

/** Returns the system without prescribed displacements, f = Tᵀ loads, and with a matrix to fill. */
template <int dim>
LinearSystem<dim> begin_system(const DisplacementSpace<dim> &space, const Scene<dim> &scene,
                               const unsigned int n_points, TrilinosWrappers::SparseMatrix matrix) {
  const MPI_Comm communicator = space.mesh().communicator();
  LinearSystem<dim> system = {std::move(matrix),
                              stiffness_unit(space, *scene.material),
                              space.make_vector(),
                              space.make_vector(),
                              {}};
  system.applied = add_loads(space, scene, n_points, system.loads);
  system.loads.compress(VectorOperation::add);
  for (Resultant<dim> &resultant : system.applied)
    resultant = sum_over_ranks(resultant, communicator);
  system.f = space.condense(system.loads);
  return system;
}
} // namespace

template <int dim>
LinearSystem<dim> assemble_linear_system(const DisplacementSpace<dim> &space,
                                         const Scene<dim> &scene, const unsigned int n_points) {
  LinearSystem<dim> system = begin_system(space, scene, n_points, make_matrix(space));
  DualVector reduction = space.make_vector();
  add_stiffness(space, scene, system.matrix, reduction);
  system.matrix.compress(VectorOperation::add);
  reduction.compress(VectorOperation::add);
  system.f.add(system.unit, reduction);
  return system;
}

template <int dim>
LinearSystem<dim> assemble_right_hand_side(const DisplacementSpace<dim> &space,
                                           const Scene<dim> &scene, const unsigned int n_points,
                                           const Displacement &k) {
  LinearSystem<dim> system = begin_system(space, scene, n_points, {});
  // f = Tᵀ (loads - A k), U = T U_free + k.
  if (k.linfty_norm() == 0.)
    return system;
  system.f -= space.condense(internal_forces(DisplacedBody(space, scene, k)).forces);
  return system;
}

INSTANTIATE_FUNCTION(make_matrix);
INSTANTIATE_FUNCTION(add_cell);
INSTANTIATE_FUNCTION(assemble_linear_system);
INSTANTIATE_FUNCTION(assemble_right_hand_side);
} // namespace Signorini
