// SPDX-License-Identifier: LGPL-2.1-or-later
// Corners and edges where stresses grow without limit.

#include <signorini/postprocessing/fields/contact_pressure.h>
#include <signorini/postprocessing/quantities/singular_places.h>
#include <signorini/problem/scene/corners.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Signorini
{
namespace
{
using dealii::numbers::PI;

/** The largest singular exponent: closer to one, refinement changes stresses by less than rounding.
 */
constexpr double largest_singular_exponent = 1. - 1e-3;

/** The share of the sides and of the distances between corners. */
constexpr double share_of_sides = 0.1;

/** Returns the smallest exponent over the states that contact may have. */
double smallest_exponent(const double angle, const std::array<Role, 2> &roles, const double kappa)
{
  double smallest = largest_corner_exponent;
  for (const EdgeSupport first : possible_supports(roles[0]))
    for (const EdgeSupport second : possible_supports(roles[1]))
      smallest = std::min(smallest, corner_exponent(angle, first, second, kappa));
  return smallest;
}

/** Returns whether no state can be singular, which saves time with hundreds of corners: (W1) at
 * convex corners, and where contact goes on straight. There it ends at one of its ends at most,
 * where (1) excludes the root 1/2. */
bool is_harmless(const double angle, const std::array<Role, 2> &roles)
{
  const auto is_free = [](const Role role) { return role == Role::free || role == Role::traction; };
  if (is_free(roles[0]) && is_free(roles[1]))
    return angle <= PI + 1e-6;
  return roles[0] == Role::contact && roles[1] == Role::contact && std::abs(angle - PI) < 1e-6;
}

template <int dim>
std::array<Role, 2> roles_at(const Scene<dim> &scene, const std::array<unsigned int, 2> &sides)
{
  return {{scene.boundary[sides[0]].role, scene.boundary[sides[1]].role}};
}

/** Returns whether the patch of a side that is nearest to a point presses. */
template <int dim>
bool presses_at(const dealii::Point<dim> &x,
                const unsigned int side,
                const MultiplierSpace<dim> &multipliers,
                const Pressure &P)
{
  const std::vector<Patch<dim>> &patches = multipliers.surface().patches();
  double smallest = std::numeric_limits<double>::max();
  unsigned int nearest = 0;
  for (unsigned int k = 0; k < P.size(); ++k)
  {
    const Patch<dim> &patch = patches[multipliers.patch_of(k)];
    const double distance =
      patch.side == side ? multipliers.surface().side(patch).point(multipliers.node(k)).distance(x)
                         : smallest;
    if (distance < smallest)
    {
      smallest = distance;
      nearest = k;
    }
  }
  return P.size() > 0 && P[nearest] < pressing_threshold(P);
}

/** Returns the block of Hooke's tensor in the plane of two axes. */
dealii::SymmetricTensor<4, 2> in_plane(const dealii::SymmetricTensor<4, 3> &hooke,
                                       const std::array<unsigned int, 2> &axes)
{
  dealii::SymmetricTensor<4, 2> plane;
  for (unsigned int i = 0; i < 2; ++i)
    for (unsigned int j = i; j < 2; ++j)
      for (unsigned int k = 0; k < 2; ++k)
        for (unsigned int l = k; l < 2; ++l)
          plane[i][j][k][l] = hooke[axes[i]][axes[j]][axes[k]][axes[l]];
  return plane;
}

/** Returns the axis of a box along the normal of a side. */
unsigned int axis_of(const Side<3> &side)
{
  const dealii::Tensor<1, 3> n = side.normal(dealii::Point<2>());
  unsigned int axis = 0;
  for (unsigned int d = 1; d < 3; ++d)
    if (std::abs(n[d]) > std::abs(n[axis]))
      axis = d;
  return axis;
}
} // namespace

template <int dim>
dealii::Point<dim> SingularPlace<dim>::nearest(const dealii::Point<dim> &x) const
{
  const dealii::Tensor<1, dim> edge = ends[1] - ends[0];
  const double square = edge.norm_square();
  return ends[0] + (square > 0. ? std::clamp((x - ends[0]) * edge / square, 0., 1.) : 0.) * edge;
}

std::vector<SingularPlace<2>> singular_places(const Scene<2> &scene)
{
  std::vector<SingularPlace<2>> places;
  if (scene.exact_displacement != nullptr)
    return places;
  const std::vector<Corner> all = corners(scene.geometry);
  for (const Corner &corner : all)
  {
    const std::array<Role, 2> roles = roles_at(scene, corner.sides);
    if (is_harmless(corner.angle, roles))
      continue;
    const double kappa = kolosov_constant(scene.material->relative_hooke(corner.position));
    if (smallest_exponent(corner.angle, roles, kappa) >= largest_singular_exponent)
      continue;
    double shortest = std::min(scene.geometry.sides[corner.sides[0]].length(),
                               scene.geometry.sides[corner.sides[1]].length());
    for (const Corner &other : all)
      if (&other != &corner && other.position.distance(corner.position) > 0.)
        shortest = std::min(shortest, other.position.distance(corner.position));
    places.push_back({{{corner.position, corner.position}},
                      corner.sides,
                      corner.angle,
                      kappa,
                      share_of_sides * shortest});
  }
  return places;
}

std::vector<SingularPlace<3>> singular_places(const Scene<3> &scene)
{
  std::vector<SingularPlace<3>> places;
  if (scene.exact_displacement != nullptr)
    return places;
  const Geometry<3> &box = scene.geometry;
  for (unsigned int i = 0; i < box.sides.size(); ++i)
    for (unsigned int j = i + 1; j < box.sides.size(); ++j)
    {
      const std::array<unsigned int, 2> axes = {{axis_of(box.sides[i]), axis_of(box.sides[j])}};
      const std::array<Role, 2> roles = roles_at(scene, {{i, j}});
      if (axes[0] == axes[1] || is_harmless(0.5 * PI, roles))
        continue;
      dealii::Point<3> middle = box.lower + 0.5 * (box.upper - box.lower);
      middle[axes[0]] = box.sides[i].centre()[axes[0]];
      middle[axes[1]] = box.sides[j].centre()[axes[1]];
      const double kappa = kolosov_constant(in_plane(scene.material->relative_hooke(middle), axes));
      if (smallest_exponent(0.5 * PI, roles, kappa) >= largest_singular_exponent)
        continue;
      const unsigned int along = 3 - axes[0] - axes[1];
      std::array<dealii::Point<3>, 2> ends = {{middle, middle}};
      ends[0][along] = box.lower[along];
      ends[1][along] = box.upper[along];
      places.push_back({ends, {{i, j}}, 0.5 * PI, kappa, share_of_sides * box.shortest_extent()});
    }
  return places;
}

template <int dim>
bool any_contains(const std::vector<SingularPlace<dim>> &places, const dealii::Point<dim> &x)
{
  return std::any_of(
    places.begin(), places.end(), [&x](const auto &place) { return place.contains(x); });
}

template <int dim>
std::optional<GrowthPlace> growth_at(const dealii::Point<dim> &x,
                                     const std::vector<SingularPlace<dim>> &places,
                                     const MultiplierSpace<dim> &multipliers,
                                     const Pressure &P)
{
  const Scene<dim> &scene = multipliers.surface().scene();
  for (const SingularPlace<dim> &place : places)
  {
    if (!place.contains(x))
      continue;
    std::array<EdgeSupport, 2> supports;
    for (unsigned int i = 0; i < 2; ++i)
    {
      const Role role = scene.boundary[place.sides[i]].role;
      const bool closed =
        role == Role::contact && presses_at(place.nearest(x), place.sides[i], multipliers, P);
      supports[i] = closed ? EdgeSupport::sliding : possible_supports(role).front();
    }
    if (corner_exponent(place.angle, supports[0], supports[1], place.kappa) <
        largest_singular_exponent)
      return GrowthPlace{{{place.ends[0], place.ends[1]}}, place.radius};
  }
  return {};
}

template struct SingularPlace<2>;
template struct SingularPlace<3>;
template bool any_contains(const std::vector<SingularPlace<2>> &, const dealii::Point<2> &);
template bool any_contains(const std::vector<SingularPlace<3>> &, const dealii::Point<3> &);
template std::optional<GrowthPlace> growth_at(const dealii::Point<2> &,
                                              const std::vector<SingularPlace<2>> &,
                                              const MultiplierSpace<2> &,
                                              const Pressure &);
template std::optional<GrowthPlace> growth_at(const dealii::Point<3> &,
                                              const std::vector<SingularPlace<3>> &,
                                              const MultiplierSpace<3> &,
                                              const Pressure &);
} // namespace Signorini
