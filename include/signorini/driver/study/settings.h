// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/discretization/space/foreign_field.h>
#include <signorini/problem/parameters/parameters.h>
#include <signorini/problem/scene/scene.h>

#include <optional>

namespace Signorini {
/** Refuses settings that contradict the scene. @throws InputError */
template <int dim>
void check_settings(const Parameters &parameters, const Scene<dim> &scene);

/** Returns the displacement of Verify/File on the body; none where no file is given. @throws
 * InputError for everything that is none. */
std::optional<ForeignField> read_foreign_field(const Parameters &parameters, const Scene<2> &scene);
} // namespace Signorini
