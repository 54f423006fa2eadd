// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/columns.h>
#include <signorini/discretization/space/displaced_body.h>

#include <optional>

namespace Signorini {
/** The distances of the discrete from the exact displacement; h1 is the full norm ‖.‖_{1,Ω}. */
struct DisplacementErrors {
  /** The error ‖u - u_h‖_{1,Ω}. */
  double h1;
  /** The error ‖u - u_h‖_{0,Ω}. */
  double l2;
  /** The distance ‖I^h u - u_h‖_{1,Ω}. */
  double superclose_h1;
  /** The error ‖u - π^{2h} u_h‖_{1,Ω}; empty where there is no T^{2h}. */
  std::optional<double> post_h1;
  /** The error ‖u - π₄^{4h} u_h‖_{1,Ω} of the interpolation of degree four on cells of
   * T^{4h}; empty where there is no T^{4h}. */
  std::optional<double> post4_h1;
  /** The error |||u - u_h|||, with the strain of u_h itself and Hooke's tensor at quadrature points
   * (root of force x length^{dim-1}). */
  double energy = 0.;

  static Columns<DisplacementErrors> columns();
};

/**
 * Integrates the errors with @p n_points Gauss points per direction, on the pieces of cells that a
 * kink crosses. Needs Scene::exact_displacement. Runs on all threads given; the sums do not depend
 * on their number. Collective.
 * @throws InputError where the exact solution has no value.
 */
template <int dim>
DisplacementErrors compute_displacement_errors(const DisplacedBody<dim> &body,
                                               unsigned int n_points);

/** The distances of the discrete from the exact contact pressure. */
struct PressureErrors {
  /** The error ‖p - p_H‖_{0,Γ_c}. */
  double l2;
  /** The error of the continuous pressure recovered from p_H. */
  double post_l2;

  static Columns<PressureErrors> columns();
};

/**
 * Integrates with at least @p n_points Gauss points per direction on every piece, refined towards
 * kinks. Needs Scene::has_exact_pressure(), or the other exact functions of all contact sides.
 * @throws InputError where p has no value.
 */
template <int dim>
PressureErrors compute_pressure_errors(
  const MultiplierSpace<dim> &space, const Pressure &P, unsigned int n_points,
  FunctionPointer<dim> BoundaryCondition<dim>::*exact = &BoundaryCondition<dim>::exact_pressure);

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
