// SPDX-License-Identifier: LGPL-2.1-or-later
// The kernel of A for a box, found from the boundary conditions alone.

#include <signorini/scene/rigid_motions.h>

#include <cmath>

namespace Signorini
{
namespace
{
using Vector3 = dealii::Tensor<1, 3>;

/** The velocity of the k-th of three translations and three rotations at a point. */
Vector3 velocity(const unsigned int k, const Vector3 &x)
{
  Vector3 axis;
  axis[k % 3] = 1.;
  return k < 3 ? axis : cross_product_3d(axis, x);
}

/** Whether a side leaves a motion free, judged at its corners: a velocity is linear. */
bool leaves_free(const Side<3> &side,
                 const Role role,
                 const unsigned int motion,
                 const dealii::Point<3> &centre,
                 const double size)
{
  const auto lengths = side.lengths();
  for (const double r : {0., 1.})
    for (const double t : {0., 1.})
    {
      const dealii::Point<2> corner(r * lengths[0], t * lengths[1]);
      const Vector3 v = velocity(motion, (side.point(corner) - centre) / size);
      const double held = role == Role::roller ? std::abs(v * side.normal(corner)) : v.norm();
      if (held > 1e-10)
        return false;
    }
  return true;
}
} // namespace

// Sides of a box are parallel to its axes: what they leave free is spanned by translations along
// the axes and rotations about axes through any point on the lines of symmetry of the held sides.
std::vector<std::string> free_rigid_motions(const Scene<3> &scene)
{
  const Geometry<3> &geometry = scene.geometry;
  const dealii::Point<3> centre = geometry.inner_point();
  std::vector<std::string> names;
  for (unsigned int k = 0; k < 6; ++k)
  {
    bool is_free = true;
    for (unsigned int i = 0; i < scene.boundary.size(); ++i)
    {
      const Role role = scene.boundary[i].role;
      if (role == Role::clamped || role == Role::displacement || role == Role::roller)
        is_free = is_free && leaves_free(geometry.sides[i], role, k, centre, geometry.diameter());
    }
    if (is_free)
      names.push_back(k < 3 ? std::string("the translation along ") + "xyz"[k]
                            : std::string("the rotation about the ") + "xyz"[k - 3] + "-axis");
  }
  return names;
}
} // namespace Signorini
