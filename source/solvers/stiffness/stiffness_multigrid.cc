// SPDX-License-Identifier: LGPL-2.1-or-later
// The V-cycle, and conjugate gradients with it.

#include <signorini/base/errors.h>
#include <signorini/base/instantiate.h>
#include <signorini/discretization/space/cell_stiffness.h>
#include <signorini/solvers/stiffness/stiffness_multigrid.h>

#include <deal.II/base/mpi.h>
#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/solver_control.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "fine_operator.h"
#include "point_kernel.h"
#include "replicated_level.h"

namespace Signorini {
namespace {
/** The number of Gauss points per direction that V-cycles need where products are integrated. */
constexpr unsigned int n_points_of_cycles = 2;

/** Computes u = T u or u = Tᵀ u at all nodes that are not free. */
template <int dim, typename Number>
void transform(LevelVector<dim, Number> &u, const ConstrainedNodes<dim> &conditions,
               const bool transposed) {
  for (const auto &[node, T] : conditions) {
    Tensor<1, dim> value;
    for (int c = 0; c < dim; ++c)
      value[c] = u[c][node];
    value = transposed ? value * T : T * value;
    for (int c = 0; c < dim; ++c)
      u[c][node] = static_cast<Number>(value[c]);
  }
}

/** Sets constrained components to zero. */
template <int dim>
void clear_constrained(LevelVector<dim, float> &u, const ConstrainedNodes<dim> &conditions) {
  for (const auto &[node, T] : conditions)
    for (int c = 0; c < dim; ++c)
      if (T[c][c] == 0.)
        u[c][node] = 0.F;
}

/** Returns the conditions of the space, which never join two nodes on a mesh without hanging nodes.
 */
template <int dim>
ConstrainedNodes<dim> conditions_of(const DisplacementSpace<dim> &space,
                                    const std::vector<types::global_dof_index> &numbers) {
  const auto &constraints = space.constraints();
  ConstrainedNodes<dim> conditions;
  for (NodeNumber node = 0; node < numbers.size(); ++node) {
    const types::global_dof_index first = numbers[node] * dim;
    Tensor<2, dim> T;
    for (unsigned int c = 0; c < dim; ++c) {
      T[c][c] = constraints.is_constrained(first + c) ? 0. : 1.;
      if (T[c][c] == 0.)
        for (const auto &[other, weight] : *constraints.get_constraint_entries(first + c)) {
          AssertThrow(other / dim == numbers[node],
                      ExcMessage("Multigrid: a condition joins two nodes."));
          T[c][other - first] = weight;
        }
    }
    if (trace(T) < dim)
      conditions.emplace_hint(conditions.end(), node, T);
  }
  return conditions;
}

/** Returns the numbers of the nodes in the whole mesh. */
template <int dim>
std::vector<types::global_dof_index> numbers_of(const DisplacementSpace<dim> &space,
                                                const std::vector<NodeNumber> &identities) {
  const auto rows = space.make_vector().get_partitioner();
  std::vector<types::global_dof_index> numbers;
  numbers.reserve(identities.size());
  for (const NodeNumber identity : identities)
    numbers.push_back(rows->local_to_global(identity * dim) / dim);
  return numbers;
}

/** Returns the numbers of the nodes of a coarser level. */
std::vector<types::global_dof_index> at(const std::vector<types::global_dof_index> &numbers,
                                        const std::vector<NodeNumber> &identities) {
  std::vector<types::global_dof_index> selected;
  selected.reserve(identities.size());
  for (const NodeNumber node : identities)
    selected.push_back(numbers[node]);
  return selected;
}

/** Returns the shared nodes of the finest level. @param numbers of its nodes in the whole mesh. */
template <int dim>
SharedNodes shared_nodes(const DisplacementSpace<dim> &space,
                         const std::vector<NodeNumber> &identities,
                         const std::vector<types::global_dof_index> &numbers) {
  if (!space.mesh().is_shared())
    return {};
  // Rows of other ranks, and own ones that others read.
  const auto rows = space.make_vector().get_partitioner();
  std::vector<bool> may_be_shared(rows->locally_owned_size(), false);
  may_be_shared.resize(may_be_shared.size() + rows->n_ghost_indices(), true);
  for (const auto &[begin, end] : rows->import_indices())
    std::fill(may_be_shared.begin() + begin, may_be_shared.begin() + end, true);
  std::vector<std::pair<types::global_dof_index, NodeNumber>> nodes;
  for (NodeNumber node = 0; node < numbers.size(); ++node)
    if (may_be_shared[identities[node] * dim])
      nodes.emplace_back(numbers[node], node);
  const auto &mesh =
    dynamic_cast<const parallel::TriangulationBase<dim> &>(space.mesh().triangulation());
  return {nodes, mesh.ghost_owners(), space.mesh().communicator()};
}

/** Returns the conditions of the next coarser level: its nodes keep those of the finer one. */
template <int dim>
ConstrainedNodes<dim> coarsen(const ConstrainedNodes<dim> &fine,
                              const std::vector<NodeNumber> &identities) {
  ConstrainedNodes<dim> conditions;
  for (NodeNumber node = 0; node < identities.size(); ++node)
    if (const auto found = fine.find(identities[node]); found != fine.end())
      conditions.emplace_hint(conditions.end(), node, found->second);
  return conditions;
}
} // namespace

template <int dim>
MultigridLevel<dim>::MultigridLevel(const CellOperator<dim, double> &fine_K,
                                    ConstrainedNodes<dim> given, SharedNodes given_nodes)
  : K(fine_K, n_points_of_cycles)
  , conditions(std::move(given))
  , shared(std::move(given_nodes))
  , x(K.grid->n_nodes())
  , b(x)
  , y(x)
  , d(x)
  , B(K.grid->n_nodes())
  , max_eigenvalue(Utilities::MPI::max(max_cell_eigenvalue(K), shared.communicator())) {
  std::vector<Tensor<2, dim>> blocks = free_diagonal_blocks();
  for (Tensor<2, dim> &block : blocks)
    block = invert(block);
  for (const auto &[node, T] : conditions)
    blocks[node] = T * blocks[node] * transpose(T);
  for (NodeNumber node = 0; node < blocks.size(); ++node)
    for (int c = 0; c < dim; ++c)
      for (int e = 0; e <= c; ++e)
        B[voigt<dim>(c, e)][node] = static_cast<float>(blocks[node][c][e]);
}

template <int dim>
std::vector<Tensor<2, dim>> MultigridLevel<dim>::free_diagonal_blocks() const {
  NodeBlocks<dim> D = diagonal_blocks(K);
  shared.add(D);
  std::vector<Tensor<2, dim>> blocks(K.grid->n_nodes());
  for (NodeNumber node = 0; node < blocks.size(); ++node)
    for (int c = 0; c < dim; ++c)
      for (int e = 0; e < dim; ++e)
        blocks[node][c][e] = D[voigt<dim>(c, e)][node];
  for (const auto &[node, T] : conditions) {
    blocks[node] = transpose(T) * blocks[node] * T;
    for (int c = 0; c < dim; ++c)
      blocks[node][c][c] += 1. - T[c][c];
  }
  return blocks;
}

template <int dim>
void MultigridLevel<dim>::smooth(const bool from_zero) {
  constexpr unsigned int n_steps = 3;
  for (unsigned int step = 1; step <= n_steps; ++step) {
    const bool is_first = from_zero && step == 1;
    if (!is_first) {
      K.multiply(y, x);
      shared.add(y);
    }
    const double k = step;
    const auto alpha = static_cast<float>(step == 1 ? 0. : (2. * k - 3.) / (2. * k + 1.)),
               gamma = static_cast<float>((8. * k - 4.) / ((2. * k + 1.) * max_eigenvalue));
    SmootherStep<dim>{x, d, b, y, B, alpha, gamma, is_first}.run();
  }
}

template struct MultigridLevel<2>;
template struct MultigridLevel<3>;

template <int dim>
StiffnessMultigrid<dim>::StiffnessMultigrid(const DisplacementSpace<dim> &space,
                                            const Scene<dim> &scene)
  : unit_(stiffness_unit(space, *scene.material))
  , rows_(space.locally_owned())
  , communicator_(space.mesh().communicator())
  , K_(std::make_shared<const CellOperator<dim, double>>(make_fine_operator(space, scene)))
  , x_(K_->grid->n_nodes())
  , y_(x_) {
  const Mesh<dim> &mesh = space.mesh();
  std::vector<types::global_dof_index> numbers = numbers_of(space, K_->grid->identities);
  levels_.emplace_back(*K_, conditions_of(space, numbers),
                       shared_nodes(space, K_->grid->identities, numbers));
  auto last = add_coarser_levels(K_);
  if (mesh.is_shared()) {
    for (std::size_t l = 1; l < levels_.size(); ++l)
      numbers = at(numbers, levels_[l].K.grid->identities);
    copied_level_ = levels_.size() - 1;
    auto copy = replicate<dim>(*last, levels_.back().conditions, numbers, own_blocks(mesh), mesh);
    // The sum over all ranks makes the copy's right-hand side from the parts of ranks.
    levels_.back().shared = SharedNodes();
    nodes_of_copy_ = std::move(copy.nodes);
    levels_.emplace_back(copy.K, std::move(copy.conditions), SharedNodes());
    last = add_coarser_levels(std::make_shared<const CellOperator<dim, double>>(std::move(copy.K)));
  }
  coarsest_inverse_ = std::make_unique<const CoarsestInverse<dim>>(*last, levels_.back().conditions,
                                                                   mesh.triangulation());
}

template <int dim>
std::shared_ptr<const CellOperator<dim, double>>
StiffnessMultigrid<dim>::add_coarser_levels(std::shared_ptr<const CellOperator<dim, double>> K) {
  // The coarsest level is the finest one with so few nodes, or the coarse mesh.
  constexpr unsigned int max_coarsest_nodes = 200;
  const auto has_many_nodes = [](const MultigridLevel<dim> &level) {
    return Utilities::MPI::sum(level.K.grid->n_nodes() - level.shared.n_foreign(),
                               level.shared.communicator()) > max_coarsest_nodes;
  };
  while (K->grid->n > 1 && has_many_nodes(levels_.back())) {
    K = std::make_shared<const CellOperator<dim, double>>(
      K->coarsen(std::make_shared<const BlockGrid<dim>>(K->grid->coarsen())));
    const std::vector<NodeNumber> &identities = K->grid->identities;
    levels_.emplace_back(*K, coarsen(levels_.back().conditions, identities),
                         levels_.back().shared.coarsen(identities));
  }
  return K;
}

template <int dim>
void StiffnessMultigrid<dim>::solve_coarsest(MultigridLevel<dim> &level) const {
  transform(level.b, level.conditions, true);
  dealii::Vector<double> u(dim * level.K.grid->n_nodes());
  for (unsigned int i = 0; i < u.size(); ++i)
    u[i] = level.b[i % dim][i / dim];
  coarsest_inverse_->solve(u);
  for (unsigned int i = 0; i < u.size(); ++i)
    level.x[i % dim][i / dim] = static_cast<float>(u[i]);
  transform(level.x, level.conditions, false);
}

template <int dim>
void StiffnessMultigrid<dim>::cycle(const unsigned int l) const {
  MultigridLevel<dim> &level = levels_[l];
  if (l == copied_level_)
    return cycle_on_copy(l);
  if (l + 1 == levels_.size())
    return solve_coarsest(level);
  MultigridLevel<dim> &coarser = levels_[l + 1];
  const BlockGrid<dim> &grid = *level.K.grid;
  level.smooth(true);
  level.K.multiply(level.y, level.x);
  level.shared.add(level.y);
  for (int c = 0; c < dim; ++c)
    for (unsigned int node = 0; node < grid.n_nodes(); ++node)
      level.y[c][node] = level.b[c][node] - level.y[c][node];
  // The transpose of prolongation and T.
  transform(level.y, level.conditions, true);
  level.shared.clear_foreign(level.y);
  grid.restrict_and_clear(coarser.b, level.y, *coarser.K.grid);
  coarser.shared.add(coarser.b);
  cycle(l + 1);
  grid.prolongate(level.y, coarser.x, *coarser.K.grid);
  transform(level.y, level.conditions, false);
  for (int c = 0; c < dim; ++c)
    for (unsigned int node = 0; node < grid.n_nodes(); ++node)
      level.x[c][node] += level.y[c][node];
  level.smooth(false);
}

template <int dim>
void StiffnessMultigrid<dim>::cycle_on_copy(const unsigned int l) const {
  MultigridLevel<dim> &level = levels_[l], &copy = levels_[l + 1];
  // One reduction for all components: on many ranks its latency counts.
  const unsigned int n = copy.K.grid->n_nodes();
  std::vector<float> sums(dim * n);
  for (int c = 0; c < dim; ++c)
    for (unsigned int node = 0; node < nodes_of_copy_.size(); ++node)
      sums[c * n + nodes_of_copy_[node]] += level.b[c][node];
  const ArrayView<float> all(sums);
  Utilities::MPI::sum<float>(all, communicator_, all);
  for (int c = 0; c < dim; ++c)
    std::copy_n(sums.begin() + c * n, n, copy.b[c].begin());
  cycle(l + 1);
  for (int c = 0; c < dim; ++c)
    for (unsigned int node = 0; node < nodes_of_copy_.size(); ++node)
      level.x[c][node] = copy.x[c][nodes_of_copy_[node]];
}

template <int dim>
typename StiffnessMultigrid<dim>::Vector StiffnessMultigrid<dim>::diagonal() const {
  const std::vector<Tensor<2, dim>> blocks = levels_.front().free_diagonal_blocks();
  Vector result = make_vector();
  for (NodeNumber node = 0; node < blocks.size(); ++node)
    if (const std::size_t first = K_->grid->identities[node] * dim; first < rows_.n_elements())
      for (int c = 0; c < dim; ++c)
        result.local_element(first + c) = unit_ * blocks[node][c][c];
  return result;
}

template <int dim>
std::size_t StiffnessMultigrid<dim>::memory() const {
  std::size_t bytes = K_->memory() + x_.memory() + y_.memory();
  for (const MultigridLevel<dim> &level : levels_)
    bytes += level.memory();
  return bytes;
}

template <int dim>
template <typename Number>
void StiffnessMultigrid<dim>::copy_to_level(LevelVector<dim, Number> &to, const Vector &from,
                                            const double factor) const {
  const std::vector<NodeNumber> &identities = K_->grid->identities;
  const double *const entries = from.begin();
  const std::size_t n_own = rows_.n_elements();
  for (unsigned int node = 0; node < identities.size(); ++node) {
    const std::size_t first = identities[node] * std::size_t(dim);
    for (unsigned int c = 0; c < dim; ++c)
      to[c][node] = first < n_own ? static_cast<Number>(factor * entries[first + c]) : Number();
  }
  levels_.front().shared.add(to);
}

template <int dim>
template <typename Number>
void StiffnessMultigrid<dim>::copy_from_level(Vector &to, const LevelVector<dim, Number> &from,
                                              const double factor) const {
  const std::vector<NodeNumber> &identities = K_->grid->identities;
  double *const entries = to.begin();
  for (unsigned int node = 0; node < identities.size(); ++node)
    if (const std::size_t first = identities[node] * std::size_t(dim); first < rows_.n_elements())
      for (unsigned int c = 0; c < dim; ++c)
        entries[first + c] = factor * static_cast<double>(from[c][node]);
}

/** Computes y = Tᵀ K T x. */
template <int dim>
void StiffnessMultigrid<dim>::vmult(Vector &y, const Vector &x) const {
  copy_to_level(x_, x, 1.);
  transform(x_, levels_.front().conditions, false);
  K_->multiply(y_, x_);
  levels_.front().shared.add(y_);
  transform(y_, levels_.front().conditions, true);
  copy_from_level(y, y_, unit_);
}

/** Computes z = V r. The vector r, zero at constrained components, represents the functional r on
 * the displacements that the conditions allow, and its entries at free components are those of z.
 */
template <int dim>
void StiffnessMultigrid<dim>::precondition(Vector &z, const Vector &r) const {
  const double size = r.linfty_norm();
  if (!(size > 0.)) {
    z = 0.;
    return;
  }
  // A power of two, so that V is the same linear map for all sizes.
  const double scale = std::ldexp(1., -std::ilogb(size));
  MultigridLevel<dim> &finest = levels_.front();
  copy_to_level(finest.b, r, scale);
  clear_constrained(finest.b, finest.conditions);
  cycle(0);
  clear_constrained(finest.x, finest.conditions);
  copy_from_level(z, finest.x, 1. / (scale * unit_));
}

template class StiffnessMultigrid<2>;
template class StiffnessMultigrid<3>;

namespace {
constexpr unsigned int max_cycles = 500;
/** The rounding error of products with A, relative to a smooth load: 1e-16 / h². */
constexpr double refine_solves_above = 1e-8;
/** The tolerance above which solves are not refined. */
constexpr double loose_goal = 1e-10;
constexpr double refuse_solves_above = 1e-4;

/** The V-cycle as SolverCG calls it. */
struct VCycle {
  const StiffnessOperator &A;

  void vmult(StiffnessOperator::Vector &z, const StiffnessOperator::Vector &r) const {
    A.precondition(z, r);
  }
};
} // namespace

MultigridInverse::MultigridInverse(std::shared_ptr<const StiffnessOperator> A,
                                   const Vector &diagonal, const double goal)
  : StiffnessInverse(diagonal, 1.,
                     SolveAccuracy{goal > loose_goal ? std::numeric_limits<double>::infinity()
                                                     : refine_solves_above,
                                   refuse_solves_above})
  , A_(std::move(A))
  , tolerance_(goal) {}

void MultigridInverse::residual(Vector &r, const Vector &x, const Vector &b,
                                const bool /*accurate*/) const {
  A_->vmult(r, x);
  r.sadd(-1., 1., b);
}

void MultigridInverse::apply(std::vector<Vector> &x, const std::vector<Vector> &b) const {
  for (std::size_t k = 0; k < x.size(); ++k) {
    ReductionControl control(max_cycles, 0., tolerance_, false, false);
    SolverCG<Vector> solver(control);
    Vector u = A_->make_vector();
    try {
      solver.solve(*A_, u, b[k], VCycle{*A_});
    } catch (const SolverControl::NoConvergence &) {
      std::ostringstream message;
      message << "Multigrid reduced the residual of a linear system only to "
              << control.last_value() / control.initial_value() << " of what it was, in at most "
              << max_cycles << " V-cycles; Solver/Linear solver = condensed factorises instead.";
      throw ComputationError(message.str());
    }
    std::copy(u.begin(), u.end(), x[k].begin());
  }
}

template <int dim>
std::unique_ptr<MultigridInverse> make_multigrid_inverse(const DisplacementSpace<dim> &space,
                                                         const Scene<dim> &scene,
                                                         const double goal) {
  const auto A = std::make_shared<const StiffnessMultigrid<dim>>(space, scene);
  return std::make_unique<MultigridInverse>(A, A->diagonal(), goal);
}

INSTANTIATE_FUNCTION(make_multigrid_inverse);
} // namespace Signorini
