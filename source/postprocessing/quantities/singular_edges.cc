// SPDX-License-Identifier: LGPL-2.1-or-later
// Corners and edges where stresses grow without limit.

#include <signorini/base/instantiate.h>
#include <signorini/postprocessing/quantities/singular_edges.h>
#include <signorini/problem/geometry/solid_edges.h>
#include <signorini/problem/scene/corners.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Signorini {
namespace {
using numbers::PI;

/** The largest singular exponent: closer to one, refinement changes stresses by less than rounding.
 */
constexpr double max_singular_exponent = 1. - 1e-3;

/** The share of the sides and of the distances between corners. */
constexpr double share_of_sides = 0.1;

/** Adds an edge if stresses can be singular there: if the exponent is below one in one of the
 * states that contact may have. */
template <int dim>
void add_if_singular(const SingularEdge<dim> &edge, const Scene<dim> &scene,
                     std::vector<SingularEdge<dim>> &edges) {
  const Role first = scene.boundary[edge.sides[0]].role,
             second = scene.boundary[edge.sides[1]].role;
  const auto is_free = [](const Role role) { return role == Role::free || role == Role::traction; };
  const double angle = opening(edge.layers);
  // This saves time with hundreds of corners: (W1) at convex corners, and where contact goes on
  // straight.
  if (edge.layers.size() == 1 &&
      ((is_free(first) && is_free(second) && angle <= PI + 1e-6) ||
       (first == Role::contact && second == Role::contact && std::abs(angle - PI) < 1e-6)))
    return;
  if (smallest_exponent(scene, edge.ends[0], edge.sides, edge.layers) < max_singular_exponent)
    edges.push_back(edge);
}

/** Returns the unknown that is nearest to a point, of one side or of all; none where there are
 * none.
 */
template <int dim>
std::optional<unsigned int> nearest_unknown(const Point<dim> &x,
                                            const std::optional<unsigned int> side,
                                            const MultiplierSpace<dim> &multipliers) {
  const ContactSurface<dim> &surface = multipliers.surface();
  double smallest = std::numeric_limits<double>::max();
  std::optional<unsigned int> nearest;
  for (unsigned int k = 0; k < multipliers.n_multipliers(); ++k) {
    const Patch<dim> &patch = surface.patches()[multipliers.patch_of(k)];
    if (side && patch.side != *side)
      continue;
    const double distance = surface.point(patch, multipliers.node(k)).distance(x);
    if (distance < smallest) {
      smallest = distance;
      nearest = k;
    }
  }
  return nearest;
}

/** Returns the condition on both sides at an unknown that presses. */
template <int dim>
EdgeCondition pressing_condition(const unsigned int k, const Multiplier &multiplier) {
  if (!multiplier.has_tangential_part())
    return {EdgeSupport::sliding};
  if (multiplier.state(k).slip == State::inside)
    return {EdgeSupport::held};
  const bool rubs = multiplier.is_coupled() && dim == 2;
  return {EdgeSupport::sliding, rubs ? multiplier.tangential()[0][k] / multiplier.normal()[k] : 0.};
}

/** Returns the condition on a side next to a point in the present state of contact. */
template <int dim>
EdgeCondition present_condition(const Point<dim> &x, const unsigned int side,
                                const MultiplierSpace<dim> &multipliers,
                                const Multiplier &multiplier) {
  const std::optional<unsigned int> k = nearest_unknown<dim>(x, side, multipliers);
  return k && multiplier.presses(*k)
           ? pressing_condition<dim>(*k, multiplier)
           : possible_conditions(multipliers.surface().scene(), side, x).front();
}

/** Returns the exponent of an edge that x lies next to, in the present state of contact. */
template <int dim>
double present_exponent(const SingularEdge<dim> &edge, const Point<dim> &x,
                        const MultiplierSpace<dim> &multipliers, const Multiplier &multiplier) {
  const Point<dim> nearest = edge.nearest(x);
  if (edge.of_pair)
    if (const auto k = nearest_unknown<dim>(nearest, {}, multipliers); k && multiplier.presses(*k))
      return edge.of_pair(pressing_condition<dim>(*k, multiplier));
  return corner_exponent(edge.layers,
                         present_condition(nearest, edge.sides[0], multipliers, multiplier),
                         present_condition(nearest, edge.sides[1], multipliers, multiplier));
}

/** Returns SingularEdge::radius of a corner. */
double radius_at(const Corner &corner, const std::vector<Corner> &all,
                 const std::vector<Side<2>> &sides) {
  double shortest = std::min(sides[corner.sides[0]].length(), sides[corner.sides[1]].length());
  for (const Corner &other : all)
    if (const double distance = other.position.distance(corner.position); distance > 0.)
      shortest = std::min(shortest, distance);
  return share_of_sides * shortest;
}

/** Returns the corners of bodies that press into others, and the points across from them. */
std::vector<SingularEdge<2>> edges_of_pairs(const Scene<2> &scene, const std::vector<Corner> &all) {
  std::vector<SingularEdge<2>> edges;
  for (const PairedCorner &paired : paired_corners(scene)) {
    if (paired.exponent >= max_singular_exponent)
      continue;
    const Corner &corner = paired.corner;
    const Point<2> across = scene.geometry.sides[paired.side].point(paired.s);
    const double radius = radius_at(corner, all, scene.geometry.sides);
    edges.push_back({{{corner.position, corner.position}},
                     corner.sides,
                     layers_at(scene, corner),
                     radius,
                     paired.exponent_in});
    if (!paired.meets_corner)
      edges.push_back({{{across, across}},
                       {{paired.side, paired.side}},
                       {make_layer(scene.material->relative_hooke(across), PI)},
                       radius,
                       paired.exponent_in});
  }
  return edges;
}

/** Returns Hooke's tensor in the plane of two unit vectors at right angles. */
SymmetricTensor<4, 2> in_plane(const SymmetricTensor<4, 3> &hooke,
                               const std::array<Tensor<1, 3>, 2> &e) {
  const auto strain = [&e](const unsigned int i, const unsigned int j) {
    return symmetrize(outer_product(e[i], e[j]));
  };
  SymmetricTensor<4, 2> plane;
  for (unsigned int i = 0; i < 2; ++i)
    for (unsigned int j = i; j < 2; ++j)
      for (unsigned int k = 0; k < 2; ++k)
        for (unsigned int l = k; l < 2; ++l)
          plane[i][j][k][l] = strain(i, j) * (hooke * strain(k, l));
  return plane;
}
} // namespace

template <int dim>
Point<dim> SingularEdge<dim>::nearest(const Point<dim> &x) const {
  const Tensor<1, dim> edge = ends[1] - ends[0];
  const double square = edge.norm_square();
  return ends[0] + (square > 0. ? std::clamp((x - ends[0]) * edge / square, 0., 1.) : 0.) * edge;
}

std::vector<SingularEdge<2>> singular_edges(const Scene<2> &scene) {
  if (scene.exact_displacement != nullptr)
    return {};
  std::vector<Corner> all = corners(scene.geometry);
  const std::size_t n_corners = all.size();
  for (const Corner &end : interface_ends(scene))
    all.push_back(end);
  std::vector<SingularEdge<2>> edges = edges_of_pairs(scene, all);
  // At a corner of a pair the other body is not rigid.
  const std::vector<SingularEdge<2>> of_pairs = edges;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Corner &corner = all[i];
    const double rounding = 1e-4 * std::min(scene.geometry.sides[corner.sides[0]].length(),
                                            scene.geometry.sides[corner.sides[1]].length());
    bool is_known =
      std::any_of(of_pairs.begin(), of_pairs.end(), [&corner](const SingularEdge<2> &edge) {
        return edge.sides == corner.sides && edge.ends[0] == corner.position;
      });
    for (std::size_t j = 0; i >= n_corners && j < n_corners; ++j)
      is_known = is_known || all[j].position.distance(corner.position) < rounding;
    if (!is_known)
      add_if_singular<2>({{{corner.position, corner.position}},
                          corner.sides,
                          layers_at(scene, corner),
                          radius_at(corner, all, scene.geometry.sides)},
                         scene, edges);
  }
  return edges;
}

std::vector<SingularEdge<3>> singular_edges(const Scene<3> &scene) {
  std::vector<SingularEdge<3>> edges;
  if (scene.exact_displacement != nullptr)
    return edges;
  const std::vector<Side<3>> &sides = scene.geometry.sides;
  for (const SolidEdge &edge : solid_edges(scene.geometry)) {
    const Point<3> middle = edge.point(scene.geometry, 0.5);
    const SymmetricTensor<4, 2> hooke =
      in_plane(scene.material->relative_hooke(middle), {{edge.tangent, edge.normal}});
    const double size =
      std::min({scene.geometry.shortest_extent(), std::sqrt(sides[edge.sides[0]].area()),
                std::sqrt(sides[edge.sides[1]].area())});
    add_if_singular<3>(
      {edge.ends, edge.sides, {make_layer(hooke, edge.angle)}, share_of_sides * size}, scene,
      edges);
  }
  return edges;
}

template <int dim>
bool any_contains(const std::vector<SingularEdge<dim>> &edges, const Point<dim> &x) {
  return std::any_of(edges.begin(), edges.end(),
                     [&x](const auto &edge) { return edge.contains(x); });
}

template <int dim>
std::optional<GrowthEdge> growth_at(const Point<dim> &x,
                                    const std::vector<SingularEdge<dim>> &edges,
                                    const BodyInContact<dim> &body) {
  for (const SingularEdge<dim> &edge : edges)
    if (edge.contains(x))
      if (const double exponent = present_exponent(edge, x, body.multipliers, body.P);
          exponent < max_singular_exponent)
        return GrowthEdge{{{edge.ends[0], edge.ends[1]}}, edge.radius, exponent};
  return {};
}

template struct SingularEdge<2>;
template struct SingularEdge<3>;
INSTANTIATE_FUNCTION(any_contains);
INSTANTIATE_FUNCTION(growth_at);
} // namespace Signorini
