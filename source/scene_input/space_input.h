// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/parameters/parameters.h>

namespace Signorini
{
/** With Dimension = 3: refuses entries for which there is mathematics in the plane only.
 * @throws InputError */
void refuse_what_is_plane(const Parameters &parameters);
} // namespace Signorini
