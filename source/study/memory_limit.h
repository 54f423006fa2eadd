// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/parameters/parameters.h>
#include <signorini/scene/scene.h>

namespace Signorini
{
/**
 * Refuses levels that cannot fit into this machine's memory before they are started, by a low
 * estimate of what a direct factorisation takes. With a target error the finest level is a limit
 * that need not be reached, and is let through.
 * @throws InputError with the estimated need.
 */
template <int dim>
void refuse_huge_levels(const Parameters &parameters, const Scene<dim> &scene);
} // namespace Signorini
