// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/scene/scene.h>

#include <string>
#include <vector>

namespace Signorini
{
/** A velocity field t + omega (-(y - y0), x - x0) of the plane, of size one on the body. */
struct RigidMotion
{
  dealii::Tensor<1, 2> translation;
  double rotation;
  /** "the translation along (0, 1)" or "the rotation about (1, 2)". */
  std::string name;
};

/**
 * The rigid motions that clamped, prescribed and roller sides leave free; A is singular exactly if
 * there are any. (Contact sides do not hold: they may open.)
 */
std::vector<RigidMotion> free_rigid_motions(const Scene<2> &scene);
} // namespace Signorini
