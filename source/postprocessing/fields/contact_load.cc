// SPDX-License-Identifier: LGPL-2.1-or-later
// The tractions and the penetration of a piece of Γ_c.

#include <signorini/base/instantiate.h>
#include <signorini/postprocessing/fields/contact_load.h>

namespace Signorini {
template <int dim>
std::vector<Point<dim>> points_of_action(const ContactSurface<dim> &surface,
                                         const Piece<dim> &piece, const PairSide side) {
  std::vector<Point<dim>> points = piece.on_mesh.points;
  if constexpr (dim == 2)
    if (side == PairSide::opposite) {
      const Side<2> &other = surface.scene().geometry.sides[*surface.condition(piece).opposite];
      for (std::size_t q = 0; q < points.size(); ++q)
        points[q] = other.across(points[q], piece.on_mesh.normals[q]);
    }
  return points;
}

template <int dim>
Resultant<dim> contact_resultant(const MultiplierSpace<dim> &multipliers,
                                 const Multiplier &multiplier, const Piece<dim> &piece,
                                 const PairSide side) {
  const double sign = side == PairSide::first ? 1. : -1.;
  const std::vector<Point<dim>> points = points_of_action(multipliers.surface(), piece, side);
  Resultant<dim> resultant;
  const SurfaceRule<dim> &rule = piece.on_mesh;
  for (std::size_t q = 0; q < rule.size(); ++q) {
    const Point<dim - 1> &s = rule.on_side[q];
    const Tensor<1, dim> &m = rule.directions[q];
    resultant.add((multipliers.value(multiplier.normal(), piece.patch, s) * m +
                   tangential_traction(multipliers, multiplier, piece.patch, s, m)) *
                    (sign * rule.weights[q]),
                  points[q]);
  }
  // Forces all around an axis have no moment.
  if (multipliers.surface().scene().geometry.axisymmetric)
    resultant.moment = {};
  return resultant;
}

template <int dim>
std::vector<double> penetration(const Scene<dim> &scene, const ContactSurface<dim> &surface,
                                const Piece<dim> &piece, const SurfaceRule<dim> &rule,
                                const Displacement &U, TraceValues<dim> &traces,
                                const Component component) {
  const auto u = traces.displacement(surface, piece, rule, U);
  const BoundaryCondition<dim> &condition = scene.boundary[surface.patches()[piece.patch].side];
  const auto &data = component == Component::normal ? condition.data : condition.shift;
  std::vector<double> depths(rule.size());
  for (std::size_t q = 0; q < rule.size(); ++q)
    depths[q] = u[q] * direction_of(component, rule.directions[q]) -
                (data != nullptr ? data->value(rule.points[q]) : 0.);
  return depths;
}

INSTANTIATE_FUNCTION(points_of_action);
INSTANTIATE_FUNCTION(contact_resultant);
INSTANTIATE_FUNCTION(penetration);
} // namespace Signorini
