// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/error_control/equilibration/traction_mesh.h>
#include <signorini/error_control/loads/bound_data.h>
#include <signorini/error_control/loads/prescribed_lift.h>

#include <array>
#include <functional>
#include <map>
#include <vector>

namespace Signorini {
/** What the bound of a displacement v needs of it: with a translation c and a stress τ with
 * div τ + f_K = 0,
 *
 *     ‖σ(v) - τ‖² = |||v|||² - 2 ∫ f_K.(v - c) - 2 ∫_Γ τ n.(v - c) + ‖τ‖².
 *
 * v is u_h + z or π^{2h} u_h + z' with the PrescribedLift: v = u_D where that is given.
 */
struct FieldIntegrals {
  /** |||v|||² and ∫ f_K.(v - c) (force x length per thickness). */
  double strain = 0., load = 0.;
  /** The integrals of (v - c)_n and (v - c)_t times Legendre's polynomials, by coefficients of
   * edges on Γ. */
  dealii::Vector<double> moments;
  /** |||z|||. */
  double lift = 0.;

  /** Returns |||v|||² - 2 ∫ f_K.(v - c) - 2 ∫_Γ τ n.(v - c) for the τ with the coefficients x, and
   * the sum of the sizes of all terms. */
  std::array<double, 2> without_stress(const dealii::Vector<double> &x) const;
};

/** The integrals of u_h and of π^{2h} u_h; those of the second are zero where cells have no
 * parents. */
struct FieldsOfLevel {
  /** The translation c. */
  Tensor<1, 2> translation;
  FieldIntegrals u_h, post;
  /** The norms |||π^{2h} u_h - u_h|||_K by active cell; where cells have no parents |||u_h|||_K. */
  dealii::Vector<double> distances;
  /** The values of π^{2h} u_h - u_h in the middles of boundary faces, by line. */
  std::map<unsigned int, Tensor<1, 2>> bubbles;
};

/** Returns f_K at points of a cell of the mesh of u_h. */
using CellForce = std::function<std::vector<Tensor<1, 2>>(
  const Triangulation<2>::active_cell_iterator &, const std::vector<Point<2>> &)>;

/** Returns the rest of what is prescribed, for u_h + bubbles. @param bubbles as in FieldsOfLevel;
 * empty for u_h. */
PrescribedLift lift_of(const BoundData &data,
                       const std::map<unsigned int, Tensor<1, 2>> &bubbles = {});

/** Returns the norms |||z|||_K by cell. @param field receives what z adds, unless it is null.
 * @param n_generations 1 for π^{2h} u_h, 0 for u_h. */
dealii::Vector<double> add_lift(const BoundData &data, const PrescribedLift &lift,
                                unsigned int n_generations, const CellForce &force,
                                FieldIntegrals *field);

/** Integrates u_h and π^{2h} u_h on a mesh that is not graded; a curved one is taken with straight
 * edges.
 * @param lift lift_of(data).
 * @param force f_K, or empty without a body force. Collective. */
FieldsOfLevel integrate_fields(const BoundData &data, const TractionMesh &mesh,
                               const PrescribedLift &lift, const Tensor<1, 2> &translation,
                               const CellForce &force);
} // namespace Signorini
