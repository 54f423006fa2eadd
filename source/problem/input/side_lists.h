// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/problem/geometry/geometry.h>
#include <signorini/problem/parameters/parameters.h>
#include <signorini/problem/scene/scene.h>

#include <string>
#include <utility>
#include <vector>

namespace Signorini
{
/** The names of sides, and the texts that belong to them. */
using SideTexts = std::vector<std::pair<std::string, std::string>>;

/** Returns the side of this name, or the sides name.1, name.2, ... that a name of a mesh file has
 * become; empty if there is none. */
std::vector<std::string> sides_called(const std::string &name,
                                      const std::vector<std::string> &sides);

/** Reads "left: tx; ty | right: tx; ty". @throws InputError if an entry names no side. */
SideTexts read_side_list(const std::string &text,
                         const std::string &where,
                         const std::vector<std::string> &sides);

/** Returns whether a text begins with a word and ':', so that it is for one side. */
bool begins_with_a_name(const std::string &text);

/**
 * Reads "expression" for all contact sides or "bottom: ... | left: ...", one for each.
 * @throws InputError if a contact side has none or two, or another side is named.
 */
SideTexts read_contact_list(const std::string &text,
                            const std::string &where,
                            const std::vector<std::string> &sides,
                            const std::vector<std::string> &contact_sides);

/** Reads Boundary/Plates with Load/Plate force, Plate moment and Plate travel. @throws InputError.
 */
std::vector<Plate> read_plates(const Given<std::string> &given,
                               const LoadParameters &load,
                               const Geometry<2> &geometry);
} // namespace Signorini
