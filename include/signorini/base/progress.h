// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>
#include <string>

namespace Signorini {
/** A callback that gets the name of the current stage, for the user to watch. */
using Progress = std::function<void(const std::string &)>;
} // namespace Signorini
