// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <muParser.h>

namespace Signorini {
/** Defines the functions that muParser lacks. */
void define_functions(mu::Parser &parser);
} // namespace Signorini
