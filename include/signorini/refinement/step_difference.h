// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/elasticity/displacement_space.h>
#include <signorini/scene/scene.h>

namespace Signorini
{
/** u_h and the space that it belongs to. */
struct StepField
{
  const DisplacementSpace<2> &space;
  const NodalVector &U;
};

/**
 * |||u_h - v_h||| for functions on two meshes that come from the same mesh by splitting cells,
 * integrated on the finer cell wherever one lies in the other; (force length)^{1/2}. Where curved
 * cells are split, the maps of both cells are taken for the same.
 */
double energy_distance(const StepField &u, const StepField &v, const Scene<2> &scene);
} // namespace Signorini
