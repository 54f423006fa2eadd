// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/discretization/space/displaced_body.h>
#include <signorini/discretization/space/multiplier_space.h>
#include <signorini/results/verdict/exact_errors.h>

#include <optional>

namespace Signorini {
/**
 * Integrates the errors with @p n_points Gauss points per direction, on the pieces of cells that a
 * kink crosses. Needs Scene::exact_displacement. Runs on all threads given; the sums do not depend
 * on their number. Collective.
 * @throws InputError where the exact solution has no value.
 */
template <int dim>
DisplacementErrors compute_displacement_errors(const DisplacedBody<dim> &body,
                                               unsigned int n_points);

/**
 * Integrates with at least @p n_points Gauss points per direction on every piece, refined towards
 * kinks. Needs Scene::has_exact_pressure(), or the other exact functions of all contact sides.
 * @throws InputError where p has no value.
 */
template <int dim>
PressureErrors compute_pressure_errors(
  const MultiplierSpace<dim> &space, const Pressure &P, unsigned int n_points,
  FunctionPointer<dim> ContactCondition<dim>::*exact = &ContactCondition<dim>::exact_pressure);

/**
 * Returns the largest distance between an end of the exact contact zones and the nearest end of a
 * run of pressing patches, and the other way round (Hausdorff distance along the sides, length).
 *
 * Exact ends are searched at the kinks: p vanishes on one side of them only. The result is empty if
 * there are none, or if a side has ends of one kind only. Needs Scene::has_exact_pressure().
 */
std::optional<double> contact_end_error(const MultiplierSpace<2> &space, const Scene<2> &scene,
                                        const Pressure &P);
} // namespace Signorini
