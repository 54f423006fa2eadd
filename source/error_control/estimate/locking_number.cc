// SPDX-License-Identifier: LGPL-2.1-or-later
// The locking number of bilinear elements in nearly incompressible bodies.

#include <signorini/base/instantiate.h>
#include <signorini/error_control/estimate/locking_number.h>
#include <signorini/problem/scene/material.h>

#include <deal.II/base/mpi.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/lapack_full_matrix.h>
#include <deal.II/physics/notation.h>

#include <algorithm>
#include <cmath>

namespace Signorini {
namespace {
/** Returns K/μ of Hooke's tensor: the smallest d:E:d of deviators d of norm one is an eigenvalue.
 */
template <int dim>
double bulk_to_shear(const SymmetricTensor<4, dim> &E) {
  const auto unit = unit_symmetric_tensor<dim>();
  const auto deviatoric = deviator_tensor<dim>();
  // With it the unit tensor, which is no deviator, belongs to a large eigenvalue.
  const auto shift = E.norm() * outer_product(unit, unit);
  const FullMatrix<double> energies =
    Physics::Notation::Kelvin::to_matrix(deviatoric * E * deviatoric + shift);
  LAPACKFullMatrix<double> matrix(energies.m());
  matrix = energies;
  dealii::Vector<double> eigenvalues;
  FullMatrix<double> eigenvectors;
  const double limit = 2. * energies.frobenius_norm();
  matrix.compute_eigenvalues_symmetric(-limit, limit, 0., eigenvalues, eigenvectors);
  return (unit * (E * unit)) / (dim * dim) / (0.5 * eigenvalues[0]);
}

/** Returns the largest K/μ at one point of each cell of the level, or of a coarser one that is
 * fine enough to show how E varies. Collective. */
template <int dim>
double max_bulk_to_shear(const Mesh<dim> &mesh, const Material<dim> &material) {
  constexpr unsigned int fine_enough = dim == 2 ? 6 : 4;
  double largest = 0.;
  for (const auto &cell :
       mesh.triangulation().cell_iterators_on_level(std::min(mesh.level(), fine_enough))) {
    // Data may have no value where the corners of finer cells are.
    const Point<dim> x = cell->center() + 0.21 * (cell->vertex(0) - cell->center());
    largest = std::max(largest, bulk_to_shear(material.relative_hooke(x)));
    if (material.is_constant())
      break;
  }
  return Utilities::MPI::max(largest, mesh.communicator());
}
} // namespace

template <int dim>
double locking_number(const Mesh<dim> &mesh, const Scene<dim> &scene) {
  constexpr double nearly_incompressible = 10.;
  const double ratio = max_bulk_to_shear(mesh, *scene.material);
  if (!(ratio > nearly_incompressible))
    return 0.;
  bool presses_on_arc = false;
  if constexpr (dim == 2)
    for (const ContactCondition<2> &contact : scene.contacts)
      presses_on_arc = presses_on_arc || !scene.geometry.sides[contact.side].is_flat();
  return ratio * std::pow(mesh.longest_edge() / mesh.size(), presses_on_arc ? 1 : 2);
}

INSTANTIATE_FUNCTION(locking_number);
} // namespace Signorini
