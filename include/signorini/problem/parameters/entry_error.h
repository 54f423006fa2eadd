// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/message.h>
#include <signorini/problem/parameters/parameters.h>

#include <string>
#include <vector>

namespace Signorini {
/** Reads the whole text of an entry, or a part of it, as one number or as a formula of the
 * constants; returns false if it has no finite value. */
bool read_number(const Entry &entry, const std::string &text, double &number);

/** Reads such numbers separated by commas; returns false if one of them has no finite value. */
bool read_numbers(const Entry &entry, const std::string &text, std::vector<double> &numbers);

/** Returns the error "scene.prm:12: Solver/Tolerance: ..." of an entry, which goes on with the
 * parts. */
template <typename... Parts>
InputError error_at(const Entry &entry, const Parts &...parts) {
  return InputError(concatenate(entry.where(), ": ", parts...));
}
} // namespace Signorini
