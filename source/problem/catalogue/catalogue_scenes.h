// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/problem/scene/scene.h>

namespace Signorini
{
// The file of each scene describes it.
Scene<2> make_a1();
Scene<2> make_a1l();
Scene<2> make_a2();
Scene<2> make_a3();
Scene<2> make_b1();
Scene<2> make_b1q();
Scene<2> make_b1t();
Scene<2> make_b2();
Scene<2> make_b3();
Scene<2> make_b4();
Scene<2> make_c1();
Scene<2> make_c2();
Scene<2> make_c3();
Scene<2> make_c4();
Scene<2> make_e1();
Scene<2> make_e2();
Scene<2> make_e3();
Scene<2> make_o1();
Scene<2> make_v1();
/** Returns constant strain under full contact, which is exact on every mesh. */
Scene<2> make_patch_test();
/** Returns an elastic block pressed on a parabolic foundation. */
Scene<2> make_block_on_parabola();
/** Returns smooth contact on a disc, in 3-D. */
Scene<3> make_d3();
/** Returns the same with a material that varies from point to point. */
Scene<3> make_v3();
} // namespace Signorini
