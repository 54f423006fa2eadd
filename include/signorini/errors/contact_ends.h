// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/multiplier/multiplier_space.h>

#include <optional>

namespace Signorini
{
/**
 * The largest distance between an end of the exact contact zones and the nearest end of a run of
 * pressing patches, and the other way round (Hausdorff distance along the sides, length).
 *
 * Exact ends are looked for at the kinks: p vanishes on one side of them only. Empty if there are
 * none, or if a side has ends of one kind only. Needs Scene::has_exact_pressure().
 */
template <int dim>
std::optional<double> contact_end_error(const MultiplierSpace<dim> &space,
                                        const Scene<dim> &scene,
                                        const dealii::Vector<double> &P);
} // namespace Signorini
