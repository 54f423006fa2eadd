// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/instructions.h>
#include <signorini/solvers/stiffness/cell_operator.h>

#include <cstring>

namespace Signorini {
/** A vector that fills a register of @p bytes. */
template <typename Number, int bytes>
struct Wide {
  typedef Number Type __attribute__((vector_size(bytes)));
};

/** Returns the vector that begins at a number. */
template <typename V, typename Number>
SIGNORINI_INLINE inline V load(const Number &first) {
  V values;
  std::memcpy(&values, &first, sizeof(V));
  return values;
}

template <typename V, typename Number>
SIGNORINI_INLINE inline void store(Number &first, const V &values) {
  std::memcpy(&first, &values, sizeof(V));
}

/** The values of a batch, [dof][lane]. */
template <int dim, typename Number>
struct alignas(64) BatchValues {
  Number values[dim << dim][n_lanes];
};

/** Returns the index of the component (c, d) of a strain in Voigt's notation: those on the
 * diagonal, then 12, 13, 23. */
template <int dim>
constexpr int voigt(const int c, const int d) {
  return c == d ? c : dim + c + d - 1;
}

constexpr int lower(const int i, const int j) {
  return i >= j ? i * (i + 1) / 2 + j : j * (j + 1) / 2 + i;
}

/** Computes the inverse of J by cofactors, and its determinant. */
template <int dim, typename V>
SIGNORINI_INLINE inline void invert(const V (&J)[dim][dim], V (&inverse)[dim][dim],
                                    V &determinant) {
  for (int i = 0; i < dim; ++i)
    for (int j = 0; j < dim; ++j)
      if constexpr (dim == 2)
        inverse[i][j] = i == j ? J[1 - j][1 - i] : -J[i][j];
      else {
        const int a = (j + 1) % 3, b = (j + 2) % 3, c = (i + 1) % 3, d = (i + 2) % 3;
        inverse[i][j] = J[a][c] * J[b][d] - J[a][d] * J[b][c];
      }
  determinant = J[0][0] * inverse[0][0];
  for (int j = 1; j < dim; ++j)
    determinant += J[0][j] * inverse[j][0];
  const V factor = 1. / determinant;
  for (int i = 0; i < dim; ++i)
    for (int j = 0; j < dim; ++j)
      inverse[i][j] *= factor;
}

/** Computes the gradients of the shape functions at a point, and the weight times the determinant.
 * @param reference their derivatives on the reference cell. */
template <int dim, typename Number, typename V>
SIGNORINI_INLINE inline void map_gradients(V (&g)[1 << dim][dim], V &weight,
                                           const BatchValues<dim, Number> &vertices,
                                           const Number *const reference, const unsigned int lane) {
  V J[dim][dim] = {}, inverse[dim][dim];
#pragma GCC unroll 8
  for (int v = 0; v < (1 << dim); ++v)
#pragma GCC unroll 3
    for (int c = 0; c < dim; ++c)
#pragma GCC unroll 3
      for (int e = 0; e < dim; ++e)
        J[c][e] += reference[v * dim + e] * load<V>(vertices.values[v * dim + c][lane]);
  invert<dim>(J, inverse, weight);
#pragma GCC unroll 8
  for (int v = 0; v < (1 << dim); ++v)
#pragma GCC unroll 3
    for (int d = 0; d < dim; ++d) {
      g[v][d] = inverse[0][d] * reference[v * dim];
#pragma GCC unroll 3
      for (int e = 1; e < dim; ++e)
        g[v][d] += inverse[e][d] * reference[v * dim + e];
    }
}

/** Computes S = weight E:ε(G), which is symmetric. */
template <int dim, typename Number, typename V>
SIGNORINI_INLINE inline void stress(V (&S)[dim][dim], const V (&G)[dim][dim],
                                    const Number *const moduli, const V &weight) {
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
    for (int d = 0; d <= c; ++d) {
      V sum = V{};
#pragma GCC unroll 6
      for (int s = 0; s < n_strains; ++s)
        sum += load<V>(moduli[lower(voigt<dim>(c, d), s) * n_lanes]) * strain[s];
      S[c][d] = S[d][c] = sum;
    }
}

/** Computes y = Σ Bᵀ E B x over the points, with the positions of the vertices of a batch. */
template <int dim, typename Number, typename V>
SIGNORINI_INLINE inline void multiply_integrated(BatchValues<dim, Number> &y,
                                                 const PointRule<dim, Number> &rule,
                                                 const Number *const moduli,
                                                 const BatchValues<dim, Number> &vertices,
                                                 const BatchValues<dim, Number> &x) {
  constexpr int n_vertices = 1 << dim;
  y = {};
  for (unsigned int lane = 0; lane < n_lanes; lane += sizeof(V) / sizeof(Number))
    for (std::size_t q = 0; q < rule.weights.size(); ++q) {
      V g[n_vertices][dim], G[dim][dim] = {}, S[dim][dim], weight;
      map_gradients<dim>(g, weight, vertices, &rule.gradients[q * dim * n_vertices], lane);
      weight *= rule.weights[q];
#pragma GCC unroll 8
      for (int v = 0; v < n_vertices; ++v)
#pragma GCC unroll 3
        for (int c = 0; c < dim; ++c)
#pragma GCC unroll 3
          for (int d = 0; d < dim; ++d)
            G[c][d] += load<V>(x.values[v * dim + c][lane]) * g[v][d];
      stress<dim>(S, G, moduli + lane, weight);
#pragma GCC unroll 8
      for (int v = 0; v < n_vertices; ++v)
#pragma GCC unroll 3
        for (int c = 0; c < dim; ++c) {
          V sum = load<V>(y.values[v * dim + c][lane]);
#pragma GCC unroll 3
          for (int d = 0; d < dim; ++d)
            sum += S[c][d] * g[v][d];
          store(y.values[v * dim + c][lane], sum);
        }
    }
}

/** Adds Σ Bᵀ E B over the points to the lower triangles K of a batch, [entry][lane]. */
template <int dim, typename Number, typename V>
SIGNORINI_INLINE inline void integrate_matrices(Number *const K, const PointRule<dim, Number> &rule,
                                                const Number *const moduli,
                                                const std::size_t stride,
                                                const BatchValues<dim, Number> &vertices) {
  constexpr int n_vertices = 1 << dim;
  for (unsigned int lane = 0; lane < n_lanes; lane += sizeof(V) / sizeof(Number))
    for (std::size_t q = 0; q < rule.weights.size(); ++q) {
      V g[n_vertices][dim], weight;
      map_gradients<dim>(g, weight, vertices, &rule.gradients[q * dim * n_vertices], lane);
      weight *= rule.weights[q];
      for (int i = 0; i < dim * n_vertices; ++i) {
        V G[dim][dim] = {}, S[dim][dim];
        for (int e = 0; e < dim; ++e)
          G[i % dim][e] = g[i / dim][e];
        stress<dim>(S, G, moduli + q * stride + lane, weight);
        for (int j = 0; j <= i; ++j) {
          V entry = load<V>(K[lower(i, j) * n_lanes + lane]);
          for (int e = 0; e < dim; ++e)
            entry += S[j % dim][e] * g[j / dim][e];
          store(K[lower(i, j) * n_lanes + lane], entry);
        }
      }
    }
}
} // namespace Signorini
