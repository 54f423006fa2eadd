// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/columns.h>
#include <signorini/discretization/multiplier/multiplier_space.h>

#include <optional>

namespace Signorini
{
/** The distances of the discrete from the exact contact pressure. */
struct PressureErrors
{
  /** The error ‖p - p_H‖_{0,Γ_c}. */
  double l2;
  /** The error of the continuous pressure recovered from p_H. */
  double post_l2;

  static Columns<PressureErrors> columns();
};

/**
 * Integrates with at least @p n_points Gauss points per direction on every piece, refined towards
 * kinks. Needs Scene::has_exact_pressure().
 * @throws InputError where p has no value.
 */
template <int dim>
PressureErrors compute_pressure_errors(const MultiplierSpace<dim> &space,
                                       const Pressure &P,
                                       unsigned int n_points);

/**
 * Returns the largest distance between an end of the exact contact zones and the nearest end of a
 * run of pressing patches, and the other way round (Hausdorff distance along the sides, length).
 *
 * Exact ends are searched at the kinks: p vanishes on one side of them only. The result is empty if
 * there are none, or if a side has ends of one kind only. Needs Scene::has_exact_pressure().
 */
std::optional<double> contact_end_error(const MultiplierSpace<2> &space,
                                        const Scene<2> &scene,
                                        const Pressure &P);

/** Returns nothing: in 3-D contact ends along curves, and there is no such number. */
inline std::optional<double> contact_end_error(const MultiplierSpace<3> & /*space*/,
                                               const Scene<3> & /*scene*/,
                                               const dealii::Vector<double> & /*P*/)
{
  return {};
}
} // namespace Signorini
