// SPDX-License-Identifier: LGPL-2.1-or-later
// The V-cycle, and the transfer between the unknowns of the space and the levels.

#include <signorini/base/errors.h>
#include <signorini/discretization/elasticity/cell_stiffness.h>
#include <signorini/solvers/multigrid/cell_integration.h>
#include <signorini/solvers/multigrid/stiffness_multigrid.h>

#include <cmath>
#include <limits>
#include <optional>
#include <sstream>

#include "multigrid_internal.h"

namespace Signorini
{
namespace
{
/** The maximal number of nodes of the coarsest level, unless it is the coarse mesh. */
constexpr unsigned int max_coarsest_nodes = 200;
} // namespace

template <int dim>
class StiffnessMultigrid<dim>::Levels
{
public:
  Levels(const DisplacementSpace<dim> &space, const Scene<dim> &scene)
    : unit_(stiffness_unit(space, *scene.material))
    , instructions_(instructions_of_this_machine())
    , fine_(space, scene)
    , grid_(fine_.grid)
    , x_(grid_->n_nodes())
    , y_(grid_->n_nodes())
  {
    levels_.push_back(std::make_unique<MultigridLevel<dim>>(
      grid_, fine_.matrices_in_single_precision(), fine_.conditions, instructions_));
    std::optional<CellMatrices<dim, double>> coarse;
    while (levels_.back()->grid().n_nodes() > max_coarsest_nodes && levels_.back()->grid().n() > 1)
      coarse = add_coarser_level(coarse ? *coarse : fine_.matrices);
    fine_.places = {};
    const MultigridLevel<dim> &coarsest = *levels_.back();
    inverse_ = std::make_unique<CoarsestInverse<dim>>(
      coarsest.grid(), coarse ? *coarse : fine_.matrices, coarsest.conditions());
  }

  unsigned int n_dofs() const
  {
    return dim * grid_->n_nodes();
  }
  unsigned int n_levels() const
  {
    return static_cast<unsigned int>(levels_.size());
  }
  std::size_t memory() const
  {
    std::size_t bytes = fine_.matrices.memory() + x_.memory() + y_.memory();
    for (const auto &level : levels_)
      bytes += level->memory();
    return bytes;
  }

  Vector diagonal() const
  {
    LevelVector<dim * dim, double> blocks(grid_->n_nodes());
    add_diagonal_blocks<dim>(blocks, *grid_, fine_.matrices);
    Vector result(n_dofs());
    for (unsigned int node = 0; node < grid_->n_nodes(); ++node)
      for (unsigned int c = 0; c < dim; ++c)
        result[grid_->identities()[node] * dim + c] = unit_ * blocks[c * dim + c][node];
    for (const ConstrainedNode<dim> &condition : fine_.conditions)
    {
      Tensor<2, dim> block;
      for (unsigned int c = 0; c < dim; ++c)
        for (unsigned int d = 0; d < dim; ++d)
          block[c][d] = blocks[c * dim + d][condition.node];
      block = transpose(condition.T) * block * condition.T;
      for (unsigned int c = 0; c < dim; ++c)
        result[grid_->identities()[condition.node] * dim + c] =
          unit_ * (is_constrained(condition, c) ? 1. : block[c][c]);
    }
    return result;
  }

  /** Computes y = Tᵀ K T x. */
  void apply(Vector &y, const Vector &x)
  {
    copy_free_values(x_, x, 1.);
    for (const ConstrainedNode<dim> &condition : fine_.conditions)
      transform(x_, condition.node, condition.T);
    multiply(y_, x_, *grid_, fine_.matrices, instructions_);
    for (const ConstrainedNode<dim> &condition : fine_.conditions)
      transform(y_, condition.node, transpose(condition.T));
    copy_free_values(y, y_, unit_);
  }

  /** Computes z = V r. The vector projection r represents the functional r on the displacements
   * that the conditions allow, and its entries at free components are those of z. */
  void precondition(Vector &z, const Vector &r)
  {
    const double size = r.linfty_norm();
    if (!(size > 0.))
    {
      z = 0.;
      return;
    }
    // A power of two, so that V is the same linear map for all sizes.
    const double scale = std::ldexp(1., -std::ilogb(size));
    MultigridLevel<dim> &finest = *levels_.front();
    copy_free_values(finest.b, r, scale);
    for (const ConstrainedNode<dim> &condition : fine_.conditions)
      transform(finest.b, condition.node, condition.projection);
    cycle(0);
    copy_free_values(z, finest.x, 1. / (scale * unit_));
  }

private:
  /**
   * Adds the next coarser level.
   * @param matrices of the coarsest level so far.
   * @return those of the new one.
   */
  CellMatrices<dim, double> add_coarser_level(const CellMatrices<dim, double> &matrices)
  {
    const MultigridLevel<dim> &finer = *levels_.back();
    const BlockGrid<dim> &grid = finer.grid();
    fine_.places = every_other<dim>(fine_.places, grid.n_blocks(), grid.n());
    const auto coarse = std::make_shared<const BlockGrid<dim>>(
      grid.n_blocks(), grid.n() / 2, fine_.places, grid.n_nodes());
    CellMatrices<dim, double> sums = coarsen(matrices, grid, *coarse);
    const auto &rule = finer.matrices().rule;
    levels_.push_back(std::make_unique<MultigridLevel<dim>>(
      coarse,
      CellMatrices<dim, float>(sums, rule == nullptr ? nullptr : coarsen(*rule, *coarse)),
      coarsen(finer.conditions(), grid.n_nodes(), *coarse),
      instructions_));
    return sums;
  }

  void cycle(const unsigned int l)
  {
    MultigridLevel<dim> &level = *levels_[l];
    if (l + 1 == levels_.size())
    {
      inverse_->apply(level.x, level.b);
      return;
    }
    MultigridLevel<dim> &coarser = *levels_[l + 1];
    level.smooth(true);
    level.multiply();
    // Residuals at constrained components exert no force: y becomes b there.
    for (const ConstrainedNode<dim> &condition : level.conditions())
      for_node_residual(level, condition);
    restrict_residual(coarser.b, level.b, level.y, level.grid(), coarser.grid());
    cycle(l + 1);
    prolongate(level.x, coarser.x, level.grid(), coarser.grid());
    project(level.x, level.conditions());
    level.smooth(false);
  }

  static void for_node_residual(MultigridLevel<dim> &level, const ConstrainedNode<dim> &condition)
  {
    Tensor<1, dim> r;
    for (unsigned int c = 0; c < dim; ++c)
      r[c] = level.b[c][condition.node] - level.y[c][condition.node];
    r = condition.projection * r;
    for (unsigned int c = 0; c < dim; ++c)
      level.y[c][condition.node] = level.b[c][condition.node] - static_cast<float>(r[c]);
  }

  /** Computes u = T u at a node. */
  template <typename Number>
  static void transform(LevelVector<dim, Number> &u, const NodeNumber node, const Tensor<2, dim> &T)
  {
    Tensor<1, dim> value;
    for (unsigned int c = 0; c < dim; ++c)
      value[c] = u[c][node];
    value = T * value;
    for (unsigned int c = 0; c < dim; ++c)
      u[c][node] = static_cast<Number>(value[c]);
  }

  /** Copies the values of the free components, and zero at constrained ones. */
  template <typename Number>
  void copy_free_values(LevelVector<dim, Number> &to, const Vector &from, const double factor) const
  {
    const std::vector<NodeNumber> &identities = grid_->identities();
    for (unsigned int node = 0; node < identities.size(); ++node)
      for (unsigned int c = 0; c < dim; ++c)
        to[c][node] = static_cast<Number>(factor * from[identities[node] * dim + c]);
    for (const ConstrainedNode<dim> &condition : fine_.conditions)
      for (unsigned int c = 0; c < dim; ++c)
        if (is_constrained(condition, c))
          to[c][condition.node] = Number();
  }
  template <typename Number>
  void copy_free_values(Vector &to, const LevelVector<dim, Number> &from, const double factor) const
  {
    const std::vector<NodeNumber> &identities = grid_->identities();
    for (unsigned int node = 0; node < identities.size(); ++node)
      for (unsigned int c = 0; c < dim; ++c)
        to[identities[node] * dim + c] = factor * static_cast<double>(from[c][node]);
    for (const ConstrainedNode<dim> &condition : fine_.conditions)
      for (unsigned int c = 0; c < dim; ++c)
        if (is_constrained(condition, c))
          to[identities[condition.node] * dim + c] = 0.;
  }
  static bool is_constrained(const ConstrainedNode<dim> &condition, const unsigned int c)
  {
    for (unsigned int d = 0; d < dim; ++d)
      if (condition.T[d][c] != 0.)
        return false;
    return true;
  }

  double unit_;
  Instructions instructions_;
  FineLevel<dim> fine_;
  std::shared_ptr<const BlockGrid<dim>> grid_;
  /** The vectors for products in double precision. */
  LevelVector<dim, double> x_, y_;
  /** The levels from the finest to the coarsest. */
  std::vector<std::unique_ptr<MultigridLevel<dim>>> levels_;
  std::unique_ptr<const CoarsestInverse<dim>> inverse_;
};

template <int dim>
StiffnessMultigrid<dim>::StiffnessMultigrid(const DisplacementSpace<dim> &space,
                                            const Scene<dim> &scene)
  : levels_(std::make_unique<Levels>(space, scene))
{
}

template <int dim>
StiffnessMultigrid<dim>::~StiffnessMultigrid() = default;

template <int dim>
unsigned int StiffnessMultigrid<dim>::size() const
{
  return levels_->n_dofs();
}

template <int dim>
typename StiffnessMultigrid<dim>::Vector StiffnessMultigrid<dim>::diagonal() const
{
  return levels_->diagonal();
}

template <int dim>
unsigned int StiffnessMultigrid<dim>::n_levels() const
{
  return levels_->n_levels();
}

template <int dim>
std::size_t StiffnessMultigrid<dim>::memory() const
{
  return levels_->memory();
}

template <int dim>
void StiffnessMultigrid<dim>::apply(Vector &y, const Vector &x) const
{
  levels_->apply(y, x);
}

template <int dim>
void StiffnessMultigrid<dim>::precondition(Vector &z, const Vector &r) const
{
  levels_->precondition(z, r);
}

template class StiffnessMultigrid<2>;
template class StiffnessMultigrid<3>;

// Conjugate gradients with V-cycles.

namespace
{
constexpr unsigned int max_cycles = 500;
/** The rounding error of products with A, relative to a smooth load: 1e-16 / h². */
constexpr double refine_solves_above = 1e-8;
/** The tolerance above which solves are not refined. */
constexpr double loose_goal = 1e-10;
constexpr double refuse_solves_above = 1e-4;

dealii::Vector<double> to_nodal(const StiffnessInverse::Vector &from)
{
  const double *const values = from.trilinos_vector()[0];
  return dealii::Vector<double>(values, values + from.size());
}

void copy_to(StiffnessInverse::Vector &to, const dealii::Vector<double> &from)
{
  std::copy(from.begin(), from.end(), to.trilinos_vector()[0]);
}

[[noreturn]] void refuse_to_go_on(const double reduction)
{
  std::ostringstream message;
  message << "Multigrid reduced the residual of a linear system only to " << std::sqrt(reduction)
          << " of what it was, in at most " << max_cycles
          << " V-cycles; Solver/Linear solver = condensed factorises instead.";
  throw ComputationError(message.str());
}
} // namespace

MultigridInverse::MultigridInverse(std::shared_ptr<const StiffnessOperator> A,
                                   const Vector &diagonal,
                                   const double goal)
  : StiffnessInverse(diagonal,
                     1.,
                     SolveAccuracy{goal > loose_goal ? std::numeric_limits<double>::infinity()
                                                     : refine_solves_above,
                                   refuse_solves_above})
  , A_(std::move(A))
  , tolerance_(goal)
{
}

void MultigridInverse::residual(Vector &r,
                                const Vector &x,
                                const Vector &b,
                                const bool /*accurate*/) const
{
  dealii::Vector<double> product(A_->size());
  A_->apply(product, to_nodal(x));
  product.sadd(-1., 1., to_nodal(b));
  copy_to(r, product);
}

void MultigridInverse::apply(std::vector<Vector> &x, const std::vector<Vector> &b) const
{
  for (std::size_t k = 0; k < x.size(); ++k)
    solve_one(x[k], b[k]);
}

void MultigridInverse::solve_one(Vector &x, const Vector &b) const
{
  dealii::Vector<double> r = to_nodal(b), z(r.size()), q(r.size()), u(r.size());
  A_->precondition(z, r);
  dealii::Vector<double> p = z;
  double rz = r * z;
  const double start = rz, goal = tolerance_ * tolerance_ * start;
  unsigned int n_cycles = 1;
  for (; rz > goal; ++n_cycles)
  {
    A_->apply(q, p);
    const double curvature = p * q;
    if (n_cycles >= max_cycles || !(curvature > 0.))
      refuse_to_go_on(rz / start);
    const double alpha = rz / curvature;
    u.add(alpha, p);
    r.add(-alpha, q);
    A_->precondition(z, r);
    const double before = rz;
    rz = r * z;
    p.sadd(rz / before, 1., z);
  }
  if (!(rz >= 0.))
    refuse_to_go_on(-rz / start);
  copy_to(x, u);
  max_cycles_of_a_solve_ = std::max(max_cycles_of_a_solve_, n_cycles);
}

template <int dim>
std::unique_ptr<MultigridInverse> make_multigrid_inverse(const DisplacementSpace<dim> &space,
                                                         const Scene<dim> &scene,
                                                         const double goal)
{
  const auto A = std::make_shared<const StiffnessMultigrid<dim>>(space, scene);
  DistributedVector diagonal = space.make_vector();
  copy_to(diagonal, A->diagonal());
  return std::make_unique<MultigridInverse>(A, diagonal, goal);
}

template std::unique_ptr<MultigridInverse> make_multigrid_inverse(const DisplacementSpace<2> &,
                                                                  const Scene<2> &,
                                                                  double);
template std::unique_ptr<MultigridInverse> make_multigrid_inverse(const DisplacementSpace<3> &,
                                                                  const Scene<3> &,
                                                                  double);
} // namespace Signorini
