// SPDX-License-Identifier: LGPL-2.1-or-later
// The mean of tr ε(u_h), which does not alternate from cell to cell.

#include <signorini/base/instantiate.h>
#include <signorini/discretization/elasticity/body_measure.h>
#include <signorini/postprocessing/fields/stress.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/lapack_full_matrix.h>

#include <cmath>
#include <map>

namespace Signorini {
template <int dim>
std::vector<double> mean_dilatations(const DisplacementSpace<dim> &space, const Displacement &U) {
  const QGauss<dim> gauss(2);
  FEValues<dim> values(space.mesh().mapping(), space.element(), gauss,
                       update_gradients | update_JxW_values);
  std::vector<double> divergences(gauss.size());
  /** The integral and the volume of a parent, or of a cell. */
  std::map<std::pair<int, int>, std::pair<double, double>> sums;
  const auto sums_of = [&](const auto &cell) -> std::pair<double, double> & {
    const bool by_parent = space.mesh().has_parents();
    return sums[{cell->level(), by_parent ? cell->parent_index() : cell->index()}];
  };
  for (const auto &cell : space.dofs().active_cell_iterators()) {
    values.reinit(cell);
    values[FEValuesExtractors::Vector(0)].get_function_divergences(U.entries(), divergences);
    for (const unsigned int q : values.quadrature_point_indices()) {
      sums_of(cell).first += divergences[q] * measure_at(values, q);
      sums_of(cell).second += measure_at(values, q);
    }
  }
  std::vector<double> means;
  for (const auto &cell : space.dofs().active_cell_iterators())
    means.push_back(sums_of(cell).first / sums_of(cell).second);
  return means;
}

// The stress with three components per direction, and the quantities that follow from it.

template <int dim>
Stress3D stress_in_3d(const Material<dim> &material, const Point<dim> &x, const Point<dim> &middle,
                      const SymmetricTensor<2, dim> &strain) {
  // Corners and sides belong to several cells, and to the material of each. A step inside chooses;
  // it is longer than rounding, and shorter than what changes a smooth law.
  constexpr double step = 1e-8;
  const Point<dim> inside = x + step * (middle - x);
  const SymmetricTensor<2, dim> stress = material.hooke(inside) * strain;
  Stress3D in_space;
  for (unsigned int i = 0; i < dim; ++i)
    for (unsigned int j = i; j < dim; ++j)
      in_space[i][j] = stress[i][j];
  if (dim == 2)
    in_space[2][2] = material.out_of_plane_stress(inside, strain);
  return in_space;
}

double von_mises(const Stress3D &stress) {
  return std::sqrt(1.5) * deviator(stress).norm();
}

std::array<double, 3> principal_stresses(const Stress3D &stress) {
  LAPACKFullMatrix<double> matrix(3);
  for (unsigned int a = 0; a < 3; ++a)
    for (unsigned int b = 0; b < 3; ++b)
      matrix(a, b) = stress[a][b];
  dealii::Vector<double> values;
  FullMatrix<double> vectors;
  const double size = stress.norm(), above = size > 0. ? 2. * size : 1.;
  matrix.compute_eigenvalues_symmetric(-above, above, 0., values, vectors);
  return {values[2], values[1], values[0]};
}

INSTANTIATE_FUNCTION(mean_dilatations);
INSTANTIATE_FUNCTION(stress_in_3d);
} // namespace Signorini
