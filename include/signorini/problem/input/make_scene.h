// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/problem/parameters/parameters.h>
#include <signorini/problem/scene/scene.h>

namespace Signorini
{
/** 2 or 3: what the parameters say, or that of a scene of the catalogue. */
unsigned int dimension_of(const Parameters &parameters);

/** The scene that the parameters name or describe. @throws InputError */
template <int dim>
Scene<dim> make_scene(const Parameters &parameters);
template <>
Scene<2> make_scene(const Parameters &parameters);
template <>
Scene<3> make_scene(const Parameters &parameters);
} // namespace Signorini
