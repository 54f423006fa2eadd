// SPDX-License-Identifier: LGPL-2.1-or-later
// Stiffness matrices of general cells, several at a time, for several instruction sets.

#include "cell_integration.h"

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/quadrature_lib.h>

#include <cstring>

#include "kernels.h"
#include "wide.h"

namespace Signorini
{
namespace
{
/** The place of the component (c, d) of a strain in Voigt's notation: those on the diagonal, then
 * 12, 13, 23. */
template <int dim>
constexpr int voigt(const int c, const int d)
{
  return c == d ? c : dim + c + d - 1;
}

constexpr int lower(const int i, const int j)
{
  return i >= j ? i * (i + 1) / 2 + j : j * (j + 1) / 2 + i;
}

/** One point of a batch of cells. */
template <int dim>
struct PointOfCells
{
  /** [vertex dim + component][lane]. */
  const double (*vertices)[n_lanes];
  /** Of the shape functions on the reference cell. */
  const double *gradients;
  double weight;
  /** [modulus][lane]. */
  const double (*moduli)[n_lanes];
};

/** The inverse of J, and its determinant. */
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

/** Gradients of the shape functions, and the weight times the determinant. */
template <int dim, typename V>
SIGNORINI_INLINE void map_gradients(V (&g)[1 << dim][dim],
                                    V &weight,
                                    const PointOfCells<dim> &point,
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

/** K += B^T C B times the weight of the point, for all cells of a batch. */
template <int dim, int width>
SIGNORINI_INLINE void add_point(double *const K, const PointOfCells<dim> &point)
{
  using V = typename Wide<double, width>::Type;
  constexpr int n_strains = dim * (dim + 1) / 2;
  for (unsigned int lane = 0; lane < n_lanes; lane += width)
  {
    V g[1 << dim][dim], weight;
    map_gradients<dim, V>(g, weight, point, lane);
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
            double *const target = K + lower(w * dim + d, v * dim + c) * n_lanes + lane;
            V sum;
            std::memcpy(&sum, target, sizeof(V));
            for (int e = 0; e < dim; ++e)
              sum += S[voigt<dim>(c, e)][d] * g[v][e];
            std::memcpy(target, &sum, sizeof(V));
          }
    }
  }
}

template <int dim>
void add_point_basic(double *const K, const PointOfCells<dim> &point)
{
  add_point<dim, 2>(K, point);
}
#ifdef __x86_64__
template <int dim>
SIGNORINI_AVX2 void add_point_avx2(double *const K, const PointOfCells<dim> &point)
{
  add_point<dim, 4>(K, point);
}
template <int dim>
SIGNORINI_AVX512 void add_point_avx512(double *const K, const PointOfCells<dim> &point)
{
  add_point<dim, 8>(K, point);
}
#endif

template <int dim>
void (*best_add_point())(double *, const PointOfCells<dim> &)
{
#ifdef __x86_64__
  switch (instructions_of_this_machine())
  {
  case Instructions::avx512:
    return &add_point_avx512<dim>;
  case Instructions::avx2:
    return &add_point_avx2<dim>;
  case Instructions::basic:
    break;
  }
#endif
  return &add_point_basic<dim>;
}
} // namespace

template <int dim>
CellIntegration<dim>::CellIntegration(const Mesh<dim> &mesh, const Material<dim> &material)
  : mesh_(mesh)
  , material_(material)
{
  const dealii::QGauss<dim> gauss(4);
  using Info = dealii::GeometryInfo<dim>;
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
  const dealii::SymmetricTensor<4, dim> hooke = material_.relative_hooke(mesh_.from_unit_body(x));
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
  const auto add_point = best_add_point<dim>();
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

template class CellIntegration<2>;
template class CellIntegration<3>;
} // namespace Signorini
