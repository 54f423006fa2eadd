// SPDX-License-Identifier: LGPL-2.1-or-later
// The locking number of bilinear elements in nearly incompressible bodies.

#include <signorini/error_control/estimate/locking.h>

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/lapack_full_matrix.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace Signorini
{
namespace
{
/** Returns K/μ of Hooke's tensor. */
double bulk_to_shear(const dealii::SymmetricTensor<4, 2> &E)
{
  const double bulk = (E[0][0][0][0] + 2. * E[0][0][1][1] + E[1][1][1][1]) / 4.;
  // d:E:d for the deviators (e1 e1 - e2 e2)/sqrt(2) and (e1 e2 + e2 e1)/sqrt(2), and between them.
  const double stretch = (E[0][0][0][0] - 2. * E[0][0][1][1] + E[1][1][1][1]) / 2.;
  const double shear = 2. * E[0][1][0][1];
  const double mixed = E[0][0][0][1] - E[1][1][0][1];
  const double smallest = 0.5 * (stretch + shear) - std::hypot(0.5 * (stretch - shear), mixed);
  return bulk / (0.5 * smallest);
}

/** Returns the same in 3-D, where there are five independent deviators of norm one and the smallest
 * d:E:d is an eigenvalue. */
double bulk_to_shear(const dealii::SymmetricTensor<4, 3> &E)
{
  using Strain = dealii::SymmetricTensor<2, 3>;
  std::array<Strain, 5> deviators;
  deviators[0][0][0] = std::sqrt(0.5);
  deviators[0][1][1] = -std::sqrt(0.5);
  for (unsigned int i = 0; i < 3; ++i)
    deviators[1][i][i] = (i < 2 ? 1. : -2.) / std::sqrt(6.);
  deviators[2][0][1] = deviators[3][0][2] = deviators[4][1][2] = std::sqrt(0.5);
  dealii::LAPACKFullMatrix<double> energies(5);
  for (unsigned int i = 0; i < 5; ++i)
    for (unsigned int j = 0; j < 5; ++j)
      energies(i, j) = deviators[i] * (E * deviators[j]);
  dealii::Vector<double> eigenvalues;
  dealii::FullMatrix<double> eigenvectors;
  const double more_than_all = 2. * energies.frobenius_norm();
  energies.compute_eigenvalues_symmetric(
    -more_than_all, more_than_all, 0., eigenvalues, eigenvectors);
  const Strain unit = dealii::unit_symmetric_tensor<3>();
  return (unit * (E * unit)) / 9. / (0.5 * eigenvalues[0]);
}

/** Returns the largest K/μ at one point of each cell of the level, or of a coarser one that is
 * fine enough to show how E varies. */
template <int dim>
double largest_bulk_to_shear(const Mesh<dim> &mesh, const Material<dim> &material)
{
  constexpr unsigned int fine_enough = dim == 2 ? 6 : 4;
  double largest = 0.;
  for (const auto &cell :
       mesh.triangulation().cell_iterators_on_level(std::min(mesh.level(), fine_enough)))
  {
    // Data may have no value where the corners of finer cells are.
    const dealii::Point<dim> x = cell->center() + 0.21 * (cell->vertex(0) - cell->center());
    largest = std::max(largest, bulk_to_shear(material.relative_hooke(x)));
    if (material.is_constant())
      break;
  }
  return largest;
}
} // namespace

template <int dim>
double locking_number(const Mesh<dim> &mesh, const Material<dim> &material)
{
  constexpr double nearly_incompressible = 10.;
  const double ratio = largest_bulk_to_shear(mesh, material);
  return ratio > nearly_incompressible ? ratio * std::pow(mesh.longest_edge() / mesh.size(), 2)
                                       : 0.;
}

template double locking_number(const Mesh<2> &, const Material<2> &);
template double locking_number(const Mesh<3> &, const Material<3> &);
} // namespace Signorini
