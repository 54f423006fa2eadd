// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/problem/geometry/geometry.h>

#include <string>
#include <vector>

namespace Signorini
{
/** Consecutive sides [first, last) that return to where they start. */
struct Loop
{
  std::size_t first, last;
};

/** Returns the loops that sides in this order form. @throws InputError if they do not. */
std::vector<Loop> find_loops(const std::vector<Side<2>> &sides,
                             double size,
                             const std::string &where);

/** Checks the sides and their loops. @throws InputError if sides cross or touch elsewhere than at
 * common ends, or if the loops are not one around the body and others inside of it around holes. */
void check_outline(const std::vector<Side<2>> &sides,
                   const std::vector<Loop> &loops,
                   double size,
                   const std::string &where);
} // namespace Signorini
