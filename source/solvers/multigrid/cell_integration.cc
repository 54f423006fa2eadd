// SPDX-License-Identifier: LGPL-2.1-or-later
// Stiffness matrices of general cells, several at a time, for several instruction sets.

#include <signorini/solvers/multigrid/cell_integration.h>
#include <signorini/solvers/multigrid/kernels.h>

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/quadrature_lib.h>

#include <cstring>

#include "point_kernel.h"

namespace Signorini
{
namespace
{
/** One point of a batch of cells. */
template <int dim, typename Number>
struct PointOfCells
{
  /** The positions of the vertices, [vertex dim + component][lane]. */
  const Number (*vertices)[n_lanes];
  /** The derivatives of the shape functions on the reference cell. */
  const Number *gradients;
  Number weight;
  /** The moduli, [modulus][lane]. */
  const Number (*moduli)[n_lanes];
};

/** Computes the gradients of the shape functions, and the weight times the determinant. */
template <int dim, typename Number, typename V>
SIGNORINI_INLINE void map_gradients(V (&g)[1 << dim][dim],
                                    V &weight,
                                    const PointOfCells<dim, Number> &point,
                                    const unsigned int lane)
{
  V J[dim][dim], inverse[dim][dim];
  for (int d = 0; d < dim; ++d)
    for (int e = 0; e < dim; ++e)
    {
      J[d][e] = V{};
      for (int v = 0; v < (1 << dim); ++v)
      {
        V x;
        std::memcpy(&x, &point.vertices[v * dim + d][lane], sizeof(V));
        J[d][e] += x * point.gradients[v * dim + e];
      }
    }
  invert(J, inverse, weight);
  weight *= point.weight;
  for (int v = 0; v < (1 << dim); ++v)
    for (int d = 0; d < dim; ++d)
    {
      g[v][d] = V{};
      for (int e = 0; e < dim; ++e)
        g[v][d] += inverse[e][d] * point.gradients[v * dim + e];
    }
}

/** Adds Bᵀ C B times the weight of the point to K, for all cells of a batch; C are the moduli. */
template <int dim, typename Number, int bytes>
SIGNORINI_INLINE void add_point(Number *const K, const PointOfCells<dim, Number> &point)
{
  constexpr int width = bytes / static_cast<int>(sizeof(Number));
  using V = typename Wide<Number, width>::Type;
  constexpr int n_strains = dim * (dim + 1) / 2;
  for (unsigned int lane = 0; lane < n_lanes; lane += width)
  {
    V g[1 << dim][dim], weight;
    map_gradients<dim, Number, V>(g, weight, point, lane);
    V C[n_strains][n_strains];
    for (int s = 0; s < n_strains; ++s)
      for (int t = 0; t < n_strains; ++t)
      {
        std::memcpy(&C[s][t], &point.moduli[lower(s, t)][lane], sizeof(V));
        C[s][t] *= weight;
      }
    for (int w = 0; w < (1 << dim); ++w)
    {
      // Stresses of the shape functions of a vertex.
      V S[n_strains][dim];
      for (int s = 0; s < n_strains; ++s)
        for (int d = 0; d < dim; ++d)
        {
          S[s][d] = C[s][d] * g[w][d];
          for (int e = 0; e < dim; ++e)
            if (e != d)
              S[s][d] += C[s][voigt<dim>(d, e)] * g[w][e];
        }
      for (int v = 0; v <= w; ++v)
        for (int d = 0; d < dim; ++d)
          for (int c = 0; c < (v == w ? d + 1 : dim); ++c)
          {
            Number *const target = K + lower(w * dim + d, v * dim + c) * n_lanes + lane;
            V sum;
            std::memcpy(&sum, target, sizeof(V));
            for (int e = 0; e < dim; ++e)
              sum += S[voigt<dim>(c, e)][d] * g[v][e];
            std::memcpy(target, &sum, sizeof(V));
          }
    }
  }
}

template <int dim, typename Number>
void add_point_basic(Number *const K, const PointOfCells<dim, Number> &point)
{
  add_point<dim, Number, 16>(K, point);
}
#ifdef __x86_64__
template <int dim, typename Number>
SIGNORINI_AVX2 void add_point_avx2(Number *const K, const PointOfCells<dim, Number> &point)
{
  add_point<dim, Number, 32>(K, point);
}
template <int dim, typename Number>
SIGNORINI_AVX512 void add_point_avx512(Number *const K, const PointOfCells<dim, Number> &point)
{
  add_point<dim, Number, 64>(K, point);
}
#endif

template <int dim, typename Number>
void (*best_add_point())(Number *, const PointOfCells<dim, Number> &)
{
#ifdef __x86_64__
  switch (instructions_of_this_machine())
  {
  case Instructions::avx512:
    return &add_point_avx512<dim, Number>;
  case Instructions::avx2:
    return &add_point_avx2<dim, Number>;
  case Instructions::basic:
    break;
  }
#endif
  return &add_point_basic<dim, Number>;
}
} // namespace

template <int dim>
CellIntegration<dim>::CellIntegration(const Mesh<dim> &mesh, const Material<dim> &material)
  : mesh_(mesh)
  , material_(material)
{
  const QGauss<dim> gauss(4);
  using Info = GeometryInfo<dim>;
  for (unsigned int q = 0; q < gauss.size(); ++q)
  {
    Point point;
    point.weight = gauss.weight(q);
    for (unsigned int v = 0; v < n_vertices; ++v)
    {
      point.values[v] = Info::d_linear_shape_function(gauss.point(q), v);
      const auto gradient = Info::d_linear_shape_function_gradient(gauss.point(q), v);
      for (unsigned int d = 0; d < dim; ++d)
        point.gradients[v * dim + d] = gradient[d];
    }
    points_.push_back(point);
  }
}

template <int dim>
std::array<double, CellIntegration<dim>::n_moduli>
CellIntegration<dim>::moduli(const dealii::Point<dim> &x) const
{
  const SymmetricTensor<4, dim> hooke = material_.relative_hooke(mesh_.from_unit_body(x));
  std::array<double, n_moduli> result;
  for (int c = 0; c < dim; ++c)
    for (int d = 0; d <= c; ++d)
      for (int e = 0; e < dim; ++e)
        for (int f = 0; f <= e; ++f)
          if (voigt<dim>(c, d) >= voigt<dim>(e, f))
            result[lower(voigt<dim>(c, d), voigt<dim>(e, f))] = hooke[c][d][e][f];
  return result;
}

template <int dim>
void CellIntegration<dim>::moduli_of_batch(double (*const result)[n_lanes],
                                           const Point &point,
                                           const double (*const vertices)[n_lanes]) const
{
  for (unsigned int l = 0; l < n_lanes; ++l)
  {
    dealii::Point<dim> x;
    for (unsigned int v = 0; v < n_vertices; ++v)
      for (unsigned int d = 0; d < dim; ++d)
        x[d] += point.values[v] * vertices[v * dim + d][l];
    const auto found = moduli(x);
    for (unsigned int m = 0; m < n_moduli; ++m)
      result[m][l] = found[m];
  }
}

template <int dim>
void CellIntegration<dim>::integrate(CellMatrices<dim, double> &matrices,
                                     const BlockGrid<dim> &grid,
                                     const NodePlaces<dim> &places) const
{
  const auto add_point = best_add_point<dim, double>();
  const bool is_constant = material_.is_constant();
  alignas(64) double vertices[n_vertices * dim][n_lanes], moduli[n_moduli][n_lanes];
  for (std::size_t batch = 0; batch < grid.n_batches(); ++batch)
  {
    if (matrices.is_shared(batch))
      continue;
    for (unsigned int l = 0; l < n_lanes; ++l)
    {
      const auto nodes = grid.nodes(std::min(batch * n_lanes + l, grid.n_cells() - 1));
      for (unsigned int v = 0; v < n_vertices; ++v)
        for (unsigned int d = 0; d < dim; ++d)
          vertices[v * dim + d][l] = places[d][nodes[v]];
    }
    double *const K = matrices.stored_matrices(batch);
    for (std::size_t q = 0; q < points_.size(); ++q)
    {
      if (!is_constant || q == 0)
        moduli_of_batch(moduli, points_[q], vertices);
      add_point(K, {vertices, points_[q].gradients.data(), points_[q].weight, moduli});
    }
  }
}

template <int dim, typename Number>
const Number *entries_of_batch(const CellMatrices<dim, Number> &matrices,
                               const BlockGrid<dim> &grid,
                               const std::size_t batch,
                               std::vector<Number> &buffer)
{
  using Matrices = CellMatrices<dim, Number>;
  constexpr unsigned int n_dofs = Matrices::n_dofs;
  if (!matrices.is_shared(batch) && !matrices.is_integrated(batch))
    return matrices.stored_matrices(batch);
  buffer.assign(Matrices::batch_size, Number());
  if (matrices.is_shared(batch))
  {
    for (unsigned int i = 0; i < n_dofs; ++i)
      for (unsigned int j = 0; j <= i; ++j)
        std::fill_n(&buffer[Matrices::entry(i, j) * n_lanes],
                    n_lanes,
                    matrices.shared_matrix(batch)[i * n_dofs + j]);
    return buffer.data();
  }
  const PointRule<dim, Number> &rule = *matrices.rule;
  BatchValues<dim, Number> vertices;
  for (unsigned int l = 0; l < n_lanes; ++l)
  {
    const auto nodes = grid.nodes(std::min(batch * n_lanes + l, grid.n_cells() - 1));
    for (unsigned int v = 0; v < nodes.size(); ++v)
      for (int d = 0; d < dim; ++d)
        vertices.values[v * dim + d][l] = rule.places[d][nodes[v]];
  }
  Number moduli[std::tuple_size<decltype(rule.moduli)>::value][n_lanes];
  for (std::size_t m = 0; m < rule.moduli.size(); ++m)
    std::fill_n(moduli[m], n_lanes, rule.moduli[m]);
  const auto add_point = best_add_point<dim, Number>();
  for (std::size_t q = 0; q < rule.weights.size(); ++q)
    add_point(buffer.data(),
              {vertices.values, &rule.gradients[q * n_dofs], rule.weights[q], moduli});
  return buffer.data();
}

template <int dim, typename Number>
void add_diagonal_blocks(LevelVector<dim * dim, Number> &blocks,
                         const BlockGrid<dim> &grid,
                         const CellMatrices<dim, Number> &matrices)
{
  using Matrices = CellMatrices<dim, Number>;
  std::vector<Number> buffer;
  const Number *K = nullptr;
  int last_shared = -1;
  for (std::size_t cell = 0; cell < grid.n_cells(); ++cell)
  {
    const std::size_t batch = cell / n_lanes;
    const int shared = matrices.batch_storage[batch];
    if (cell % n_lanes == 0 && (shared < 0 || shared != last_shared))
    {
      K = entries_of_batch(matrices, grid, batch, buffer);
      last_shared = shared;
    }
    const auto nodes = grid.nodes(cell);
    for (unsigned int v = 0; v < nodes.size(); ++v)
      for (unsigned int c = 0; c < dim; ++c)
        for (unsigned int d = 0; d < dim; ++d)
          blocks[dim * c + d][nodes[v]] +=
            K[Matrices::entry(v * dim + c, v * dim + d) * n_lanes + cell % n_lanes];
  }
}

template <int dim, typename Number>
std::shared_ptr<const PointRule<dim, Number>>
make_point_rule(const NodePlaces<dim> &places,
                const unsigned int n_nodes,
                const std::array<double, PointRule<dim, Number>::n_moduli> &moduli,
                const unsigned int n_points)
{
  const auto rule = std::make_shared<PointRule<dim, Number>>(
    PointRule<dim, Number>{LevelVector<dim, Number>(n_nodes), {}, {}, {}});
  for (int d = 0; d < dim; ++d)
    for (unsigned int node = 0; node < n_nodes; ++node)
      rule->places[d][node] = static_cast<Number>(places[d][node]);
  std::copy(moduli.begin(), moduli.end(), rule->moduli.begin());
  const QGauss<dim> gauss(n_points);
  for (unsigned int q = 0; q < gauss.size(); ++q)
  {
    rule->weights.push_back(static_cast<Number>(gauss.weight(q)));
    for (unsigned int v = 0; v < (1U << dim); ++v)
    {
      const auto gradient = GeometryInfo<dim>::d_linear_shape_function_gradient(gauss.point(q), v);
      for (unsigned int d = 0; d < dim; ++d)
        rule->gradients.push_back(static_cast<Number>(gradient[d]));
    }
  }
  return rule;
}

template const float *entries_of_batch(const CellMatrices<2, float> &,
                                       const BlockGrid<2> &,
                                       std::size_t,
                                       std::vector<float> &);
template void add_diagonal_blocks<2, float>(LevelVector<4, float> &,
                                            const BlockGrid<2> &,
                                            const CellMatrices<2, float> &);
template std::shared_ptr<const PointRule<2, float>>
make_point_rule<2, float>(const NodePlaces<2> &,
                          unsigned int,
                          const std::array<double, PointRule<2, float>::n_moduli> &,
                          unsigned int);
template const double *entries_of_batch(const CellMatrices<2, double> &,
                                        const BlockGrid<2> &,
                                        std::size_t,
                                        std::vector<double> &);
template void add_diagonal_blocks<2, double>(LevelVector<4, double> &,
                                             const BlockGrid<2> &,
                                             const CellMatrices<2, double> &);
template std::shared_ptr<const PointRule<2, double>>
make_point_rule<2, double>(const NodePlaces<2> &,
                           unsigned int,
                           const std::array<double, PointRule<2, double>::n_moduli> &,
                           unsigned int);
template const float *entries_of_batch(const CellMatrices<3, float> &,
                                       const BlockGrid<3> &,
                                       std::size_t,
                                       std::vector<float> &);
template void add_diagonal_blocks<3, float>(LevelVector<9, float> &,
                                            const BlockGrid<3> &,
                                            const CellMatrices<3, float> &);
template std::shared_ptr<const PointRule<3, float>>
make_point_rule<3, float>(const NodePlaces<3> &,
                          unsigned int,
                          const std::array<double, PointRule<3, float>::n_moduli> &,
                          unsigned int);
template const double *entries_of_batch(const CellMatrices<3, double> &,
                                        const BlockGrid<3> &,
                                        std::size_t,
                                        std::vector<double> &);
template void add_diagonal_blocks<3, double>(LevelVector<9, double> &,
                                             const BlockGrid<3> &,
                                             const CellMatrices<3, double> &);
template std::shared_ptr<const PointRule<3, double>>
make_point_rule<3, double>(const NodePlaces<3> &,
                           unsigned int,
                           const std::array<double, PointRule<3, double>::n_moduli> &,
                           unsigned int);
template class CellIntegration<2>;
template class CellIntegration<3>;
} // namespace Signorini
