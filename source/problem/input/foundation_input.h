// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/problem/parameters/parameters.h>
#include <signorini/problem/scene/expression.h>
#include <signorini/problem/scene/scene.h>

#include "side_lists.h"

namespace Signorini
{
/**
 * Reads "plane x,y normal nx,ny | bottom: circle x,y radius r" and gives the named contact sides
 * their foundation and gap. An obstacle that no normal can meet is refused, in its position or,
 * where load cases make it move, in all.
 * @throws InputError
 */
void read_foundation(const ContactParameters &given,
                     const Constants &constants,
                     bool moves,
                     Scene<2> &scene);

/**
 * Returns the contact sides that read_foundation() left without a gap, with their texts in
 * Contact/Gap.
 * @throws InputError if a side has both or neither.
 */
SideTexts gaps_without_foundation(const ContactParameters &given, const Scene<2> &scene);
} // namespace Signorini
