// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/discretization/mesh/contact_surface.h>

namespace Signorini {
/** Returns whether the patches of a side go all around it: the first one follows the last. In a
 * pair they cover the overlap only. */
inline bool goes_round(const Side<2> &side, const double first, const double last) {
  return side.is_closed() && last - first > (1. - 1e-9) * side.length();
}
} // namespace Signorini
