// SPDX-License-Identifier: LGPL-2.1-or-later
// K of a level: K x cell by cell in batches, in vector types of the compiler for several
// instruction sets; the matrices of coarse cells, the diagonal and the smoother.

#include <signorini/base/instantiate.h>
#include <signorini/solvers/stiffness/cell_operator.h>

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/base/tensor.h>

#include <algorithm>
#include <cmath>

#include "point_kernel.h"

namespace Signorini {
namespace {
/** Loads the values at the vertices of a batch. */
template <int dim, typename Number>
SIGNORINI_INLINE inline void load_batch(BatchValues<dim, Number> &values,
                                        const LevelVector<dim, Number> &x,
                                        const BlockGrid<dim> &grid, const std::size_t batch) {
  constexpr unsigned int n_vertices = 1U << dim;
  for (unsigned int v = 0; v < n_vertices; ++v) {
    const NodeNumber start = grid.starts[batch * n_vertices + v];
    for (unsigned int c = 0; c < dim; ++c) {
      Number *const target = values.values[dim * v + c];
      const Number *const source = x[c].data();
      if ((start & BlockGrid<dim>::list_bit) == 0)
        std::memcpy(target, source + start, n_lanes * sizeof(Number));
      else
        for (unsigned int l = 0; l < n_lanes; ++l)
          target[l] = source[grid.lists[start & ~BlockGrid<dim>::list_bit][l]];
    }
  }
}

/** Adds values to y at the vertices of a batch: the transpose of load_batch(). */
template <int dim, typename V, typename Number>
SIGNORINI_INLINE inline void add_batch(LevelVector<dim, Number> &y,
                                       const BatchValues<dim, Number> &values,
                                       const BlockGrid<dim> &grid, const std::size_t batch) {
  constexpr unsigned int n_vertices = 1U << dim;
  const std::size_t n_cells = std::min<std::size_t>(n_lanes, grid.n_cells - batch * n_lanes);
  // Rows overlap at neighbouring vertices, which do not follow each other.
  for (const unsigned int first : {0U, 1U})
    for (unsigned int v = first; v < n_vertices; v += 2) {
      const NodeNumber start = grid.starts[batch * n_vertices + v];
      for (unsigned int c = 0; c < dim; ++c) {
        const Number *const source = values.values[dim * v + c];
        Number *const target = y[c].data();
        if ((start & BlockGrid<dim>::list_bit) == 0)
          for (unsigned int l = 0; l < n_lanes; l += sizeof(V) / sizeof(Number))
            store(target[start + l], load<V>(target[start + l]) + load<V>(source[l]));
        else
          for (std::size_t l = 0; l < n_cells; ++l)
            target[grid.lists[start & ~BlockGrid<dim>::list_bit][l]] += source[l];
      }
    }
}

/** Computes y = K x with one K for all lanes.
 * @tparam n_sums the number of sums that registers hold. */
template <int dim, typename V, int n_sums, typename Number>
SIGNORINI_INLINE inline void multiply_shared(BatchValues<dim, Number> &y, const Number *const K,
                                             const BatchValues<dim, Number> &x) {
  constexpr int n_dofs = dim << dim;
  for (unsigned int l = 0; l < n_lanes; l += sizeof(V) / sizeof(Number))
    for (int begin = 0; begin < n_dofs; begin += n_sums) {
      V sums[n_sums] = {};
      for (int j = 0; j < n_dofs; ++j) {
        const V x_j = load<V>(x.values[j][l]);
#pragma GCC unroll 24
        for (int i = 0; i < n_sums; ++i)
          sums[i] += K[j * n_dofs + begin + i] * x_j;
      }
#pragma GCC unroll 24
      for (int i = 0; i < n_sums; ++i)
        store(y.values[begin + i][l], sums[i]);
    }
}

/** Computes y = K x with one K for each lane, [entry][lane]. */
template <int dim, typename V, typename Number>
SIGNORINI_INLINE inline void multiply_stored(BatchValues<dim, Number> &y, const Number *const K,
                                             const BatchValues<dim, Number> &x) {
  constexpr int n_dofs = dim << dim;
  for (unsigned int l = 0; l < n_lanes; l += sizeof(V) / sizeof(Number)) {
    const Number *entry = K + l;
    V sums[n_dofs];
    for (int i = 0; i < n_dofs; ++i) {
      const V x_i = load<V>(x.values[i][l]);
      V sum = V{};
      for (int j = 0; j < i; ++j, entry += n_lanes) {
        const V K_ij = load<V>(*entry);
        sum += K_ij * load<V>(x.values[j][l]);
        sums[j] += K_ij * x_i;
      }
      sums[i] = sum + load<V>(*entry) * x_i;
      entry += n_lanes;
    }
    for (int i = 0; i < n_dofs; ++i)
      store(y.values[i][l], sums[i]);
  }
}

template <int dim, typename Number, int bytes>
SIGNORINI_INLINE inline void multiply_batches(LevelVector<dim, Number> &y,
                                              const LevelVector<dim, Number> &x,
                                              const CellOperator<dim, Number> &K) {
  using V = typename Wide<Number, bytes>::Type;
  constexpr int n_sums = dim == 2 ? 8 : bytes == 64 ? 24 : 12;
  const BlockGrid<dim> &grid = *K.grid;
  BatchValues<dim, Number> x_batch, y_batch, vertices;
  for (std::size_t batch = 0; batch < grid.n_batches(); ++batch) {
    load_batch(x_batch, x, grid, batch);
    if (K.is_shared(batch))
      multiply_shared<dim, V, n_sums>(y_batch, K.shared_matrix(batch), x_batch);
    else if (K.moduli.empty())
      multiply_stored<dim, V>(y_batch, K.stored_matrices(batch), x_batch);
    else {
      load_batch(vertices, K.positions, grid, batch);
      multiply_integrated<dim, Number, V>(y_batch, K.rule, K.moduli.data(), vertices, x_batch);
    }
    add_batch<dim, V>(y, y_batch, grid, batch);
  }
}
} // namespace

template <int dim, typename Number>
PointRule<dim, Number>::PointRule(const unsigned int n_points_per_direction) {
  const QGauss<dim> gauss(n_points_per_direction);
  weights.assign(gauss.get_weights().begin(), gauss.get_weights().end());
  for (const Point<dim> &point : gauss.get_points())
    for (unsigned int v = 0; v < (1U << dim); ++v) {
      const Tensor<1, dim> gradient = GeometryInfo<dim>::d_linear_shape_function_gradient(point, v);
      gradients.insert(gradients.end(), gradient.begin_raw(), gradient.end_raw());
    }
}

template <int dim, typename Number>
template <typename Other>
CellOperator<dim, Number>::CellOperator(const CellOperator<dim, Other> &other,
                                        const unsigned int n_points)
  : grid(other.grid)
  , storage(other.storage)
  , shared(other.shared.begin(), other.shared.end())
  , stored(other.stored.begin(), other.stored.end())
  , rule(n_points)
  , moduli(other.moduli.begin(), other.moduli.end()) {
  for (int d = 0; d < dim; ++d) {
    positions[d].resize(other.positions[d].size());
    std::copy(other.positions[d].begin(), other.positions[d].end(), positions[d].begin());
  }
}

template <int dim, typename Number>
void CellOperator<dim, Number>::multiply(LevelVector<dim, Number> &y,
                                         const LevelVector<dim, Number> &x,
                                         const Instructions instructions) const {
  for (AlignedVector<Number> &component : y)
    std::fill(component.begin(), component.end(), Number());
  run(instructions, [&](const auto bytes)
                      SIGNORINI_INLINE { multiply_batches<dim, Number, bytes>(y, x, *this); });
}

template <int dim, typename Number>
void CellOperator<dim, Number>::integrate(Number *const K, const std::size_t batch,
                                          const Number *const point_moduli,
                                          const std::size_t stride) const {
  BatchValues<dim, Number> vertices;
  load_batch(vertices, positions, *grid, batch);
  run(instructions_of_this_machine(), [&](const auto bytes) SIGNORINI_INLINE {
    integrate_matrices<dim, Number, typename Wide<Number, bytes>::Type>(K, rule, point_moduli,
                                                                        stride, vertices);
  });
}

template <int dim, typename Number>
const Number *CellOperator<dim, Number>::entries(const std::size_t batch,
                                                 std::vector<Number> &buffer) const {
  if (!is_shared(batch) && moduli.empty())
    return stored_matrices(batch);
  buffer.assign(batch_size, Number());
  if (!is_shared(batch))
    integrate(buffer.data(), batch, moduli.data(), 0);
  else
    for (unsigned int i = 0; i < n_dofs; ++i)
      for (unsigned int j = 0; j <= i; ++j)
        std::fill_n(&buffer[lower(i, j) * n_lanes], n_lanes, shared_matrix(batch)[i * n_dofs + j]);
  return buffer.data();
}

template <int dim, typename Number>
void CellOperator<dim, Number>::store_matrices() {
  int n_stored = 0;
  for (int &matrices : storage)
    if (matrices < 0)
      matrices = -1 - n_stored++;
  stored.resize(n_stored * batch_size);
}

namespace {
/** The matrices of n_lanes cells, [i][j][lane]. */
template <int dim>
using BatchMatrices = std::array<std::array<std::array<double, n_lanes>, dim << dim>, dim << dim>;

/** Returns the value of the parent's shape function V at vertex v of a child. */
template <int dim>
double parent_shape(const unsigned int child, const unsigned int v, const unsigned int V) {
  Point<dim> position;
  for (int d = 0; d < dim; ++d)
    position[d] = 0.5 * (((child >> d) & 1U) + ((v >> d) & 1U));
  return GeometryInfo<dim>::d_linear_shape_function(position, V);
}

/** Adds Pᵀ K_child P to K. */
template <int dim>
void add_child(const unsigned int child, const BatchMatrices<dim> &K_child, BatchMatrices<dim> &K) {
  constexpr unsigned int n_vertices = 1U << dim, n_dofs = dim << dim;
  // half = Pᵀ K_child, then K = half P.
  BatchMatrices<dim> half = {};
  for (const bool second : {false, true})
    for (unsigned int V = 0; V < n_vertices; ++V)
      for (unsigned int v = 0; v < n_vertices; ++v)
        if (const double weight = parent_shape<dim>(child, v, V); weight != 0.)
          for (unsigned int c = 0; c < dim; ++c)
            for (unsigned int i = 0; i < n_dofs; ++i) {
              auto &target = second ? K[i][V * dim + c] : half[V * dim + c][i];
              const auto &source = second ? half[i][v * dim + c] : K_child[v * dim + c][i];
              for (unsigned int l = 0; l < n_lanes; ++l)
                target[l] += weight * source[l];
            }
}

/** Returns the sum over the children of a batch, of which entry(child, lane, i, j) is one entry. */
template <int dim, typename Entry>
BatchMatrices<dim> sum_children(const Entry &entry) {
  constexpr unsigned int n_dofs = dim << dim;
  BatchMatrices<dim> K = {}, K_child;
  for (unsigned int child = 0; child < (1U << dim); ++child) {
    for (unsigned int l = 0; l < n_lanes; ++l)
      for (unsigned int i = 0; i < n_dofs; ++i)
        for (unsigned int j = 0; j < n_dofs; ++j)
          K_child[i][j][l] = entry(child, l, i, j);
    add_child<dim>(child, K_child, K);
  }
  return K;
}
} // namespace

template <int dim, typename Number>
CellOperator<dim, Number>
CellOperator<dim, Number>::coarsen(std::shared_ptr<const BlockGrid<dim>> coarse_grid) const {
  CellOperator coarse(std::move(coarse_grid), 1);
  const BlockGrid<dim> &to = *coarse.grid;
  coarse.rule = rule;
  if (!moduli.empty()) {
    coarse.moduli = moduli;
    coarse.positions = LevelVector<dim, Number>(to.n_nodes());
    for (int d = 0; d < dim; ++d)
      for (NodeNumber node = 0; node < to.n_nodes(); ++node)
        coarse.positions[d][node] = positions[d][to.identities[node]];
  }
  // The parent of cells with a shared matrix has its number.
  for (auto matrix = shared.cbegin(); matrix != shared.cend(); matrix += n_dofs * n_dofs) {
    const BatchMatrices<dim> K =
      sum_children<dim>([&](unsigned int, unsigned int, const unsigned int i,
                            const unsigned int j) { return matrix[i * n_dofs + j]; });
    for (const auto &row : K)
      for (const auto &entry : row)
        coarse.shared.push_back(entry[0]);
  }
  const auto child_cell = [&](const std::size_t batch, const unsigned int l, const unsigned child) {
    return grid->child(std::min(batch * n_lanes + l, to.n_cells - 1), child);
  };
  for (std::size_t batch = 0; batch < to.n_batches(); ++batch) {
    int common = std::max(-1, storage[child_cell(batch, 0, 0) / n_lanes]);
    for (unsigned int l = 0; l < n_lanes && common >= 0; ++l)
      for (unsigned int child = 0; child < (1U << dim); ++child)
        if (storage[child_cell(batch, l, child) / n_lanes] != common)
          common = -1;
    coarse.storage[batch] = common;
  }
  if (!moduli.empty())
    return coarse;
  coarse.store_matrices();
  for (std::size_t batch = 0; batch < to.n_batches(); ++batch)
    if (!coarse.is_shared(batch)) {
      const BatchMatrices<dim> K =
        sum_children<dim>([&](const unsigned int child, const unsigned int l, const unsigned int i,
                              const unsigned int j) {
          const std::size_t cell = child_cell(batch, l, child);
          return is_shared(cell / n_lanes)
                   ? shared_matrix(cell / n_lanes)[i * n_dofs + j]
                   : stored_matrices(cell / n_lanes)[lower(i, j) * n_lanes + cell % n_lanes];
        });
      for (unsigned int i = 0; i < n_dofs; ++i)
        for (unsigned int j = 0; j <= i; ++j)
          std::copy(K[i][j].begin(), K[i][j].end(),
                    coarse.stored_matrices(batch) + lower(i, j) * n_lanes);
    }
  return coarse;
}

template class CellOperator<2, float>;
template class CellOperator<2, double>;
template class CellOperator<3, float>;
template class CellOperator<3, double>;
template CellOperator<2, float>::CellOperator(const CellOperator<2, double> &, unsigned int);
template CellOperator<3, float>::CellOperator(const CellOperator<3, double> &, unsigned int);

template <int dim>
NodeBlocks<dim> diagonal_blocks(const CellOperator<dim, float> &K) {
  const BlockGrid<dim> &grid = *K.grid;
  NodeBlocks<dim> blocks(grid.n_nodes());
  std::vector<float> buffer;
  const float *entries = nullptr;
  for (std::size_t cell = 0; cell < grid.n_cells; ++cell) {
    const std::size_t batch = cell / n_lanes;
    if (cell == 0 ||
        (cell % n_lanes == 0 && (!K.is_shared(batch) || K.storage[batch] != K.storage[batch - 1])))
      entries = K.entries(batch, buffer);
    const auto nodes = grid.nodes(cell);
    for (unsigned int v = 0; v < nodes.size(); ++v)
      for (int c = 0; c < dim; ++c)
        for (int d = 0; d <= c; ++d)
          blocks[voigt<dim>(c, d)][nodes[v]] +=
            entries[lower(v * dim + c, v * dim + d) * n_lanes + cell % n_lanes];
  }
  return blocks;
}

namespace {
/** Returns the largest eigenvalue of n_lanes cells, [entry][lane], see max_cell_eigenvalue(). */
template <int dim>
double max_eigenvalue(const float *const K) {
  constexpr unsigned int n_steps = 40, n_vertices = 1U << dim;
  // The inverses of the diagonal blocks, [vertex][row][column][lane].
  alignas(64) float B[n_vertices][dim][dim][n_lanes], quotients[n_lanes];
  BatchValues<dim, float> x, y;
  for (unsigned int l = 0; l < n_lanes; ++l)
    for (unsigned int v = 0; v < n_vertices; ++v) {
      Tensor<2, dim> block;
      for (int c = 0; c < dim; ++c)
        for (int d = 0; d < dim; ++d)
          block[c][d] = K[lower(v * dim + c, v * dim + d) * n_lanes + l];
      block = invert(block);
      for (int c = 0; c < dim; ++c)
        for (int d = 0; d < dim; ++d)
          B[v][c][d][l] = static_cast<float>(block[c][d]);
      // The vector has no pattern: no eigenvector is orthogonal to it.
      for (unsigned int i = v * dim; i < (v + 1) * dim; ++i)
        y.values[i][l] = static_cast<float>((i * i * 7919 + 104729 * i + 1) % 101) - 47.3F;
    }
  run(instructions_of_this_machine(), [&](const auto bytes) SIGNORINI_INLINE {
    for (unsigned int step = 0; step < n_steps; ++step) {
      // x = B y, divided by (y.B y)^{1/2}; y = K x; the quotient is x.K x.
      float sizes[n_lanes] = {};
      for (unsigned int i = 0; i < n_vertices * dim; ++i)
        for (unsigned int l = 0; l < n_lanes; ++l) {
          float sum = 0.F;
          for (unsigned int d = 0; d < dim; ++d)
            sum += B[i / dim][i % dim][d][l] * y.values[i / dim * dim + d][l];
          x.values[i][l] = sum;
          sizes[l] += sum * y.values[i][l];
        }
      for (float &size : sizes)
        size = 1.F / std::sqrt(size);
      for (auto &values : x.values)
        for (unsigned int l = 0; l < n_lanes; ++l)
          values[l] *= sizes[l];
      multiply_stored<dim, typename Wide<float, bytes>::Type>(y, K, x);
    }
  });
  for (unsigned int l = 0; l < n_lanes; ++l) {
    quotients[l] = 0.F;
    for (unsigned int i = 0; i < n_vertices * dim; ++i)
      quotients[l] += x.values[i][l] * y.values[i][l];
  }
  return *std::max_element(quotients, quotients + n_lanes);
}
} // namespace

template <int dim>
double max_cell_eigenvalue(const CellOperator<dim, float> &K) {
  constexpr double safety = 1.05;
  double largest = 0.;
  std::vector<float> buffer;
  for (std::size_t batch = 0; batch < K.grid->n_batches(); ++batch)
    if (!K.is_shared(batch) || batch == 0 || K.storage[batch] != K.storage[batch - 1])
      largest = std::max(largest, max_eigenvalue<dim>(K.entries(batch, buffer)));
  // Of m blocks no eigenvalue is larger than m.
  return std::min(safety * largest, static_cast<double>(1U << dim));
}

template <int dim>
void SmootherStep<dim>::run(const Instructions instructions) const {
  Signorini::run(instructions, [&](const auto bytes) SIGNORINI_INLINE {
    using V = typename Wide<float, bytes>::Type;
    // The loop takes whole vectors: the entries behind the last node are zero, and stay so.
    for (std::size_t node = 0; node < x[0].size(); node += sizeof(V) / sizeof(float)) {
      V r[dim];
#pragma GCC unroll 3
      for (int c = 0; c < dim; ++c) {
        r[c] = load<V>(b[c][node]);
        if (!is_first)
          r[c] -= load<V>(y[c][node]);
        r[c] *= gamma;
      }
#pragma GCC unroll 3
      for (int c = 0; c < dim; ++c) {
        V change = is_first ? V{} : alpha * load<V>(d[c][node]);
#pragma GCC unroll 3
        for (int e = 0; e < dim; ++e)
          change += load<V>(B[voigt<dim>(c, e)][node]) * r[e];
        store(d[c][node], change);
        store(x[c][node], is_first ? change : load<V>(x[c][node]) + change);
      }
    }
  });
}

INSTANTIATE_FUNCTION(diagonal_blocks);
INSTANTIATE_FUNCTION(max_cell_eigenvalue);
template struct SmootherStep<2>;
template struct SmootherStep<3>;
} // namespace Signorini
