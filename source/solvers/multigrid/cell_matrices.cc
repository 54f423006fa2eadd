// SPDX-License-Identifier: LGPL-2.1-or-later
// Matrices of coarse cells from those of their children.

#include <signorini/solvers/multigrid/cell_integration.h>
#include <signorini/solvers/multigrid/cell_matrices.h>
#include <signorini/solvers/multigrid/kernels.h>

#include <deal.II/base/tensor.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "multigrid_internal.h"
#include "point_kernel.h"

namespace Signorini
{
namespace
{
/** Returns the value of the parent's shape function V at vertex v of a child. */
template <int dim>
double parent_shape(const unsigned int child, const unsigned int v, const unsigned int V)
{
  double value = 1.;
  for (int d = 0; d < dim; ++d)
  {
    const double position = 0.5 * static_cast<double>(((child >> d) & 1U) + ((v >> d) & 1U));
    value *= ((V >> d) & 1U) != 0 ? position : 1. - position;
  }
  return value;
}

/** Adds Pᵀ K_child P to K for n lanes, [i][j][lane]. */
template <int dim, unsigned int n>
void add_child(const unsigned int child, const std::vector<double> &K_child, std::vector<double> &K)
{
  constexpr unsigned int n_vertices = 1U << dim, n_dofs = dim * n_vertices;
  const auto add_row = [](double *const target, const double weight, const double *const source) {
    for (unsigned int j = 0; j < n_dofs * n; ++j)
      target[j] += weight * source[j];
  };
  // Rows: half = Pᵀ K_child, and by its transpose K = half P.
  std::vector<double> half(n_dofs * n_dofs * n, 0.);
  for (unsigned int V = 0; V < n_vertices; ++V)
    for (unsigned int v = 0; v < n_vertices; ++v)
      if (const double weight = parent_shape<dim>(child, v, V); weight != 0.)
        for (unsigned int c = 0; c < dim; ++c)
          add_row(&half[(V * dim + c) * n_dofs * n], weight, &K_child[(v * dim + c) * n_dofs * n]);
  for (unsigned int I = 0; I < n_dofs; ++I)
    for (unsigned int V = 0; V < n_vertices; ++V)
      for (unsigned int v = 0; v < n_vertices; ++v)
        if (const double weight = parent_shape<dim>(child, v, V); weight != 0.)
          for (unsigned int l = 0; l < dim * n; ++l)
            K[(I * n_dofs + V * dim) * n + l] += weight * half[(I * n_dofs + v * dim) * n + l];
}

/** The children of the cells of a coarse level. */
template <int dim>
class Children
{
public:
  Children(const BlockGrid<dim> &coarse, const BlockGrid<dim> &fine)
    : n_(coarse.n())
    , n_fine_(fine.n())
  {
  }
  std::size_t operator()(std::size_t cell, const unsigned int child) const
  {
    std::size_t number = 0, factor = 1;
    for (int d = 0; d < dim; ++d)
    {
      number += factor * (2 * (cell % n_) + ((child >> d) & 1U));
      factor *= n_fine_;
      cell /= n_;
    }
    return cell * factor + number;
  }

private:
  std::size_t n_, n_fine_;
};

/** Returns the matrix of the parent of cells that all have the same matrix. */
template <int dim>
std::vector<double> parent_of_equals(const double *const matrix)
{
  constexpr unsigned int n_dofs = dim << dim;
  const std::vector<double> K_child(matrix, matrix + n_dofs * n_dofs);
  std::vector<double> K(n_dofs * n_dofs, 0.);
  for (unsigned int child = 0; child < (1U << dim); ++child)
    add_child<dim, 1>(child, K_child, K);
  return K;
}

/** Returns the number of the matrix that all children of a batch share, or -1. */
template <int dim>
int common_matrix(const CellMatrices<dim, double> &fine,
                  const Children<dim> &children,
                  const std::size_t begin,
                  const std::size_t end)
{
  const int first = fine.batch_storage[children(begin, 0) / n_lanes];
  if (first < 0)
    return -1;
  for (std::size_t cell = begin; cell < end; ++cell)
    for (unsigned int child = 0; child < (1U << dim); ++child)
      if (fine.batch_storage[children(cell, child) / n_lanes] != first)
        return -1;
  return first;
}

/** Computes the matrices of a batch of cells whose children differ. */
template <int dim>
void store_parents(const CellMatrices<dim, double> &fine,
                   const Children<dim> &children,
                   const std::size_t begin,
                   const std::size_t end,
                   double *const stored)
{
  using Matrices = CellMatrices<dim, double>;
  constexpr unsigned int n_dofs = Matrices::n_dofs;
  std::vector<double> K(n_dofs * n_dofs * n_lanes, 0.), K_child(K.size(), 0.);
  for (unsigned int child = 0; child < (1U << dim); ++child)
  {
    for (std::size_t cell = begin; cell < end; ++cell)
    {
      const std::size_t number = children(cell, child), batch = number / n_lanes;
      const bool is_shared = fine.is_shared(batch);
      const double *const source =
        is_shared ? fine.shared_matrix(batch) : fine.stored_matrices(batch) + number % n_lanes;
      double *const target = &K_child[cell - begin];
      for (unsigned int i = 0; i < n_dofs; ++i)
        for (unsigned int j = 0; j < n_dofs; ++j)
          target[(i * n_dofs + j) * n_lanes] =
            source[is_shared ? i * n_dofs + j : Matrices::entry(i, j) * n_lanes];
    }
    add_child<dim, n_lanes>(child, K_child, K);
  }
  for (unsigned int i = 0; i < n_dofs; ++i)
    for (unsigned int j = 0; j <= i; ++j)
      for (unsigned int l = 0; l < n_lanes; ++l)
        stored[Matrices::entry(i, j) * n_lanes + l] = K[(i * n_dofs + j) * n_lanes + l];
}
} // namespace

template <int dim, typename Number>
std::shared_ptr<const PointRule<dim, Number>> coarsen(const PointRule<dim, Number> &fine,
                                                      const BlockGrid<dim> &coarse_grid)
{
  const auto coarse = std::make_shared<PointRule<dim, Number>>(PointRule<dim, Number>{
    LevelVector<dim, Number>(coarse_grid.n_nodes()), fine.moduli, fine.gradients, fine.weights});
  for (int d = 0; d < dim; ++d)
    for (NodeNumber node = 0; node < coarse_grid.n_nodes(); ++node)
      coarse->places[d][node] = fine.places[d][coarse_grid.identities()[node]];
  return coarse;
}

template <int dim>
CellMatrices<dim, double> coarsen(const CellMatrices<dim, double> &fine,
                                  const BlockGrid<dim> &fine_grid,
                                  const BlockGrid<dim> &coarse_grid)
{
  const Children<dim> children(coarse_grid, fine_grid);
  CellMatrices<dim, double> coarse(coarse_grid.n_batches());
  coarse.stored.reserve(fine.stored.size() >> dim);
  if (fine.rule != nullptr)
    coarse.rule = coarsen(*fine.rule, coarse_grid);
  std::map<int, int> parent_of;
  for (std::size_t batch = 0; batch < coarse_grid.n_batches(); ++batch)
  {
    const std::size_t begin = batch * n_lanes,
                      end = std::min(begin + n_lanes, coarse_grid.n_cells());
    const int common = common_matrix(fine, children, begin, end);
    if (common < 0 && coarse.rule != nullptr)
    {
      coarse.batch_storage[batch] = CellMatrices<dim, double>::integrated;
      continue;
    }
    if (common < 0)
    {
      coarse.store(batch);
      store_parents(fine, children, begin, end, coarse.stored_matrices(batch));
      continue;
    }
    const auto [found, is_new] = parent_of.emplace(common, static_cast<int>(parent_of.size()));
    if (is_new)
    {
      const std::vector<double> parent =
        parent_of_equals<dim>(fine.shared_matrix(children(begin, 0) / n_lanes));
      coarse.shared.insert(coarse.shared.end(), parent.begin(), parent.end());
    }
    coarse.batch_storage[batch] = found->second;
  }
  return coarse;
}

template std::shared_ptr<const PointRule<2, float>> coarsen(const PointRule<2, float> &,
                                                            const BlockGrid<2> &);
template std::shared_ptr<const PointRule<3, float>> coarsen(const PointRule<3, float> &,
                                                            const BlockGrid<3> &);
template CellMatrices<2, double> coarsen(const CellMatrices<2, double> &,
                                         const BlockGrid<2> &,
                                         const BlockGrid<2> &);
template CellMatrices<3, double> coarsen(const CellMatrices<3, double> &,
                                         const BlockGrid<3> &,
                                         const BlockGrid<3> &);

// The largest eigenvalue that a cell allows.

namespace
{
/** The numbers of steps of the power method, more of them for matrices of many cells, and the
 * safety factor of its result. */
constexpr unsigned int n_steps_stored = 40, n_steps_shared = 400;
constexpr double safety = 1.05;

/** The pencils of n cells side by side: values[i][lane] and K[entry][lane]. */
template <int dim, unsigned int n>
class CellPencils
{
public:
  static constexpr unsigned int n_dofs = dim << dim;
  using Matrices = CellMatrices<dim, float>;

  /**
   * Inverts the diagonal blocks.
   * @param K with distance n between entries.
   */
  SIGNORINI_INLINE explicit CellPencils(const float *K)
    : K_(K)
  {
    for (unsigned int l = 0; l < n; ++l)
      for (unsigned int v = 0; v < (1U << dim); ++v)
      {
        Tensor<2, dim> block;
        for (unsigned int c = 0; c < dim; ++c)
          for (unsigned int d = 0; d < dim; ++d)
            block[c][d] = K[Matrices::entry(v * dim + c, v * dim + d) * n + l];
        block = invert(block);
        for (unsigned int c = 0; c < dim; ++c)
          for (unsigned int d = 0; d < dim; ++d)
            B_[v][c][d][l] = static_cast<float>(block[c][d]);
      }
  }

  /** Returns the largest eigenvalue of the first @p n_cells cells. */
  SIGNORINI_INLINE double max_eigenvalue(const unsigned int n_cells,
                                         const unsigned int n_steps) const
  {
    float x[n_dofs][n], y[n_dofs][n], quotient[n];
    // The vector has no pattern: no eigenvector is orthogonal to it.
    for (unsigned int i = 0; i < n_dofs; ++i)
      for (unsigned int l = 0; l < n; ++l)
        y[i][l] = static_cast<float>((i * i * 7919 + 104729 * i + 1) % 101) - 47.3F;
    for (unsigned int step = 0; step < n_steps; ++step)
    {
      // x = B y; y = K x; x.K x / y_before.B y_before, of which the denominator is made one.
      scale(y, x);
      multiply(y, x);
      for (unsigned int l = 0; l < n; ++l)
        quotient[l] = 0.F;
      for (unsigned int i = 0; i < n_dofs; ++i)
        for (unsigned int l = 0; l < n; ++l)
          quotient[l] += x[i][l] * y[i][l];
    }
    return *std::max_element(quotient, quotient + n_cells);
  }

private:
  /** Computes x = B y, and divides both by (y.B y)^{1/2}. */
  SIGNORINI_INLINE void scale(float (&y)[n_dofs][n], float (&x)[n_dofs][n]) const
  {
    float size[n] = {};
    for (unsigned int v = 0; v < (1U << dim); ++v)
      for (unsigned int c = 0; c < dim; ++c)
        for (unsigned int l = 0; l < n; ++l)
        {
          float sum = 0.F;
          for (unsigned int d = 0; d < dim; ++d)
            sum += B_[v][c][d][l] * y[v * dim + d][l];
          x[v * dim + c][l] = sum;
          size[l] += sum * y[v * dim + c][l];
        }
    for (unsigned int l = 0; l < n; ++l)
      size[l] = size[l] > 0.F ? 1.F / std::sqrt(size[l]) : 0.F;
    for (unsigned int i = 0; i < n_dofs; ++i)
      for (unsigned int l = 0; l < n; ++l)
        x[i][l] *= size[l];
  }
  SIGNORINI_INLINE void multiply(float (&y)[n_dofs][n], const float (&x)[n_dofs][n]) const
  {
    for (unsigned int i = 0; i < n_dofs; ++i)
    {
      float sum[n] = {};
      for (unsigned int j = 0; j < n_dofs; ++j)
      {
        const float *const entry = K_ + Matrices::entry(i, j) * n;
        for (unsigned int l = 0; l < n; ++l)
          sum[l] += entry[l] * x[j][l];
      }
      std::copy(sum, sum + n, y[i]);
    }
  }

  const float *K_;
  float B_[1U << dim][dim][dim][n];
};
/** Returns the largest eigenvalue of n_lanes cells, [entry][lane]. */
template <int dim>
double batch_eigenvalue_basic(const float *const K)
{
  return CellPencils<dim, n_lanes>(K).max_eigenvalue(n_lanes, n_steps_stored);
}
#ifdef __x86_64__
template <int dim>
SIGNORINI_AVX2 double batch_eigenvalue_avx2(const float *const K)
{
  return CellPencils<dim, n_lanes>(K).max_eigenvalue(n_lanes, n_steps_stored);
}
template <int dim>
SIGNORINI_AVX512 double batch_eigenvalue_avx512(const float *const K)
{
  return CellPencils<dim, n_lanes>(K).max_eigenvalue(n_lanes, n_steps_stored);
}
#endif

template <int dim>
double (*best_of_batch())(const float *)
{
#ifdef __x86_64__
  switch (instructions_of_this_machine())
  {
  case Instructions::avx512:
    return &batch_eigenvalue_avx512<dim>;
  case Instructions::avx2:
    return &batch_eigenvalue_avx2<dim>;
  case Instructions::basic:
    break;
  }
#endif
  return &batch_eigenvalue_basic<dim>;
}
} // namespace

template <int dim>
double max_cell_eigenvalue(const CellMatrices<dim, float> &matrices, const BlockGrid<dim> &grid)
{
  using Matrices = CellMatrices<dim, float>;
  constexpr unsigned int n_dofs = Matrices::n_dofs;
  double largest = 0.;
  for (std::size_t k = 0; k < matrices.shared.size(); k += n_dofs * n_dofs)
  {
    std::vector<float> lower(Matrices::n_entries);
    for (unsigned int i = 0; i < n_dofs; ++i)
      for (unsigned int j = 0; j <= i; ++j)
        lower[Matrices::entry(i, j)] = matrices.shared[k + i * n_dofs + j];
    largest =
      std::max(largest, CellPencils<dim, 1>(lower.data()).max_eigenvalue(1, n_steps_shared));
  }
  const auto batch_storage = best_of_batch<dim>();
  std::vector<float> buffer;
  for (std::size_t batch = 0; batch < grid.n_batches(); ++batch)
    if (!matrices.is_shared(batch))
      largest = std::max(largest, batch_storage(entries_of_batch(matrices, grid, batch, buffer)));
  // Of m blocks no eigenvalue is larger than m.
  return std::min(safety * largest, static_cast<double>(1U << dim));
}

template double max_cell_eigenvalue(const CellMatrices<2, float> &, const BlockGrid<2> &);
template double max_cell_eigenvalue(const CellMatrices<3, float> &, const BlockGrid<3> &);
} // namespace Signorini
