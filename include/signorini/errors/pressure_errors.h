// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/columns.h>
#include <signorini/multiplier/multiplier_space.h>

namespace Signorini
{
/** Distances of the discrete from the exact contact pressure. */
struct PressureErrors
{
  /** ‖p - p_H‖_{0,Gamma_c}. */
  double l2;
  /** The same for the continuous pressure recovered from p_H. */
  double post_l2;

  static Columns<PressureErrors> columns();
};

/**
 * Integrates with at least @p n_points Gauss points per direction on every piece, refined towards
 * kinks. Needs Scene::has_exact_pressure(). @throws InputError where p has no value.
 */
template <int dim>
PressureErrors compute_pressure_errors(const MultiplierSpace<dim> &space,
                                       const dealii::Vector<double> &P,
                                       unsigned int n_points);
} // namespace Signorini
