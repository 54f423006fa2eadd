// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/solvers/multigrid/cell_matrices.h>

#include <cstring>

/** The bodies of kernels are inlined into functions that are compiled for several instruction sets.
 */
#define SIGNORINI_INLINE [[gnu::always_inline]] inline

#ifdef __x86_64__
#define SIGNORINI_AVX2 __attribute__((target("avx2,fma")))
#ifdef __clang__
#define SIGNORINI_AVX512 __attribute__((target("avx512f,avx512vl,avx512dq,avx512bw,avx2,fma")))
#else
#define SIGNORINI_AVX512                                                                           \
  __attribute__((target("avx512f,avx512vl,avx512dq,avx512bw,avx2,fma,prefer-vector-width=512")))
#endif
#endif

namespace Signorini
{
/** A vector of @p width numbers, which may lie in an array of such numbers. */
template <typename Number, int width>
struct Wide
{
  typedef Number Type __attribute__((vector_size(width * sizeof(Number)), may_alias));
};

/** The values of a batch, [dof][lane]. */
template <int dim, typename Number>
struct alignas(64) BatchValues
{
  Number values[dim << dim][n_lanes];
};

/** Returns the place of the component (c, d) of a strain in Voigt's notation: those on the
 * diagonal, then 12, 13, 23. */
template <int dim>
constexpr int voigt(const int c, const int d)
{
  return c == d ? c : dim + c + d - 1;
}

constexpr int lower(const int i, const int j)
{
  return i >= j ? i * (i + 1) / 2 + j : j * (j + 1) / 2 + i;
}

/** Computes the inverse of J and its determinant. */
template <typename V>
SIGNORINI_INLINE void invert(const V (&J)[2][2], V (&inverse)[2][2], V &determinant)
{
  determinant = J[0][0] * J[1][1] - J[0][1] * J[1][0];
  const V factor = 1. / determinant;
  inverse[0][0] = J[1][1] * factor;
  inverse[0][1] = -J[0][1] * factor;
  inverse[1][0] = -J[1][0] * factor;
  inverse[1][1] = J[0][0] * factor;
}
template <typename V>
SIGNORINI_INLINE void invert(const V (&J)[3][3], V (&inverse)[3][3], V &determinant)
{
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
    {
      const int a = (j + 1) % 3, b = (j + 2) % 3, c = (i + 1) % 3, d = (i + 2) % 3;
      inverse[i][j] = J[a][c] * J[b][d] - J[a][d] * J[b][c];
    }
  determinant = J[0][0] * inverse[0][0] + J[0][1] * inverse[1][0] + J[0][2] * inverse[2][0];
  const V factor = 1. / determinant;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      inverse[i][j] *= factor;
}

/** Computes the derivatives with respect to reference coordinates: D[c][e] = sum over the vertices
 * of values times derivatives of their shape functions. */
template <int dim, typename Number, typename V>
SIGNORINI_INLINE void reference_gradients(V (&D)[dim][dim],
                                          const BatchValues<dim, Number> &values,
                                          const Number *const gradients,
                                          const unsigned int lane)
{
#pragma GCC unroll 3
  for (int c = 0; c < dim; ++c)
#pragma GCC unroll 3
    for (int e = 0; e < dim; ++e)
      D[c][e] = V{};
#pragma GCC unroll 8
  for (int v = 0; v < (1 << dim); ++v)
#pragma GCC unroll 3
    for (int c = 0; c < dim; ++c)
    {
      const V value = *reinterpret_cast<const V *>(&values.values[v * dim + c][lane]);
#pragma GCC unroll 3
      for (int e = 0; e < dim; ++e)
        D[c][e] += gradients[v * dim + e] * value;
    }
}

/** Computes S = weight E:ε(G), which is symmetric. */
template <int dim, typename Number, typename V>
SIGNORINI_INLINE void
stress(V (&S)[dim][dim], const V (&G)[dim][dim], const Number *const moduli, const V &weight)
{
  constexpr int n_strains = dim * (dim + 1) / 2;
  V strain[n_strains];
#pragma GCC unroll 3
  for (int c = 0; c < dim; ++c)
#pragma GCC unroll 3
    for (int d = 0; d <= c; ++d)
      strain[voigt<dim>(c, d)] = (c == d ? G[c][c] : G[c][d] + G[d][c]) * weight;
#pragma GCC unroll 3
  for (int c = 0; c < dim; ++c)
#pragma GCC unroll 3
    for (int d = 0; d <= c; ++d)
    {
      V sum = V{};
#pragma GCC unroll 6
      for (int s = 0; s < n_strains; ++s)
        sum += moduli[lower(voigt<dim>(c, d), s)] * strain[s];
      S[c][d] = S[d][c] = sum;
    }
}

/** Computes y = sum over points of Bᵀ E B x, with the positions of the vertices of a batch. */
template <int dim, typename Number, int width>
SIGNORINI_INLINE void multiply_integrated(BatchValues<dim, Number> &y,
                                          const PointRule<dim, Number> &rule,
                                          const BatchValues<dim, Number> &vertices,
                                          const BatchValues<dim, Number> &x)
{
  using V = typename Wide<Number, width>::Type;
  constexpr int n_vertices = 1 << dim;
  const std::size_t n_points = rule.weights.size();
  const Number *const moduli = rule.moduli.data();
  for (unsigned int lane = 0; lane < n_lanes; lane += width)
  {
    for (int i = 0; i < dim * n_vertices; ++i)
      *reinterpret_cast<V *>(&y.values[i][lane]) = V{};
    for (std::size_t q = 0; q < n_points; ++q)
    {
      const Number *const gradients = &rule.gradients[q * dim * n_vertices];
      V J[dim][dim], inverse[dim][dim], D[dim][dim], G[dim][dim], S[dim][dim], weight;
      reference_gradients<dim, Number, V>(J, vertices, gradients, lane);
      invert(J, inverse, weight);
      weight *= rule.weights[q];
      reference_gradients<dim, Number, V>(D, x, gradients, lane);
#pragma GCC unroll 3
      for (int c = 0; c < dim; ++c)
#pragma GCC unroll 3
        for (int d = 0; d < dim; ++d)
        {
          G[c][d] = D[c][0] * inverse[0][d];
#pragma GCC unroll 3
          for (int e = 1; e < dim; ++e)
            G[c][d] += D[c][e] * inverse[e][d];
        }
      stress<dim, Number, V>(S, G, moduli, weight);
#pragma GCC unroll 3
      for (int c = 0; c < dim; ++c)
#pragma GCC unroll 3
        for (int e = 0; e < dim; ++e)
        {
          D[c][e] = S[c][0] * inverse[e][0];
#pragma GCC unroll 3
          for (int d = 1; d < dim; ++d)
            D[c][e] += S[c][d] * inverse[e][d];
        }
#pragma GCC unroll 8
      for (int v = 0; v < n_vertices; ++v)
#pragma GCC unroll 3
        for (int c = 0; c < dim; ++c)
        {
          V &sum = *reinterpret_cast<V *>(&y.values[v * dim + c][lane]);
#pragma GCC unroll 3
          for (int e = 0; e < dim; ++e)
            sum += gradients[v * dim + e] * D[c][e];
        }
    }
  }
}
} // namespace Signorini
