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
std::optional<double> contact_end_error(const MultiplierSpace<2> &space,
                                        const Scene<2> &scene,
                                        const dealii::Vector<double> &P);

/** In space contact ends along curves: there is no such number. */
inline std::optional<double> contact_end_error(const MultiplierSpace<3> & /*space*/,
                                               const Scene<3> & /*scene*/,
                                               const dealii::Vector<double> & /*P*/)
{
  return {};
}
} // namespace Signorini
