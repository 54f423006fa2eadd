// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/problem/parameters/parameters.h>
#include <signorini/problem/scene/scene.h>

namespace Signorini {
/** Refuses settings that contradict the scene. @throws InputError */
template <int dim>
void check_settings(const Parameters &parameters, const Scene<dim> &scene);
} // namespace Signorini
