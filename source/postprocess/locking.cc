// SPDX-License-Identifier: LGPL-2.1-or-later
// Whether bilinear elements can follow a nearly incompressible body.

#include <signorini/postprocess/locking.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
namespace
{
/** K/mu of a tensor. */
template <int dim>
double bulk_to_shear(const dealii::SymmetricTensor<4, dim> &E)
{
  static_assert(dim == 2, "in the plane there are two independent deviators");
  const double bulk = (E[0][0][0][0] + 2. * E[0][0][1][1] + E[1][1][1][1]) / 4.;
  // d:E:d for the deviators (e1 e1 - e2 e2)/sqrt(2) and (e1 e2 + e2 e1)/sqrt(2), and between them.
  const double stretch = (E[0][0][0][0] - 2. * E[0][0][1][1] + E[1][1][1][1]) / 2.;
  const double shear = 2. * E[0][1][0][1];
  const double mixed = E[0][0][0][1] - E[1][1][0][1];
  const double smallest = 0.5 * (stretch + shear) - std::hypot(0.5 * (stretch - shear), mixed);
  return bulk / (0.5 * smallest);
}

/** The largest K/mu at one point of each cell of the level, or of a coarser one that is fine enough
 * to show how E varies. */
template <int dim>
double largest_bulk_to_shear(const Mesh<dim> &mesh, const Material<dim> &material)
{
  constexpr unsigned int fine_enough = 6;
  double largest = 0.;
  for (const auto &cell :
       mesh.triangulation().cell_iterators_on_level(std::min(mesh.level(), fine_enough)))
  {
    // Data may have no value where the corners of finer cells are.
    const dealii::Point<dim> x = cell->center() + 0.21 * (cell->vertex(0) - cell->center());
    largest = std::max(largest, bulk_to_shear<dim>(material.relative_hooke(x)));
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
} // namespace Signorini
