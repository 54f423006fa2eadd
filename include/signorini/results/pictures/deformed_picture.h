// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/discretization/elasticity/displacement_space.h>
#include <signorini/results/files/contact_files.h>
#include <signorini/results/pictures/pictures.h>

#include <vector>

namespace Signorini
{
/**
 * Makes deformed.svg: the points x + a u_h(x), coloured by the von Mises stress of
 * largest_von_mises(), with the undeformed outline, the contact sides, and the foundation where it
 * is near, x + a g n. So contact and gaps are shown magnified like the displacement. The factor a
 * is 1, 2 or 5 times a power of ten, at least 1, and stands in the title.
 *
 * Where there are more than 10000 cells, ancestors of cells are drawn, with values of u_h and its
 * stress at their corners. Not collective.
 * @param line from trace_contact_line().
 */
Picture deformed_picture(const DisplacementSpace<2> &space,
                         const Scene<2> &scene,
                         const Displacement &U,
                         const std::vector<ContactSegment> &line);
} // namespace Signorini
