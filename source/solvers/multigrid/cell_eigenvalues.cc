// SPDX-License-Identifier: LGPL-2.1-or-later
// The largest eigenvalue that a cell allows.

#include "cell_eigenvalues.h"

#include <signorini/solvers/multigrid/cell_integration.h>
#include <signorini/solvers/multigrid/kernels.h>

#include <deal.II/base/tensor.h>

#include <algorithm>
#include <cmath>

#include "point_kernel.h"

namespace Signorini
{
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
        dealii::Tensor<2, dim> block;
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
  SIGNORINI_INLINE double largest_eigenvalue(const unsigned int n_cells,
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
double of_batch_basic(const float *const K)
{
  return CellPencils<dim, n_lanes>(K).largest_eigenvalue(n_lanes, n_steps_stored);
}
#ifdef __x86_64__
template <int dim>
SIGNORINI_AVX2 double of_batch_avx2(const float *const K)
{
  return CellPencils<dim, n_lanes>(K).largest_eigenvalue(n_lanes, n_steps_stored);
}
template <int dim>
SIGNORINI_AVX512 double of_batch_avx512(const float *const K)
{
  return CellPencils<dim, n_lanes>(K).largest_eigenvalue(n_lanes, n_steps_stored);
}
#endif

template <int dim>
double (*best_of_batch())(const float *)
{
#ifdef __x86_64__
  switch (instructions_of_this_machine())
  {
  case Instructions::avx512:
    return &of_batch_avx512<dim>;
  case Instructions::avx2:
    return &of_batch_avx2<dim>;
  case Instructions::basic:
    break;
  }
#endif
  return &of_batch_basic<dim>;
}
} // namespace

template <int dim>
double largest_eigenvalue_of_cells(const CellMatrices<dim, float> &matrices,
                                   const BlockGrid<dim> &grid)
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
      std::max(largest, CellPencils<dim, 1>(lower.data()).largest_eigenvalue(1, n_steps_shared));
  }
  const auto of_batch = best_of_batch<dim>();
  std::vector<float> buffer;
  for (std::size_t batch = 0; batch < grid.n_batches(); ++batch)
    if (!matrices.is_shared(batch))
      largest = std::max(largest, of_batch(entries_of_batch(matrices, grid, batch, buffer)));
  // Of m blocks no eigenvalue is larger than m.
  return std::min(safety * largest, static_cast<double>(1U << dim));
}

template double largest_eigenvalue_of_cells(const CellMatrices<2, float> &, const BlockGrid<2> &);
template double largest_eigenvalue_of_cells(const CellMatrices<3, float> &, const BlockGrid<3> &);
} // namespace Signorini
