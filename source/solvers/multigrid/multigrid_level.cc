// SPDX-License-Identifier: LGPL-2.1-or-later
// The smoother of one level.

#include <signorini/base/errors.h>
#include <signorini/solvers/multigrid/cell_integration.h>
#include <signorini/solvers/stiffness/condensed_inverse.h>

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/lapack_full_matrix.h>

#include "multigrid_internal.h"

namespace Signorini
{
namespace
{
/** The number of applications of A in one smoothing; there is one less if x starts from zero. */
constexpr unsigned int n_smoothing_steps = 3;

/** Returns the place of an entry in NodeBlocks. */
template <int dim>
unsigned int place_of(const unsigned int c, const unsigned int d)
{
  return c == d ? c : dim + c + d - 1;
}
} // namespace

template <int dim>
MultigridLevel<dim>::MultigridLevel(std::shared_ptr<const BlockGrid<dim>> grid,
                                    CellMatrices<dim, float> matrices,
                                    ConstrainedNodes<dim> conditions,
                                    const Instructions instructions)
  : x(grid->n_nodes())
  , b(grid->n_nodes())
  , y(grid->n_nodes())
  , grid_(std::move(grid))
  , matrices_(std::move(matrices))
  , conditions_(std::move(conditions))
  , instructions_(instructions)
  , d_(grid_->n_nodes())
  , B_(grid_->n_nodes())
{
  make_blocks();
  max_eigenvalue_ = max_cell_eigenvalue(matrices_, *grid_);
}

template <int dim>
void MultigridLevel<dim>::make_blocks()
{
  LevelVector<dim * dim, float> blocks(grid_->n_nodes());
  add_diagonal_blocks<dim>(blocks, *grid_, matrices_);
  std::size_t next = 0;
  for (unsigned int node = 0; node < grid_->n_nodes(); ++node)
  {
    Tensor<2, dim> block;
    for (unsigned int c = 0; c < dim; ++c)
      for (unsigned int d = 0; d < dim; ++d)
        block[c][d] = blocks[c * dim + d][node];
    const double size = trace(block);
    if (next < conditions_.size() && conditions_[next].node == node)
    {
      const Tensor<2, dim> &projection = conditions_[next++].projection;
      const Tensor<2, dim> rest = Tensor<2, dim>(unit_symmetric_tensor<dim>()) - projection;
      block = projection * invert(projection * block * projection + size * rest) * projection;
    }
    else
      block = invert(block);
    for (unsigned int c = 0; c < dim; ++c)
      for (unsigned int d = 0; d <= c; ++d)
        B_[place_of<dim>(c, d)][node] = static_cast<float>(block[c][d]);
  }
}

template <int dim>
void MultigridLevel<dim>::multiply()
{
  Signorini::multiply(y, x, *grid_, matrices_, instructions_);
}

template <int dim>
void MultigridLevel<dim>::smooth(const bool from_zero)
{
  for (unsigned int step = 1; step <= n_smoothing_steps; ++step)
  {
    const bool is_first = from_zero && step == 1;
    if (!is_first)
      multiply();
    const double k = step;
    const auto alpha = static_cast<float>(step == 1 ? 0. : (2. * k - 3.) / (2. * k + 1.)),
               gamma = static_cast<float>((8. * k - 4.) / ((2. * k + 1.) * max_eigenvalue_));
    Signorini::smooth<dim>({x, d_, b, y, B_, grid_->n_nodes(), alpha, gamma, is_first},
                           instructions_);
  }
}

template class MultigridLevel<2>;
template class MultigridLevel<3>;

// The coarsest level is solved directly.

namespace
{
/** The number of unknowns above which a level is factorised. */
constexpr unsigned int max_dense_unknowns = 1200;

/** Calls f(row, column, value) for the entries of all cells, projected onto the displacements that
 * the conditions allow, and with a diagonal for the others. */
template <int dim, typename Function>
void for_entries(const BlockGrid<dim> &grid,
                 const CellMatrices<dim, double> &matrices,
                 const ConstrainedNodes<dim> &conditions,
                 const Function &f)
{
  std::vector<const ConstrainedNode<dim> *> condition_of(grid.n_nodes(), nullptr);
  for (const ConstrainedNode<dim> &condition : conditions)
    condition_of[condition.node] = &condition;
  const auto projected = [&](const NodeNumber node) {
    return condition_of[node] == nullptr ? Tensor<2, dim>(unit_symmetric_tensor<dim>())
                                         : condition_of[node]->projection;
  };
  std::vector<double> buffer;
  const double *K = nullptr;
  for (std::size_t cell = 0; cell < grid.n_cells(); ++cell)
  {
    if (cell % n_lanes == 0)
      K = entries_of_batch(matrices, grid, cell / n_lanes, buffer);
    const auto nodes = grid.nodes(cell);
    for (unsigned int v = 0; v < nodes.size(); ++v)
      for (unsigned int w = 0; w < nodes.size(); ++w)
      {
        Tensor<2, dim> block;
        for (unsigned int c = 0; c < dim; ++c)
          for (unsigned int d = 0; d < dim; ++d)
            block[c][d] = K[CellMatrices<dim, double>::entry(v * dim + c, w * dim + d) * n_lanes +
                            cell % n_lanes];
        block = projected(nodes[v]) * block * projected(nodes[w]);
        for (unsigned int c = 0; c < dim; ++c)
          for (unsigned int d = 0; d < dim; ++d)
            f(nodes[v] * dim + c, nodes[w] * dim + d, block[c][d]);
      }
  }
  for (const ConstrainedNode<dim> &condition : conditions)
    for (unsigned int c = 0; c < dim; ++c)
      for (unsigned int d = 0; d < dim; ++d)
        f(condition.node * dim + c,
          condition.node * dim + d,
          (c == d ? 1. : 0.) - condition.projection[c][d]);
}
} // namespace

template <int dim>
CoarsestInverse<dim>::CoarsestInverse(const BlockGrid<dim> &grid,
                                      const CellMatrices<dim, double> &matrices,
                                      const ConstrainedNodes<dim> &conditions)
  : n_nodes_(grid.n_nodes())
  , conditions_(conditions)
{
  const unsigned int n = dim * n_nodes_;
  if (n <= max_dense_unknowns)
  {
    LAPACKFullMatrix<double> A(n, n);
    for_entries(
      grid,
      matrices,
      conditions,
      [&](const unsigned int i, const unsigned int j, const double value) { A(i, j) += value; });
    A.set_property(LAPACKSupport::symmetric);
    try
    {
      A.compute_cholesky_factorization();
      A.invert();
    }
    catch (const LACExceptions::ExcSingular &)
    {
      throw ComputationError("The matrix of the coarsest multigrid level is not positive definite, "
                             "by rounding: the body is very slender, or its moduli differ much; "
                             "Solver/Linear solver = condensed factorises instead.");
    }
    inverse_.resize(static_cast<std::size_t>(n) * n);
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        inverse_[static_cast<std::size_t>(i) * n + j] = A(i, j);
    return;
  }
  const IndexSet all = complete_index_set(n);
  DynamicSparsityPattern pattern(n, n);
  for_entries(grid, matrices, conditions, [&](const unsigned int i, const unsigned int j, double) {
    pattern.add(i, j);
  });
  matrix_.reinit(all, all, pattern, MPI_COMM_SELF);
  for_entries(grid,
              matrices,
              conditions,
              [&](const unsigned int i, const unsigned int j, const double value) {
                matrix_.add(i, j, value);
              });
  matrix_.compress(VectorOperation::add);
  factors_ =
    std::make_unique<CondensedInverse>(matrix_, 1., std::vector<types::global_dof_index>());
}

template <int dim>
void CoarsestInverse<dim>::apply(LevelVector<dim, float> &x, LevelVector<dim, float> &b) const
{
  project(b, conditions_);
  if (factors_ != nullptr)
  {
    StiffnessInverse::Vector right_hand_side = factors_->make_vector(), solution = right_hand_side;
    for (unsigned int node = 0; node < n_nodes_; ++node)
      for (unsigned int c = 0; c < dim; ++c)
        right_hand_side(node * dim + c) = b[c][node];
    factors_->solve(solution, right_hand_side);
    for (unsigned int node = 0; node < n_nodes_; ++node)
      for (unsigned int c = 0; c < dim; ++c)
        x[c][node] = static_cast<float>(solution(node * dim + c));
  }
  else
  {
    std::vector<double> values(static_cast<std::size_t>(dim) * n_nodes_);
    for (unsigned int node = 0; node < n_nodes_; ++node)
      for (unsigned int c = 0; c < dim; ++c)
        values[node * dim + c] = b[c][node];
    const double *row = inverse_.data();
    for (unsigned int node = 0; node < n_nodes_; ++node)
      for (unsigned int c = 0; c < dim; ++c, row += values.size())
      {
        // Several sums: an addition need not wait for the one before.
        std::array<double, 8> sums = {};
        std::size_t j = 0;
        for (; j + 8 <= values.size(); j += 8)
          for (unsigned int s = 0; s < 8; ++s)
            sums[s] += row[j + s] * values[j + s];
        for (; j < values.size(); ++j)
          sums[0] += row[j] * values[j];
        x[c][node] = static_cast<float>(((sums[0] + sums[1]) + (sums[2] + sums[3])) +
                                        ((sums[4] + sums[5]) + (sums[6] + sums[7])));
      }
  }
  project(x, conditions_);
}

template class CoarsestInverse<2>;
template class CoarsestInverse<3>;

// Transfer between two levels, row by row.

namespace
{
/** The coarse rows next to a fine one, which all have the same weight. */
template <int dim>
struct CoarseRows
{
  CoarseRows(const BlockGrid<dim> &fine,
             const BlockGrid<dim> &coarse,
             const unsigned int block,
             const unsigned int place)
  {
    unsigned int jk[2] = {place % (fine.n() + 1), place / (fine.n() + 1)};
    for (unsigned int r = 0; r < (1U << (dim - 1)); ++r)
    {
      // Even places lie on one coarse row, odd ones between two.
      if (((r & 1U) != 0 && jk[0] % 2 == 0) || ((r & 2U) != 0 && jk[1] % 2 == 0))
        continue;
      const unsigned int J = jk[0] / 2 + (r & 1U), K = jk[1] / 2 + (r >> 1U);
      rows[n++] = &coarse.row(block, K * (coarse.n() + 1) + J);
    }
    weight = 1.F / static_cast<float>(n);
  }
  const NodeRow *rows[1 << (dim - 1)] = {};
  unsigned int n = 0;
  float weight;
};

/** Sets values_i = x at the places of a row; with @p owned zero where the row does not own the
 * node. */
template <int dim>
void read(std::vector<float> &values,
          const float *const x,
          const BlockGrid<dim> &grid,
          const NodeRow &row,
          const bool owned)
{
  const unsigned int n = grid.n();
  if (row.listed)
  {
    for (unsigned int i = 0; i <= n; ++i)
      values[i] = owned && !grid.owns(row, i) ? 0.F : x[grid.node(row, i)];
    return;
  }
  values[0] = owned && !row.owned[0] ? 0.F : x[row.first];
  const bool skip = owned && !row.owned[1];
  const float *const middle = x + row.middle;
  for (unsigned int i = 1; i < n; ++i)
    values[i] = skip ? 0.F : middle[i - 1];
  values[n] = owned && !row.owned[2] ? 0.F : x[row.last];
}

/** Adds factor times the values to x, with @p owned only where the row owns the node. */
template <int dim>
void add(float *const x,
         const std::vector<float> &values,
         const float factor,
         const BlockGrid<dim> &grid,
         const NodeRow &row,
         const bool owned)
{
  const unsigned int n = grid.n();
  if (row.listed)
  {
    for (unsigned int i = 0; i <= n; ++i)
      if (!owned || grid.owns(row, i))
        x[grid.node(row, i)] += factor * values[i];
    return;
  }
  if (!owned || row.owned[0])
    x[row.first] += factor * values[0];
  float *const middle = x + row.middle;
  if (!owned || row.owned[1])
    for (unsigned int i = 1; i < n; ++i)
      middle[i - 1] += factor * values[i];
  if (!owned || row.owned[2])
    x[row.last] += factor * values[n];
}

/** Returns whether a row owns no node. */
template <int dim>
bool owns_nothing(const BlockGrid<dim> & /*grid*/, const NodeRow &row)
{
  return !row.listed && !row.owned[0] && !row.owned[1] && !row.owned[2];
}
} // namespace

template <int dim>
void prolongate(LevelVector<dim, float> &x,
                const LevelVector<dim, float> &x_H,
                const BlockGrid<dim> &fine,
                const BlockGrid<dim> &coarse)
{
  const unsigned int N = coarse.n();
  std::vector<float> row_H(N + 1), sum(N + 1), values(2 * N + 1);
  for (unsigned int block = 0; block < fine.n_blocks(); ++block)
    for (unsigned int place = 0; place < fine.rows_per_block(); ++place)
    {
      const NodeRow &row = fine.row(block, place);
      if (owns_nothing(fine, row))
        continue;
      const CoarseRows<dim> rows(fine, coarse, block, place);
      for (int c = 0; c < dim; ++c)
      {
        read(sum, x_H[c], coarse, *rows.rows[0], false);
        for (unsigned int r = 1; r < rows.n; ++r)
        {
          read(row_H, x_H[c], coarse, *rows.rows[r], false);
          for (unsigned int i = 0; i <= N; ++i)
            sum[i] += row_H[i];
        }
        for (unsigned int i = 0; i < N; ++i)
        {
          values[2 * i] = sum[i];
          values[2 * i + 1] = 0.5F * (sum[i] + sum[i + 1]);
        }
        values[2 * N] = sum[N];
        add(x[c], values, rows.weight, fine, row, true);
      }
    }
}

template <int dim>
void restrict_residual(LevelVector<dim, float> &b_H,
                       const LevelVector<dim, float> &b,
                       const LevelVector<dim, float> &y,
                       const BlockGrid<dim> &fine,
                       const BlockGrid<dim> &coarse)
{
  const unsigned int N = coarse.n();
  std::vector<float> b_row(2 * N + 1), y_row(2 * N + 1), sum(N + 1);
  b_H.set_zero();
  for (unsigned int block = 0; block < fine.n_blocks(); ++block)
    for (unsigned int place = 0; place < fine.rows_per_block(); ++place)
    {
      const NodeRow &row = fine.row(block, place);
      if (owns_nothing(fine, row))
        continue;
      const CoarseRows<dim> rows(fine, coarse, block, place);
      for (int c = 0; c < dim; ++c)
      {
        read(b_row, b[c], fine, row, true);
        read(y_row, y[c], fine, row, true);
        for (unsigned int i = 0; i <= 2 * N; ++i)
          b_row[i] -= y_row[i];
        sum[0] = b_row[0] + 0.5F * b_row[1];
        for (unsigned int i = 1; i < N; ++i)
          sum[i] = b_row[2 * i] + 0.5F * (b_row[2 * i - 1] + b_row[2 * i + 1]);
        sum[N] = b_row[2 * N] + 0.5F * b_row[2 * N - 1];
        for (unsigned int r = 0; r < rows.n; ++r)
          add(b_H[c], sum, rows.weight, coarse, *rows.rows[r], false);
      }
    }
}

template void prolongate(LevelVector<2, float> &,
                         const LevelVector<2, float> &,
                         const BlockGrid<2> &,
                         const BlockGrid<2> &);
template void prolongate(LevelVector<3, float> &,
                         const LevelVector<3, float> &,
                         const BlockGrid<3> &,
                         const BlockGrid<3> &);
template void restrict_residual(LevelVector<2, float> &,
                                const LevelVector<2, float> &,
                                const LevelVector<2, float> &,
                                const BlockGrid<2> &,
                                const BlockGrid<2> &);
template void restrict_residual(LevelVector<3, float> &,
                                const LevelVector<3, float> &,
                                const LevelVector<3, float> &,
                                const BlockGrid<3> &,
                                const BlockGrid<3> &);
} // namespace Signorini
