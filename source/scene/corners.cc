// SPDX-License-Identifier: LGPL-2.1-or-later
// Where the sides of a plane body meet, and how rough a displacement may be there.

#include <signorini/scene/corners.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
namespace
{
using dealii::numbers::PI;

/** An end of a smooth part of a side, with the direction in which the side leaves it. */
struct SideEnd
{
  unsigned int side;
  dealii::Point<2> position;
  dealii::Tensor<1, 2> direction;
  /** Whether a walk with the body on its left leaves the point along this side. */
  bool leaves;
};

/** The end at s of the part that lies in the direction of @p towards. */
SideEnd
side_end(const Side<2> &side, const unsigned int number, const double s, const double towards)
{
  const dealii::Tensor<1, 2> normal = side.normal(s, towards);
  const dealii::Tensor<1, 2> along_walk({-normal[1], normal[0]});
  const dealii::Tensor<1, 2> direction = (towards > s ? 1. : -1.) * side.tangent(s, towards);
  const bool leaves = along_walk * direction > 0.;
  return {number, side.point(s), leaves ? along_walk : -along_walk, leaves};
}

/** The ends of a side, and those of its smooth parts at corners inside. */
std::vector<SideEnd> ends_of(const Side<2> &side, const unsigned int number)
{
  std::vector<SideEnd> ends;
  const double length = side.length();
  if (!side.is_closed())
    ends = {side_end(side, number, 0., length), side_end(side, number, length, 0.)};
  for (const double s : side.corners())
    for (const double towards : {s - length, s + length})
      ends.push_back(side_end(side, number, s, towards));
  return ends;
}

/** From the direction of one end counter-clockwise to that of the other, in (0, 2 pi]. */
double opening(const SideEnd &first, const SideEnd &second)
{
  const dealii::Tensor<1, 2> &a = first.direction, &b = second.direction;
  const double angle = std::atan2(a[0] * b[1] - a[1] * b[0], a * b);
  // A body does not end in a cusp: parallel sides are those of a crack.
  return angle > 1e-8 ? angle : angle + 2. * PI;
}
} // namespace

std::vector<Corner> corners(const Geometry<2> &geometry)
{
  std::vector<SideEnd> leaving, arriving;
  for (unsigned int i = 0; i < geometry.sides.size(); ++i)
    for (const SideEnd &end : ends_of(geometry.sides[i], i))
      (end.leaves ? leaving : arriving).push_back(end);
  std::vector<Corner> found;
  for (const SideEnd &first : leaving)
  {
    // Where the body touches itself, it lies between a side and the next one.
    std::vector<Corner> here;
    for (const SideEnd &second : arriving)
      if (first.position.distance(second.position) < 1e-8 * geometry.diameter())
        here.push_back({first.position, opening(first, second), {{first.side, second.side}}});
    const auto next = std::min_element(
      here.begin(), here.end(), [](const Corner &a, const Corner &b) { return a.angle < b.angle; });
    if (next != here.end())
      found.push_back(*next);
  }
  return found;
}

std::vector<EdgeSupport> possible_supports(const Role role)
{
  switch (role)
  {
  case Role::clamped:
  case Role::displacement:
    return {EdgeSupport::held};
  case Role::roller:
    return {EdgeSupport::sliding};
  case Role::contact:
    return {EdgeSupport::free, EdgeSupport::sliding};
  case Role::free:
  case Role::traction:
    break;
  }
  return {EdgeSupport::free};
}

double corner_exponent(const Scene<2> &scene, const Corner &corner)
{
  const double kappa = kolosov_constant(scene.material->relative_hooke(corner.position));
  double smallest = largest_corner_exponent;
  for (const EdgeSupport first : possible_supports(scene.boundary[corner.sides[0]].role))
    for (const EdgeSupport second : possible_supports(scene.boundary[corner.sides[1]].role))
      smallest = std::min(smallest, corner_exponent(corner.angle, first, second, kappa));
  return smallest;
}
} // namespace Signorini
