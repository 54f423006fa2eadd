// SPDX-License-Identifier: LGPL-2.1-or-later
// Between two levels, row by row.

#include "transfer.h"

namespace Signorini
{
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

/** values_i = x at the places of a row; with @p owned zero where the row does not own the node. */
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

/** Whether a row owns no node. */
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
  std::vector<float> of_b(2 * N + 1), of_y(2 * N + 1), sum(N + 1);
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
        read(of_b, b[c], fine, row, true);
        read(of_y, y[c], fine, row, true);
        for (unsigned int i = 0; i <= 2 * N; ++i)
          of_b[i] -= of_y[i];
        sum[0] = of_b[0] + 0.5F * of_b[1];
        for (unsigned int i = 1; i < N; ++i)
          sum[i] = of_b[2 * i] + 0.5F * (of_b[2 * i - 1] + of_b[2 * i + 1]);
        sum[N] = of_b[2 * N] + 0.5F * of_b[2 * N - 1];
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
