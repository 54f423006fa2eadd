// SPDX-License-Identifier: LGPL-2.1-or-later
// The coarsest level is solved directly.

#include "coarsest_inverse.h"

#include <signorini/base/exceptions.h>
#include <signorini/stiffness_inverse/condensed_inverse.h>

#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/lapack_full_matrix.h>

#include "cell_integration.h"

namespace Signorini
{
namespace
{
/** Levels with more unknowns are factorised. */
constexpr unsigned int most_unknowns_of_matrix = 1200;

/** Calls f(row, column, value) for the entries of all cells, projected onto what conditions leave,
 * and with a diagonal for the rest. */
template <int dim, typename Function>
void for_entries(const BlockGrid<dim> &grid,
                 const CellMatrices<dim, double> &matrices,
                 const NodeConditions<dim> &conditions,
                 const Function &f)
{
  std::vector<const NodeCondition<dim> *> condition_of(grid.n_nodes(), nullptr);
  for (const NodeCondition<dim> &condition : conditions)
    condition_of[condition.node] = &condition;
  const auto projected = [&](const NodeNumber node) {
    return condition_of[node] == nullptr
             ? dealii::Tensor<2, dim>(dealii::unit_symmetric_tensor<dim>())
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
        dealii::Tensor<2, dim> block;
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
  for (const NodeCondition<dim> &condition : conditions)
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
                                      const NodeConditions<dim> &conditions)
  : n_nodes_(grid.n_nodes())
  , conditions_(conditions)
{
  const unsigned int n = dim * n_nodes_;
  if (n <= most_unknowns_of_matrix)
  {
    dealii::LAPACKFullMatrix<double> A(n, n);
    for_entries(
      grid,
      matrices,
      conditions,
      [&](const unsigned int i, const unsigned int j, const double value) { A(i, j) += value; });
    A.set_property(dealii::LAPACKSupport::symmetric);
    try
    {
      A.compute_cholesky_factorization();
      A.invert();
    }
    catch (const dealii::LACExceptions::ExcSingular &)
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
  const dealii::IndexSet all = dealii::complete_index_set(n);
  dealii::DynamicSparsityPattern pattern(n, n);
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
  matrix_.compress(dealii::VectorOperation::add);
  factors_ =
    std::make_unique<CondensedInverse>(matrix_, 1., std::vector<dealii::types::global_dof_index>());
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
} // namespace Signorini
