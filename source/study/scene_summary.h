// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/output/level_record.h>
#include <signorini/parameters/parameters.h>
#include <signorini/scene/scene.h>

#include <ostream>
#include <vector>

namespace Signorini
{
/** The scene in five lines. */
template <int dim>
void print_scene(const Parameters &parameters, const Scene<dim> &scene, std::ostream &screen);

/** The finest level's contact and the verdict. */
void print_verdict(const Parameters &parameters,
                   const std::vector<LevelRecord> &levels,
                   bool certified,
                   std::ostream &screen);
} // namespace Signorini
