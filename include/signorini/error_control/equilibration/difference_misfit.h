// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/error_control/equilibration/equilibrated_stress.h>
#include <signorini/error_control/equilibration/prescribed_lift.h>
#include <signorini/error_control/equilibration/stress_bound.h>

namespace Signorini {
/** ‖σ(u_h) - τ‖ of a stress on the mesh of u_h, from the differences on cells: it loses no digits.
 */
class DifferenceMisfit {
public:
  /** Fits are compared with σ(u_h). */
  static constexpr bool compares = true;
  /** It needs no integrals of u_h on a mesh of the stress. */
  struct Works {};

  explicit DifferenceMisfit(const BoundData &data);

  Works works(const EquilibrationMesh & /*mesh*/, const EquilibratedStress & /*stress*/) const {
    return {};
  }
  /** Returns the work of the coefficients of tractions on the boundary values of u_h, as far as
   * fits do not know it. */
  dealii::Vector<double> moments(const EquilibratedStress &stress, const Works & /*works*/) const {
    return dealii::Vector<double>(stress.tractions.x.size());
  }
  /** Returns ‖σ(u_h) - τ‖_K for the best tractions on the edges of a cell. */
  static double least(const CellFit &fit) {
    return fit.size * fit.rest;
  }
  /** Returns allowed_load(), or less, before tractions are known. */
  double expected(const EquilibratedStress &stress) const;
  /** Returns ‖σ(u_h) - τ‖. */
  double allowed_load(const EquilibratedStress &stress, const Works &works) const;
  StressBound bound(const EquilibratedStress &stress, const Works &works) const;

private:
  const BoundData &data_;
  PrescribedLift lift_;
  /** The norms |||z|||_K. */
  dealii::Vector<double> lift_norms_;
};
} // namespace Signorini
