// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/driver/study/study.h>

namespace Signorini {
/**
 * Shows a scene without solving it: prints its sides with their roles and data, and the cost of
 * a run, writes scene.json, and draws it. Earlier results stay in the directory. Collective.
 * @throws InputError for contradictions, and for levels that do not fit into memory.
 */
template <int dim>
void show_scene(const Parameters &parameters, Scene<dim> scene, MPI_Comm communicator,
                const StudyReport &report);
} // namespace Signorini
