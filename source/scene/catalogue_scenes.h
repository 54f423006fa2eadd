// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/scene/scene.h>

namespace Signorini
{
/** Smooth manufactured contact, the main test of the orders. */
Scene<2> make_a1();
/** Constant strain under full contact: exact on every mesh. */
Scene<2> make_patch_test();
/** An elastic block pressed on a parabolic foundation. */
Scene<2> make_block_on_parabola();
} // namespace Signorini
