// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/motions/motion_modes.h>
#include <signorini/qp/compliance_operator.h>
#include <signorini/stiffness_inverse/stiffness_inverse.h>
#include <signorini/study/level.h>

#include <memory>

namespace Signorini
{
/** P of the dual problem, which C P and C_kk P_k go with. */
struct Pressure
{
  dealii::Vector<double> P, C_P, diagonal_P;
  /** Empty where nothing touches. */
  std::shared_ptr<const ComplianceOperator> C;
  /** F of the last correct_rounding(). */
  dealii::Vector<double> corrected_F;
};

/** C, P and q: only where something touches, or where motions are free. @throws InputError if
 * contact cannot hold the body. */
template <int dim>
Pressure find_pressure(const Parameters &parameters,
                       const Discretization<dim> &discretization,
                       const StiffnessInverse &inverse,
                       const MotionModes<dim> &modes,
                       const dealii::Vector<double> &start,
                       const Progress &progress,
                       LevelSolution<dim> &solution);

/** U = A^{-1}(f + D P) + Z q. */
template <int dim>
NodalVector recover(const Discretization<dim> &discretization,
                    const StiffnessInverse &inverse,
                    const MotionModes<dim> &modes,
                    const DistributedVector &f,
                    const LevelSolution<dim> &solution);

/**
 * Openings by U and by C differ where rounding has spoilt C: D^T U - G is C P + B q - F + r. Then F
 * - r takes the place of F, up to three times. Only what rounding has done is corrected: without it
 * r is zero, however P was found.
 */
template <int dim>
void correct_rounding(const Parameters &parameters,
                      const Discretization<dim> &discretization,
                      const StiffnessInverse &inverse,
                      const MotionModes<dim> &modes,
                      const DistributedVector &f,
                      Pressure &pressure,
                      LevelSolution<dim> &solution);
} // namespace Signorini
