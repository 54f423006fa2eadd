// SPDX-License-Identifier: LGPL-2.1-or-later
// The mean of tr ε(u_h), which does not alternate from cell to cell.

#include <signorini/postprocessing/fields/stress.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include <cmath>
#include <map>

namespace Signorini
{
template <int dim>
std::vector<double> mean_dilatations(const DisplacementSpace<dim> &space, const Displacement &U)
{
  const QGauss<dim> gauss(2);
  FEValues<dim> values(
    space.mesh().mapping(), space.element(), gauss, update_gradients | update_JxW_values);
  std::vector<double> divergences(gauss.size());
  /** The integral and the volume of a parent, or of a cell. */
  std::map<std::pair<int, int>, std::pair<double, double>> sums;
  const auto sums_of = [&](const auto &cell) -> std::pair<double, double> & {
    const bool by_parent = space.mesh().has_parents();
    return sums[{cell->level(), by_parent ? cell->parent_index() : cell->index()}];
  };
  for (const auto &cell : space.dofs().active_cell_iterators())
  {
    values.reinit(cell);
    values[FEValuesExtractors::Vector(0)].get_function_divergences(U.entries(), divergences);
    for (const unsigned int q : values.quadrature_point_indices())
    {
      sums_of(cell).first += divergences[q] * values.JxW(q);
      sums_of(cell).second += values.JxW(q);
    }
  }
  std::vector<double> means;
  for (const auto &cell : space.dofs().active_cell_iterators())
    means.push_back(sums_of(cell).first / sums_of(cell).second);
  return means;
}

// Polynomials at the points of tensor product rules, direction by direction.

namespace
{
/** Returns Σ_k row[k] v[k * stride]. */
Tensor<1, 3> along(const double *const row,
                   const unsigned int n,
                   const Tensor<1, 3> *const v,
                   const std::size_t stride)
{
  Tensor<1, 3> sum;
  for (unsigned int k = 0; k < n; ++k)
    sum += row[k] * v[k * stride];
  return sum;
}
} // namespace

TensorEvaluation::TensorEvaluation(const std::vector<Polynomials::Polynomial<double>> &basis,
                                   const std::array<Quadrature<1>, 3> &rule,
                                   const unsigned int n_cells)
  : n_nodes_(basis.size())
{
  std::vector<double> value_and_derivative(2);
  for (unsigned int d = 0; d < 3; ++d)
  {
    n_points_[d] = rule[d].size();
    lines_[d].resize(n_cells);
    for (unsigned int c = 0; c < n_cells; ++c)
      for (unsigned int q = 0; q < n_points_[d]; ++q)
        for (const auto &polynomial : basis)
        {
          polynomial.value((rule[d].point(q)[0] + c) / n_cells, value_and_derivative);
          lines_[d][c].values.push_back(value_and_derivative[0]);
          lines_[d][c].derivatives.push_back(value_and_derivative[1] / n_cells);
        }
  }
  const std::size_t n = n_nodes_;
  for (auto &stage : first_)
    stage.resize(n_points_[0] * n * n);
  for (auto &stage : second_)
    stage.resize(static_cast<std::size_t>(n_points_[0]) * n_points_[1] * n);
}

void TensorEvaluation::evaluate(const std::vector<Vector3> &nodal_values,
                                const std::array<unsigned int, 3> &place,
                                std::vector<Vector3> &values,
                                std::vector<Tensor<2, 3>> &gradients)
{
  const unsigned int n = n_nodes_;
  const auto [n_x, n_y, n_z] = n_points_;
  const Line &x = lines_[0][place[0]], &y = lines_[1][place[1]], &z = lines_[2][place[2]];
  for (unsigned int k = 0; k < n * n; ++k)
    for (unsigned int q = 0; q < n_x; ++q)
    {
      const Vector3 *const row = &nodal_values[k * n];
      first_[0][k * n_x + q] = along(&x.values[q * n], n, row, 1);
      first_[1][k * n_x + q] = along(&x.derivatives[q * n], n, row, 1);
    }
  for (unsigned int k = 0; k < n; ++k)
    for (unsigned int q = 0; q < n_y; ++q)
      for (unsigned int i = 0; i < n_x; ++i)
      {
        const std::size_t from = static_cast<std::size_t>(k) * n * n_x + i,
                          to = (static_cast<std::size_t>(k) * n_y + q) * n_x + i;
        second_[0][to] = along(&y.values[q * n], n, &first_[0][from], n_x);
        second_[1][to] = along(&y.values[q * n], n, &first_[1][from], n_x);
        second_[2][to] = along(&y.derivatives[q * n], n, &first_[0][from], n_x);
      }
  const std::size_t in_plane = static_cast<std::size_t>(n_x) * n_y;
  values.resize(in_plane * n_z);
  gradients.resize(in_plane * n_z);
  for (unsigned int q = 0; q < n_z; ++q)
    for (std::size_t i = 0; i < in_plane; ++i)
    {
      const double *const row = &z.values[q * n];
      values[q * in_plane + i] = along(row, n, &second_[0][i], in_plane);
      const std::array<Vector3, 3> slopes = {
        {along(row, n, &second_[1][i], in_plane),
         along(row, n, &second_[2][i], in_plane),
         along(&z.derivatives[q * n], n, &second_[0][i], in_plane)}};
      for (unsigned int c = 0; c < 3; ++c)
        for (unsigned int d = 0; d < 3; ++d)
          gradients[q * in_plane + i][c][d] = slopes[d][c];
    }
}

// The stress with three components per direction, and the quantities that follow from it.

template <int dim>
Stress3D stress_in_3d(const Material<dim> &material,
                      const Point<dim> &x,
                      const SymmetricTensor<2, dim> &strain)
{
  const SymmetricTensor<2, dim> stress = material.hooke(x) * strain;
  Stress3D in_space;
  for (unsigned int i = 0; i < dim; ++i)
    for (unsigned int j = i; j < dim; ++j)
      in_space[i][j] = stress[i][j];
  if (dim == 2)
    in_space[2][2] = material.out_of_plane_stress(x, strain);
  return in_space;
}

double von_mises(const Stress3D &stress)
{
  return std::sqrt(1.5) * deviator(stress).norm();
}

std::array<double, 3> principal_stresses(const Stress3D &stress)
{
  // Jacobi's method keeps all digits where eigenvalues are equal.
  const auto pairs = eigenvectors(stress, SymmetricTensorEigenvectorMethod::jacobi);
  return {pairs[0].first, pairs[1].first, pairs[2].first};
}

#define INSTANTIATE(dim)                                                                           \
  template std::vector<double> mean_dilatations(const DisplacementSpace<dim> &,                    \
                                                const Displacement &);                             \
  template Stress3D stress_in_3d(                                                                  \
    const Material<dim> &, const Point<dim> &, const SymmetricTensor<2, dim> &);
INSTANTIATE(2)
INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Signorini
