// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/driver/level/level.h>
#include <signorini/solvers/contact/dual_problem.h>
#include <signorini/solvers/kinematics/motion_modes.h>
#include <signorini/solvers/stiffness/stiffness_inverse.h>

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

/**
 * The energy norm of what a contact solver that stops at its tolerance leaves of the discrete
 * solution: for rho_k = P_k - min(0, P_k - W_k/C_kk), which the KKT residual consists of,
 *
 *     (c sum_k C_kk rho_k²)^{1/2}.
 *
 * Where the set of pressing patches is right, C (P - P*) = C_kk rho_k, and the energy of P - P* is
 * at most 1/lambda sum_k C_kk² rho_k² with the smallest eigenvalue lambda of C. c = C_kk/lambda is
 * below 6 for patches on a half-plane or half-space.
 * @param diagonal C_kk, zero where it is not known: where P_k = 0 and W_k <= 0.
 */
double algebraic_error(const dealii::Vector<double> &P,
                       const dealii::Vector<double> &W,
                       const dealii::Vector<double> &diagonal);

/** The same for P and U of the dual problem on a level. */
template <int dim>
double algebraic_error(const Parameters &parameters,
                       const Discretization<dim> &discretization,
                       const ComplianceOperator &C,
                       const LevelSolution<dim> &solution);

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
