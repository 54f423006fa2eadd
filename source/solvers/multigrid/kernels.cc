// SPDX-License-Identifier: LGPL-2.1-or-later
// A x, cell by cell: batches of cells in vector types of the compiler, for several instruction
// sets.

#include <signorini/solvers/multigrid/kernels.h>

#include <cstring>

#include "point_kernel.h"

namespace Signorini
{
namespace
{
/** Loads n_lanes values along a row, from the place i on. */
template <int dim, typename Number>
SIGNORINI_INLINE void load_row(BatchValues<dim, Number> &values,
                               const unsigned int vertex,
                               const LevelVector<dim, Number> &x,
                               const BlockGrid<dim> &grid,
                               const NodeRow &row,
                               const unsigned int i)
{
  if (row.listed)
  {
    const NodeNumber *const nodes = grid.list(row) + i;
    for (unsigned int c = 0; c < dim; ++c)
    {
      Number *const target = values.values[dim * vertex + c];
      const Number *const source = x[c];
      for (unsigned int l = 0; l < n_lanes; ++l)
        target[l] = source[nodes[l] & ~BlockGrid<dim>::owned_bit];
    }
    return;
  }
  for (unsigned int c = 0; c < dim; ++c)
  {
    Number *const target = values.values[dim * vertex + c];
    const Number *const source = x[c];
    std::memcpy(target, source + row.middle + i - 1, n_lanes * sizeof(Number));
    if (i == 0)
      target[0] = source[row.first];
    if (i + n_lanes > grid.n())
      target[n_lanes - 1] = source[row.last];
  }
}

/** Adds values to y along a row: the transpose of load_row(). */
template <int dim, typename Number, int width>
SIGNORINI_INLINE void add_to_row(LevelVector<dim, Number> &y,
                                 const BatchValues<dim, Number> &values,
                                 const unsigned int vertex,
                                 const BlockGrid<dim> &grid,
                                 const NodeRow &row,
                                 const unsigned int i)
{
  using V = typename Wide<Number, width>::Type;
  if (row.listed)
  {
    const NodeNumber *const nodes = grid.list(row) + i;
    for (unsigned int c = 0; c < dim; ++c)
    {
      const Number *const source = values.values[dim * vertex + c];
      Number *const target = y[c];
      for (unsigned int l = 0; l < n_lanes; ++l)
        target[nodes[l] & ~BlockGrid<dim>::owned_bit] += source[l];
    }
    return;
  }
  for (unsigned int c = 0; c < dim; ++c)
  {
    alignas(64) Number source[n_lanes];
    std::memcpy(source, values.values[dim * vertex + c], sizeof(source));
    if (i == 0)
    {
      y[c][row.first] += source[0];
      source[0] = Number();
    }
    if (i + n_lanes > grid.n())
    {
      y[c][row.last] += source[n_lanes - 1];
      source[n_lanes - 1] = Number();
    }
    Number *const target = y[c] + row.middle + i - 1;
    for (unsigned int l = 0; l < n_lanes; l += width)
    {
      V sum, summand;
      std::memcpy(&sum, target + l, sizeof(V));
      std::memcpy(&summand, source + l, sizeof(V));
      sum += summand;
      std::memcpy(target + l, &sum, sizeof(V));
    }
  }
}

/**
 * Computes y = K x with one K for all lanes.
 * @tparam n_sums the number of sums that registers hold.
 */
template <int dim, typename Number, int width, int n_sums>
SIGNORINI_INLINE void multiply_shared(BatchValues<dim, Number> &y,
                                      const Number *const K,
                                      const BatchValues<dim, Number> &x)
{
  using V = typename Wide<Number, width>::Type;
  constexpr int n_dofs = dim << dim;
  for (unsigned int l = 0; l < n_lanes; l += width)
    for (int begin = 0; begin < n_dofs; begin += n_sums)
    {
      V sums[n_sums];
#pragma GCC unroll 24
      for (int i = 0; i < n_sums; ++i)
        sums[i] = V{};
      for (int j = 0; j < n_dofs; ++j)
      {
        const V x_j = *reinterpret_cast<const V *>(&x.values[j][l]);
#pragma GCC unroll 24
        for (int i = 0; i < n_sums; ++i)
          sums[i] += K[j * n_dofs + begin + i] * x_j;
      }
#pragma GCC unroll 24
      for (int i = 0; i < n_sums; ++i)
        *reinterpret_cast<V *>(&y.values[begin + i][l]) = sums[i];
    }
}

/** Computes y = K x with one K for each lane, [entry][lane]. */
template <int dim, typename Number, int width>
SIGNORINI_INLINE void multiply_stored(BatchValues<dim, Number> &y,
                                      const Number *const K,
                                      const BatchValues<dim, Number> &x)
{
  using V = typename Wide<Number, width>::Type;
  constexpr int n_dofs = dim << dim;
  for (unsigned int l = 0; l < n_lanes; l += width)
  {
    const Number *row = K + l;
    V sums[n_dofs];
    for (int i = 0; i < n_dofs; ++i)
    {
      const V x_i = *reinterpret_cast<const V *>(&x.values[i][l]);
      V sum = V{};
      for (int j = 0; j < i; ++j, row += n_lanes)
      {
        V entry;
        std::memcpy(&entry, row, sizeof(V));
        sum += entry * *reinterpret_cast<const V *>(&x.values[j][l]);
        sums[j] += entry * x_i;
      }
      V entry;
      std::memcpy(&entry, row, sizeof(V));
      row += n_lanes;
      sums[i] = sum + entry * x_i;
    }
    for (int i = 0; i < n_dofs; ++i)
      *reinterpret_cast<V *>(&y.values[i][l]) = sums[i];
  }
}

template <int dim, typename Number, int width, int n_sums>
SIGNORINI_INLINE void multiply_batch(BatchValues<dim, Number> &y,
                                     const CellMatrices<dim, Number> &matrices,
                                     const std::size_t batch,
                                     const BatchValues<dim, Number> &x)
{
  if (matrices.is_shared(batch))
    multiply_shared<dim, Number, width, n_sums>(y, matrices.shared_matrix(batch), x);
  else
    multiply_stored<dim, Number, width>(y, matrices.stored_matrices(batch), x);
}

/** Multiplies all batches of a grid with long rows. */
template <int dim, typename Number, int width, int n_sums>
SIGNORINI_INLINE void multiply_rows(LevelVector<dim, Number> &y,
                                    const LevelVector<dim, Number> &x,
                                    const BlockGrid<dim> &grid,
                                    const CellMatrices<dim, Number> &matrices)
{
  constexpr unsigned int n_rows = 1U << (dim - 1);
  BatchValues<dim, Number> x_batch, y_batch, vertices;
  const unsigned int n = grid.n();
  std::size_t batch = 0;
  for (unsigned int block = 0; block < grid.n_blocks(); ++block)
    for (unsigned int k = 0; k < (dim == 3 ? n : 1U); ++k)
      for (unsigned int j = 0; j < n; ++j)
      {
        const NodeRow *rows[n_rows];
        for (unsigned int r = 0; r < n_rows; ++r)
          rows[r] = &grid.row(block, (k + (r >> 1U)) * (n + 1) + j + (r & 1U));
        for (unsigned int i = 0; i < n; i += n_lanes, ++batch)
        {
          for (unsigned int v = 0; v < 2 * n_rows; ++v)
            load_row(x_batch, v, x, grid, *rows[v / 2], i + (v & 1U));
          if (matrices.is_integrated(batch))
          {
            for (unsigned int v = 0; v < 2 * n_rows; ++v)
              load_row(vertices, v, matrices.rule->places, grid, *rows[v / 2], i + (v & 1U));
            multiply_integrated<dim, Number, width>(y_batch, *matrices.rule, vertices, x_batch);
          }
          else
            multiply_batch<dim, Number, width, n_sums>(y_batch, matrices, batch, x_batch);
          for (unsigned int v = 0; v < 2 * n_rows; v += 2)
            add_to_row<dim, Number, width>(y, y_batch, v, grid, *rows[v / 2], i);
          for (unsigned int v = 1; v < 2 * n_rows; v += 2)
            add_to_row<dim, Number, width>(y, y_batch, v, grid, *rows[v / 2], i + 1);
        }
      }
}

/** Gathers the values of a batch at listed nodes, [vertex][lane]. */
template <int dim, typename Number>
SIGNORINI_INLINE void gather(BatchValues<dim, Number> &values,
                             const LevelVector<dim, Number> &x,
                             const NodeNumber *const nodes)
{
  for (unsigned int v = 0; v < (1U << dim); ++v)
    for (unsigned int c = 0; c < dim; ++c)
    {
      const Number *const source = x[c];
      for (unsigned int l = 0; l < n_lanes; ++l)
        values.values[dim * v + c][l] = source[nodes[v * n_lanes + l]];
    }
}

/** Multiplies all batches of a grid with short rows. */
template <int dim, typename Number, int width, int n_sums>
SIGNORINI_INLINE void multiply_lists(LevelVector<dim, Number> &y,
                                     const LevelVector<dim, Number> &x,
                                     const BlockGrid<dim> &grid,
                                     const CellMatrices<dim, Number> &matrices)
{
  constexpr unsigned int n_vertices = 1U << dim;
  BatchValues<dim, Number> x_batch, y_batch, vertices;
  for (std::size_t batch = 0; batch < grid.n_batches(); ++batch)
  {
    const NodeNumber *const nodes = grid.batch_nodes(batch);
    gather(x_batch, x, nodes);
    if (matrices.is_integrated(batch))
    {
      gather(vertices, matrices.rule->places, nodes);
      multiply_integrated<dim, Number, width>(y_batch, *matrices.rule, vertices, x_batch);
    }
    else
      multiply_batch<dim, Number, width, n_sums>(y_batch, matrices, batch, x_batch);
    const std::size_t rest = grid.n_cells() - batch * n_lanes;
    const auto n_cells = static_cast<unsigned int>(rest < n_lanes ? rest : n_lanes);
    for (unsigned int v = 0; v < n_vertices; ++v)
      for (unsigned int c = 0; c < dim; ++c)
      {
        Number *const target = y[c];
        for (unsigned int l = 0; l < n_cells; ++l)
          target[nodes[v * n_lanes + l]] += y_batch.values[dim * v + c][l];
      }
  }
}

/**
 * Multiplies, see multiply().
 * @tparam bytes of a vector register.
 */
template <int dim, typename Number, int bytes, int n_sums>
SIGNORINI_INLINE void multiply_body(LevelVector<dim, Number> &y,
                                    const LevelVector<dim, Number> &x,
                                    const BlockGrid<dim> &grid,
                                    const CellMatrices<dim, Number> &matrices)
{
  constexpr int width = bytes / static_cast<int>(sizeof(Number));
  y.set_zero();
  if (grid.has_long_rows())
    multiply_rows<dim, Number, width, n_sums>(y, x, grid, matrices);
  else
    multiply_lists<dim, Number, width, n_sums>(y, x, grid, matrices);
}

template <int dim, typename Number>
void multiply_basic(LevelVector<dim, Number> &y,
                    const LevelVector<dim, Number> &x,
                    const BlockGrid<dim> &grid,
                    const CellMatrices<dim, Number> &matrices)
{
  multiply_body<dim, Number, 16, dim == 2 ? 8 : 12>(y, x, grid, matrices);
}

#ifdef __x86_64__
template <int dim, typename Number>
SIGNORINI_AVX2 void multiply_avx2(LevelVector<dim, Number> &y,
                                  const LevelVector<dim, Number> &x,
                                  const BlockGrid<dim> &grid,
                                  const CellMatrices<dim, Number> &matrices)
{
  multiply_body<dim, Number, 32, dim == 2 ? 8 : 12>(y, x, grid, matrices);
}
template <int dim, typename Number>
SIGNORINI_AVX512 void multiply_avx512(LevelVector<dim, Number> &y,
                                      const LevelVector<dim, Number> &x,
                                      const BlockGrid<dim> &grid,
                                      const CellMatrices<dim, Number> &matrices)
{
  multiply_body<dim, Number, 64, dim == 2 ? 8 : 24>(y, x, grid, matrices);
}
#endif
} // namespace

Instructions instructions_of_this_machine()
{
#ifdef __x86_64__
  __builtin_cpu_init();
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
      __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw"))
    return Instructions::avx512;
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
    return Instructions::avx2;
#endif
  return Instructions::basic;
}

template <int dim, typename Number>
void multiply(LevelVector<dim, Number> &y,
              const LevelVector<dim, Number> &x,
              const BlockGrid<dim> &grid,
              const CellMatrices<dim, Number> &matrices,
              const Instructions instructions)
{
#ifdef __x86_64__
  if (instructions == Instructions::avx512)
    return multiply_avx512(y, x, grid, matrices);
  if (instructions == Instructions::avx2)
    return multiply_avx2(y, x, grid, matrices);
#endif
  (void)instructions;
  multiply_basic(y, x, grid, matrices);
}

template void multiply(LevelVector<2, float> &,
                       const LevelVector<2, float> &,
                       const BlockGrid<2> &,
                       const CellMatrices<2, float> &,
                       Instructions);
template void multiply(LevelVector<2, double> &,
                       const LevelVector<2, double> &,
                       const BlockGrid<2> &,
                       const CellMatrices<2, double> &,
                       Instructions);
template void multiply(LevelVector<3, float> &,
                       const LevelVector<3, float> &,
                       const BlockGrid<3> &,
                       const CellMatrices<3, float> &,
                       Instructions);
template void multiply(LevelVector<3, double> &,
                       const LevelVector<3, double> &,
                       const BlockGrid<3> &,
                       const CellMatrices<3, double> &,
                       Instructions);

// Steps of the smoother, node by node, for several instruction sets.

namespace
{
/** Returns the position of the entry of a symmetric matrix in NodeBlocks. */
template <int dim>
constexpr int block_entry(const int i, const int j)
{
  return i == j ? i : dim + i + j - 1;
}

/** Does the step, see SmootherStep. */
template <int dim, int width>
SIGNORINI_INLINE void smooth_body(const SmootherStep<dim> &step)
{
  using V = typename Wide<float, width>::Type;
  // The loop takes whole vectors: the entries behind the last node are zero, and stay so.
  for (unsigned int node = 0; node < step.n_nodes; node += width)
  {
    V r[dim];
#pragma GCC unroll 3
    for (int c = 0; c < dim; ++c)
    {
      std::memcpy(&r[c], step.b[c] + node, sizeof(V));
      if (!step.is_first)
      {
        V y;
        std::memcpy(&y, step.y[c] + node, sizeof(V));
        r[c] -= y;
      }
      r[c] *= step.gamma;
    }
#pragma GCC unroll 3
    for (int c = 0; c < dim; ++c)
    {
      V d = V{}, x = V{};
      if (!step.is_first)
      {
        std::memcpy(&d, step.d[c] + node, sizeof(V));
        std::memcpy(&x, step.x[c] + node, sizeof(V));
        d *= step.alpha;
      }
#pragma GCC unroll 3
      for (int e = 0; e < dim; ++e)
      {
        V B;
        std::memcpy(&B, step.B[block_entry<dim>(c, e)] + node, sizeof(V));
        d += B * r[e];
      }
      x += d;
      std::memcpy(step.d[c] + node, &d, sizeof(V));
      std::memcpy(step.x[c] + node, &x, sizeof(V));
    }
  }
}

template <int dim>
void smooth_basic(const SmootherStep<dim> &step)
{
  smooth_body<dim, 4>(step);
}

#ifdef __x86_64__
template <int dim>
SIGNORINI_AVX2 void smooth_avx2(const SmootherStep<dim> &step)
{
  smooth_body<dim, 8>(step);
}
template <int dim>
SIGNORINI_AVX512 void smooth_avx512(const SmootherStep<dim> &step)
{
  smooth_body<dim, 16>(step);
}
#endif
} // namespace

template <int dim>
void smooth(const SmootherStep<dim> &step, const Instructions instructions)
{
#ifdef __x86_64__
  if (instructions == Instructions::avx512)
    return smooth_avx512(step);
  if (instructions == Instructions::avx2)
    return smooth_avx2(step);
#endif
  (void)instructions;
  smooth_basic(step);
}

template void smooth(const SmootherStep<2> &, Instructions);
template void smooth(const SmootherStep<3> &, Instructions);
} // namespace Signorini
