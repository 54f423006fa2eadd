// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/message.h>
#include <signorini/problem/parameters/parameters.h>

namespace Signorini {
/** Returns the error "scene.prm:12: Solver/Tolerance: ..." of an entry, which goes on with the
 * parts. */
template <typename... Parts>
InputError error_at(const Entry &entry, const Parts &...parts) {
  return InputError(concatenate(entry.where(), ": ", parts...));
}
} // namespace Signorini
