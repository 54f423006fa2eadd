// SPDX-License-Identifier: LGPL-2.1-or-later
// The smoother of one level.

#include "multigrid_level.h"

#include <deal.II/base/symmetric_tensor.h>

#include "cell_integration.h"

namespace Signorini
{
namespace
{
/** Applications of A in one smoothing, one less from zero. */
constexpr unsigned int n_smoothing_steps = 3;

/** Entries of NodeBlocks, by place. */
template <int dim>
unsigned int place_of(const unsigned int c, const unsigned int d)
{
  return c == d ? c : dim + c + d - 1;
}
} // namespace

template <int dim>
MultigridLevel<dim>::MultigridLevel(std::shared_ptr<const BlockGrid<dim>> grid,
                                    CellMatrices<dim, float> matrices,
                                    NodeConditions<dim> conditions,
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
  largest_eigenvalue_ = largest_eigenvalue_of_cells(matrices_, *grid_);
}

template <int dim>
void MultigridLevel<dim>::make_blocks()
{
  LevelVector<dim * dim, float> blocks(grid_->n_nodes());
  add_diagonal_blocks<dim>(blocks, *grid_, matrices_);
  std::size_t next = 0;
  for (unsigned int node = 0; node < grid_->n_nodes(); ++node)
  {
    dealii::Tensor<2, dim> block;
    for (unsigned int c = 0; c < dim; ++c)
      for (unsigned int d = 0; d < dim; ++d)
        block[c][d] = blocks[c * dim + d][node];
    const double size = trace(block);
    if (next < conditions_.size() && conditions_[next].node == node)
    {
      const dealii::Tensor<2, dim> &projection = conditions_[next++].projection;
      const dealii::Tensor<2, dim> rest =
        dealii::Tensor<2, dim>(dealii::unit_symmetric_tensor<dim>()) - projection;
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
               gamma = static_cast<float>((8. * k - 4.) / ((2. * k + 1.) * largest_eigenvalue_));
    Signorini::smooth<dim>({x, d_, b, y, B_, grid_->n_nodes(), alpha, gamma, is_first},
                           instructions_);
  }
}

template class MultigridLevel<2>;
template class MultigridLevel<3>;
} // namespace Signorini
