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

#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/trilinos_sparsity_pattern.h>

#include <Epetra_CrsGraph.h>
#include <Epetra_CrsMatrix.h>
#include <Epetra_Map.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

namespace Signorini {
namespace {
/** Returns the number of unknowns inside a cell. */
template <int dim>
unsigned int n_inner(const FiniteElement<dim> &element) {
  return element.template n_dofs_per_object<dim>();
}

/** Adds the couplings of unknowns in the cells of this rank. */
template <int dim, typename Pattern>
void add_couplings(const DisplacementSpace<dim> &space, const bool condensed, Pattern &pattern) {
  std::vector<types::global_dof_index> indices;
  for (const auto &cell : space.dofs().active_cell_iterators())
    if (cell->is_locally_owned()) {
      indices.resize(cell->get_fe().n_dofs_per_cell());
      cell->get_dof_indices(indices);
      // Inner unknowns are the last of a cell.
      for (unsigned int i = condensed ? n_inner(cell->get_fe()) : 0; i > 0; --i) {
        pattern.add(indices.back(), indices.back());
        indices.pop_back();
      }
      space.constraints().add_entries_local_to_global(indices, pattern, false);
    }
}

/** A graph that can be told that its rows are sorted. */
struct SortedGraph : Epetra_CrsGraph {
  using Epetra_CrsGraph::Epetra_CrsGraph;
  using Epetra_CrsGraph::SetSorted;
};

/** Returns the pattern of a matrix on one rank. Trilinos would look up every entry in its row, and
 * every column in a map: a tenth of a run of graded meshes. */
template <int dim>
Epetra_CrsGraph graph_on_one_rank(const DisplacementSpace<dim> &space, const bool condensed) {
  const int n = static_cast<int>(space.dofs().n_dofs());
  DynamicSparsityPattern pattern(n);
  add_couplings(space, condensed, pattern);
  const Epetra_Map map = space.locally_owned().make_trilinos_map(space.mesh().communicator());
  std::vector<int> lengths(n), columns;
  for (int row = 0; row < n; ++row)
    lengths[row] = static_cast<int>(pattern.row_length(row));
  SortedGraph graph(Copy, map, map, lengths.data(), true);
  for (int row = 0; row < n; ++row) {
    columns.clear();
    for (int i = 0; i < lengths[row]; ++i)
      columns.push_back(static_cast<int>(pattern.column_number(row, i)));
    graph.InsertMyIndices(row, lengths[row], columns.data());
  }
  graph.SetSorted(true);
  const int error = graph.FillComplete();
  AssertThrow(error == 0, ExcTrilinosError(error));
  return graph;
}
} // namespace

template <int dim>
TrilinosWrappers::SparseMatrix make_matrix(const DisplacementSpace<dim> &space,
                                           const bool condensed) {
  const MPI_Comm communicator = space.mesh().communicator();
  TrilinosWrappers::SparseMatrix matrix;
  if (Utilities::MPI::n_mpi_processes(communicator) == 1) {
    matrix.reinit(Epetra_CrsMatrix(View, graph_on_one_rank(space, condensed)), false);
    return matrix;
  }
  const IndexSet &owned = space.locally_owned();
  TrilinosWrappers::SparsityPattern pattern(owned, owned, communicator);
  add_couplings(space, condensed, pattern);
  pattern.compress();
  matrix.reinit(pattern);
  return matrix;
}

namespace {
const UpdateFlags load_flags = update_values | update_quadrature_points | update_JxW_values;

/** The loads of some cells: f_i of one after the other, and the resultants by body. */
template <int dim>
struct ChunkLoads {
  std::vector<types::global_dof_index> indices;
  std::vector<double> values;
  std::vector<Resultant<dim>> resultants;
};

/** Rules on cells or faces, at whose points a force is evaluated together: for few points, formulas
 * take twice as long. */
template <int dim>
class LoadBatch {
public:
  /** Adds a rule. The object may move to other cells, where shape functions have the same values.
   * @param first the number of the first load of the cell. @return whether the batch is full. */
  bool add(const FEValuesBase<dim> &values, const std::size_t first, const unsigned int body) {
    rules_.push_back({&values, first, body});
    for (const unsigned int q : values.quadrature_point_indices()) {
      points_.push_back(values.quadrature_point(q));
      weights_.push_back(measure_at(values, q));
    }
    return points_.size() >= 200;
  }
  /** Adds Σ_q force(x_q).φ_i(x_q) dx_q of all rules to the loads, and forgets the rules. */
  void evaluate(const Function<dim> &force, const char *name, ChunkLoads<dim> &loads) {
    forces_.resize(points_.size(), dealii::Vector<double>(dim));
    force.vector_value_list(points_, forces_);
    std::size_t p = 0;
    for (const auto &[values, first, body] : rules_) {
      weighted_.clear();
      while (weighted_.size() < values->n_quadrature_points) {
        Tensor<1, dim> &weighted = weighted_.emplace_back();
        for (unsigned int d = 0; d < dim; ++d) {
          check_finite(forces_[p][d], points_[p], name);
          weighted[d] = forces_[p][d] * weights_[p];
        }
        loads.resultants[body].add(weighted, points_[p++]);
      }
      const FiniteElement<dim> &element = values->get_fe();
      for (unsigned int i = 0; i < element.n_dofs_per_cell(); ++i) {
        const unsigned int component = element.system_to_component_index(i).first;
        // deal.II stores the values of a function at all points one behind the other.
        const double *value = &values->shape_value(i, 0);
        double sum = 0.;
        for (const Tensor<1, dim> &weighted : weighted_)
          sum += *value++ * weighted[component];
        loads.values[first + i] += sum;
      }
    }
    rules_.clear();
    points_.clear();
    weights_.clear();
  }

private:
  static void check_finite(const double component, const Point<dim> &x, const char *name) {
    if (std::isfinite(component))
      return;
    std::ostringstream message;
    message << name << " has the value " << component << " at (" << x
            << "), allowed: finite values on the whole body.";
    throw InputError(message.str());
  }

  struct Rule {
    const FEValuesBase<dim> *values;
    std::size_t first;
    unsigned int body;
  };
  std::vector<Rule> rules_;
  std::vector<Point<dim>> points_;
  std::vector<double> weights_;
  std::vector<dealii::Vector<double>> forces_;
  /** The forces of a rule, times the weights. */
  std::vector<Tensor<1, dim>> weighted_;
};

/** Integrates f_i of cells: body force and tractions. */
template <int dim>
ChunkLoads<dim> integrate_loads(const DisplacementSpace<dim> &space, const Scene<dim> &scene,
                                const unsigned int n_points, const Cells<dim> &cells) {
  CellValues<dim> cell_values(space.mesh().mapping(), space, scene.kinks, n_points, load_flags);
  FaceValues<dim> face_values(space.mesh().mapping(), space, scene.kinks, n_points, load_flags);
  ChunkLoads<dim> loads = {{}, {}, std::vector<Resultant<dim>>(scene.geometry.n_bodies())};
  LoadBatch<dim> body_force, traction;
  std::vector<types::global_dof_index> indices;
  for (const auto &cell : cells)
    if (scene.body_force != nullptr || cell->at_boundary()) {
      const std::size_t first = loads.indices.size();
      const unsigned int body = scene.geometry.body_of(cell);
      indices.resize(cell->get_fe().n_dofs_per_cell());
      cell->get_dof_indices(indices);
      loads.indices.insert(loads.indices.end(), indices.begin(), indices.end());
      loads.values.resize(loads.indices.size());
      if (scene.body_force != nullptr && (body_force.add(cell_values.reinit(cell), first, body) ||
                                          cell_values.is_cut() || cell == cells.back()))
        body_force.evaluate(*scene.body_force, "the body force", loads);
      for (const unsigned int f : cell->face_indices())
        if (cell->face(f)->at_boundary()) {
          const auto side = cell->face(f)->boundary_id();
          if (scene.boundary[side].role == Role::traction) {
            traction.add(face_values.reinit(cell, f, scene.geometry.sides[side]), first, body);
            traction.evaluate(*scene.boundary[side].data, "the traction", loads);
          }
        }
    }
  return loads;
}

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
    space, [&](const Cells<dim> &cells) { return integrate_loads(space, scene, n_points, cells); },
    [&](const ChunkLoads<dim> &chunk) {
      loads.add(chunk.indices.size(), chunk.indices.data(), chunk.values.data());
      for (unsigned int body = 0; body < n_bodies; ++body)
        resultants[body] += chunk.resultants[body];
    });
  return resultants;
}

/** Adds the matrices of all owned cells; threads integrate and condense them. */
template <int dim>
void add_stiffness(const DisplacementSpace<dim> &space, const Scene<dim> &scene,
                   const bool condensed, LinearSystem<dim> &system) {
  using Matrix = typename CellStiffness<dim>::Matrix;
  using Matrices = std::vector<std::pair<CondensedCell<dim>, Matrix>>;
  integrate_by_chunks<Matrices, dim>(
    space,
    [&](const Cells<dim> &cells) {
      CellStiffness<dim> stiffness(space, scene);
      std::map<Matrix, std::shared_ptr<const CondensedMatrix>> known;
      Matrices matrices;
      for (const auto &cell : cells) {
        const Matrix K = stiffness.share(cell);
        auto &matrix = known[K];
        if (condensed && matrix == nullptr)
          matrix = std::make_shared<const CondensedMatrix>(*K, n_inner(cell->get_fe()));
        matrices.push_back({{space.cell_dofs(cell), matrix}, K});
      }
      return matrices;
    },
    [&](const Matrices &matrices) {
      for (const auto &[cell, K] : matrices) {
        const FullMatrix<double> &S = condensed ? cell.matrix->S : *K;
        space.constraints().distribute_local_to_global(
          S, {cell.dofs.begin(), cell.dofs.begin() + S.m()}, system.matrix);
        for (unsigned int i = S.m(); i < K->m(); ++i)
          system.matrix.add(cell.dofs[i], cell.dofs[i], (*K)(i, i));
        if (condensed)
          system.cells.push_back(cell);
      }
    });
}

/** Returns the system with the prescribed displacements k, and with a matrix to fill. */
template <int dim>
LinearSystem<dim> begin_system(const DisplacementSpace<dim> &space, const Scene<dim> &scene,
                               const unsigned int n_points, const Displacement &k,
                               TrilinosWrappers::SparseMatrix matrix) {
  LinearSystem<dim> system = {
    std::move(matrix),   {}, stiffness_unit(space, *scene.material), space.make_vector(),
    space.make_vector(), {}};
  system.applied = add_loads(space, scene, n_points, system.loads);
  system.loads.compress(VectorOperation::add);
  for (Resultant<dim> &resultant : system.applied)
    resultant = sum_over_ranks(resultant, space.mesh().communicator());
  system.f = space.condense(system.loads);
  // f = Tᵀ (loads - A k), U = T U_free + k.
  if (k.linfty_norm() > 0.)
    system.f -= space.condense(internal_forces(DisplacedBody(space, scene, k)).forces);
  return system;
}
} // namespace

CondensedMatrix::CondensedMatrix(const FullMatrix<double> &matrix, const unsigned int n_inner)
  : S(matrix.m() - n_inner)
  , X(n_inner, S.m())
  , inner(n_inner) {
  FullMatrix<double> K_ie(n_inner, S.m()), K_ii(n_inner);
  K_ie.fill(matrix, 0, 0, S.m(), 0);
  K_ii.fill(matrix, 0, 0, S.m(), S.m());
  S.fill(matrix);
  X = K_ie;
  inner = K_ii;
  const LAPACKFullMatrix<double> K_ie_again(X);
  X *= -1.;
  inner.set_property(LAPACKSupport::symmetric);
  inner.compute_cholesky_factorization();
  inner.solve(X);
  K_ie_again.Tmmult(S, X, true);
}

template <int dim>
LinearSystem<dim> assemble_linear_system(const DisplacementSpace<dim> &space,
                                         const Scene<dim> &scene, const unsigned int n_points,
                                         const bool condensed) {
  LinearSystem<dim> system = begin_system(space, scene, n_points, space.complete(space.zero()),
                                          make_matrix(space, condensed));
  add_stiffness(space, scene, condensed, system);
  system.matrix.compress(VectorOperation::add);
  return system;
}

template <int dim>
LinearSystem<dim> assemble_right_hand_side(const DisplacementSpace<dim> &space,
                                           const Scene<dim> &scene, const unsigned int n_points,
                                           const Displacement &k) {
  return begin_system(space, scene, n_points, k, {});
}

INSTANTIATE_FUNCTION(make_matrix);
INSTANTIATE_FUNCTION(assemble_linear_system);
INSTANTIATE_FUNCTION(assemble_right_hand_side);
} // namespace Signorini
