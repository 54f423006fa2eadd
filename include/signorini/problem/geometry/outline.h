// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/problem/geometry/geometry.h>

#include <string>
#include <vector>

namespace Signorini
{
/**
 * Returns the body between closed loops of sides, each of which begins where the one before it
 * ends, with the body on the left; a closed side is a loop of its own. The body is filled with
 * triangles whose angles are not small (where the sides let them), each of which is split into
 * three coarse cells by its centre and the middles of its edges. Edges on arcs follow them in every
 * refinement.
 *
 * @param mesh_size the longest edge of the triangles (length); 0: as long as their angles allow.
 * @param where the beginning of messages.
 * @throws InputError if the sides are no such loops, cross or touch, or if no mesh of at most
 * max_coarse_cells cells was found.
 */
Geometry<2> make_outlined_body(const std::vector<Side<2>> &sides,
                               double mesh_size,
                               const std::string &where);

constexpr unsigned int max_coarse_cells = 300000;
} // namespace Signorini
