// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/discretization/elasticity/displacement_space.h>
#include <signorini/problem/scene/scene.h>

#include <ostream>

namespace Signorini
{
/**
 * Writes mesh-LL.svg: the undeformed cells, coloured by their degree, with a legend; contact sides
 * have a red line. Where cells at contact sides are too small to be seen, further panels magnify
 * the surroundings of the smallest one step by step.
 * @param number of the step.
 */
void write_mesh_svg(std::ostream &stream,
                    const DisplacementSpace<2> &space,
                    const Scene<2> &scene,
                    unsigned int number);
} // namespace Signorini
