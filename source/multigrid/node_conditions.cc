// SPDX-License-Identifier: LGPL-2.1-or-later
// Essential conditions, node by node.

#include "node_conditions.h"

namespace Signorini
{
template <int dim>
dealii::Tensor<2, dim> projection_onto_range(const dealii::Tensor<2, dim> &T)
{
  dealii::Tensor<2, dim> projection;
  for (unsigned int c = 0; c < dim; ++c)
  {
    dealii::Tensor<1, dim> column;
    for (unsigned int d = 0; d < dim; ++d)
      column[d] = T[d][c];
    const double size = column.norm();
    // Gram and Schmidt, twice against rounding.
    for (unsigned int repetition = 0; repetition < 2; ++repetition)
      column -= projection * column;
    if (column.norm() <= 1e-10 * size)
      continue;
    column /= column.norm();
    projection += outer_product(column, column);
  }
  return projection;
}

template <int dim>
void project(LevelVector<dim, float> &x, const NodeConditions<dim> &conditions)
{
  for (const NodeCondition<dim> &condition : conditions)
  {
    dealii::Tensor<1, dim> u;
    for (unsigned int c = 0; c < dim; ++c)
      u[c] = x[c][condition.node];
    u = condition.projection * u;
    for (unsigned int c = 0; c < dim; ++c)
      x[c][condition.node] = static_cast<float>(u[c]);
  }
}

template <int dim>
NodeConditions<dim> coarsen(const NodeConditions<dim> &fine,
                            const unsigned int n_fine_nodes,
                            const BlockGrid<dim> &coarse)
{
  constexpr NodeNumber none = ~0U;
  std::vector<NodeNumber> place(n_fine_nodes, none);
  for (std::size_t i = 0; i < fine.size(); ++i)
    place[fine[i].node] = static_cast<NodeNumber>(i);
  NodeConditions<dim> conditions;
  for (NodeNumber node = 0; node < coarse.n_nodes(); ++node)
    if (const NodeNumber i = place[coarse.identities()[node]]; i != none)
      conditions.push_back({node, fine[i].T, fine[i].projection});
  return conditions;
}

template dealii::Tensor<2, 2> projection_onto_range(const dealii::Tensor<2, 2> &);
template dealii::Tensor<2, 3> projection_onto_range(const dealii::Tensor<2, 3> &);
template void project(LevelVector<2, float> &, const NodeConditions<2> &);
template void project(LevelVector<3, float> &, const NodeConditions<3> &);
template NodeConditions<2> coarsen(const NodeConditions<2> &, unsigned int, const BlockGrid<2> &);
template NodeConditions<3> coarsen(const NodeConditions<3> &, unsigned int, const BlockGrid<3> &);
} // namespace Signorini
