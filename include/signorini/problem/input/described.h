// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/problem/parameters/parameters.h>
#include <signorini/problem/scene/scene.h>

namespace Signorini
{
/** Returns the scene that a parameter file describes by expressions. @throws InputError */
template <int dim>
Scene<dim> make_described_scene(const Parameters &parameters);
} // namespace Signorini
