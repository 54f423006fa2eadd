// SPDX-License-Identifier: LGPL-2.1-or-later
// The bodies of a pair on a piece of Γ_c.

#include <signorini/discretization/space/paired_piece.h>

namespace Signorini {
template <int dim>
std::vector<Point<dim>> PairedPiece<dim>::points(const SurfaceRule<dim> &rule,
                                                 const PairSide side) const {
  std::vector<Point<dim>> points = rule.points;
  if constexpr (dim == 2)
    if (side == PairSide::second) {
      const Side<2> &other = surface_.scene().geometry.sides[*pair().other_side()];
      for (std::size_t q = 0; q < points.size(); ++q)
        points[q] = other.across(points[q], rule.normals[q]);
    }
  return points;
}

template <int dim>
double PairedPiece<dim>::turn_of_normals(const SurfaceRule<dim> &rule, const std::size_t q) const {
  const Scene<dim> &scene = surface_.scene();
  const Point<dim> &x = rule.points[q];
  const Tensor<1, dim> &m = rule.directions[q];
  if (const auto &foundation = surface_.condition(piece_).foundation)
    if (const auto of_obstacle =
          foundation->normal_at_entry(Point<dim>(x - scene.foundation_position), m))
      return (m + *of_obstacle).norm();
  if constexpr (dim == 2)
    if (const auto side = pair().other_side()) {
      const Side<2> &other = scene.geometry.sides[*side];
      const Tensor<1, 2> &n = rule.normals[q];
      return (n + other.normal(other.arc_length(other.across(x, n)))).norm();
    }
  return 0.;
}

template <int dim>
std::array<std::vector<Tensor<1, dim>>, 2> PairedPiece<dim>::displacements(
  const SurfaceRule<dim> &rule, const Displacement &U, TraceValues<dim> &traces) const {
  std::array<std::vector<Tensor<1, dim>>, 2> u;
  for (const auto &[face, points, sign] : surface_.faces_at(piece_, rule)) {
    std::vector<Tensor<1, dim>> &of_body = u[sign > 0. ? 0 : 1];
    of_body.resize(rule.size());
    traces.reinit(face, points)[FEValuesExtractors::Vector(0)].get_function_values(U.entries(),
                                                                                   of_body);
  }
  u[1].resize(rule.size());
  return u;
}

template <int dim>
std::vector<double> PairedPiece<dim>::closing(const DisplacedBody<dim> &body,
                                              const SurfaceRule<dim> &rule,
                                              TraceValues<dim> &traces,
                                              const Component component) const {
  const auto u = traces.displacement(surface_, piece_, rule, body.U);
  const ContactPair<dim> pair = in(body.scene);
  std::vector<double> closing(rule.size());
  for (std::size_t q = 0; q < rule.size(); ++q) {
    const Point<dim> &x = rule.points[q];
    closing[q] = u[q] * direction_of(component, rule.directions[q]) -
                 (component == Component::normal ? pair.gap(x) : pair.shift(x));
  }
  return closing;
}

template <int dim>
Resultant<dim> PairedPiece<dim>::resultant(const MultiplierSpace<dim> &multipliers,
                                           const Multiplier &multiplier,
                                           const PairSide side) const {
  const double sign = side == PairSide::first ? 1. : -1.;
  const SurfaceRule<dim> &rule = piece_.on_mesh;
  const std::vector<Point<dim>> on_side = points(rule, side);
  Resultant<dim> resultant;
  for (std::size_t q = 0; q < rule.size(); ++q) {
    const Point<dim - 1> &s = rule.on_side[q];
    const Tensor<1, dim> &m = rule.directions[q];
    resultant.add((multipliers.value(multiplier.normal(), piece_.patch, s) * m +
                   tangential_traction(multipliers, multiplier, piece_.patch, s, m)) *
                    (sign * rule.weights[q]),
                  on_side[q]);
  }
  // Forces all around an axis have no moment.
  if (surface_.scene().geometry.axisymmetric)
    resultant.moment = {};
  return resultant;
}

template class PairedPiece<2>;
template class PairedPiece<3>;
} // namespace Signorini
