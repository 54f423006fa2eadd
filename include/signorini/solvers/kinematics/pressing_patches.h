// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/solvers/contact/dual_problem.h>
#include <signorini/solvers/kinematics/seen_motions.h>

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <optional>
#include <vector>

namespace Signorini
{
/** The projection A y of b onto a cone, for the y ≥ 0 with the smallest |b - A y|. */
struct ConeProjection
{
  /** The columns with y > 0, and the values of y there. */
  std::vector<unsigned int> columns;
  dealii::Vector<double> weights;
  /** The remainder b - A y. */
  dealii::Vector<double> remainder;
};

/** Returns the projection, see remainder_outside_cone(). */
ConeProjection project_on_cone(const FullMatrix<double> &A,
                               const dealii::Vector<double> &b,
                               double rounding);

/**
 * Returns b - A y for the y ≥ 0 with the smallest |b - A y|: the remainder of b outside of the
 * cone of the columns of A, n x m with small n. Columns have norm one. The remainder r satisfies
 * Aᵀ r ≤ 0 and r.b = |r|². (C. L. Lawson, R. J. Hanson: Solving Least Squares Problems, 1974,
 * chapter 23.)
 *
 * @param rounding relative to |b|: a column joins only if it lessens the residual by more.
 */
dealii::Vector<double> remainder_outside_cone(const FullMatrix<double> &A,
                                              const dealii::Vector<double> &b,
                                              double rounding);

/** A pressure P and motions z, in the coordinates of ReducedMotions. */
struct MotionState
{
  dealii::Vector<double> P;
  dealii::Vector<double> z;
};

/** Returns the patches with P < 0, in ascending order. */
ComplianceOperator::Indices pressing_patches(const dealii::Vector<double> &P);

/** The result of solve_on_pressing(). */
struct PressingSolution
{
  /** The pressure and the motions. P may be positive. */
  MotionState state;
  /** The stiffness B_Aᵀ C_AA⁻¹ B_A, n x n, of the unit 1/C. */
  FullMatrix<double> stiffness;
};

/**
 * Solves exactly with the patches A that press in @p start:
 *
 * C_AA P_A + B_A z = F_A,   K z - B_Aᵀ P_A = b,   P = 0 elsewhere.
 *
 * C_AA is factorised, and z follows from (K + B_Aᵀ C_AA⁻¹ B_A + δ) dz = imbalance; the
 * remainders of both equations are then solved for again. δ, 1e-9 of the stiffness, leaves
 * motions unchanged that the patches of A do not resist (a body that tips about one edge). Where
 * C_AA is singular within rounding, its diagonal grows by 1e-8, and parts of P in the kernel of C
 * stay those of the start.
 *
 * @return nothing if nothing presses, or the patches of A and K leave a motion without resistance
 * so that the equation for dz has no solution.
 */
std::optional<PressingSolution> solve_on_pressing(const ComplianceOperator &C,
                                                  const dealii::Vector<double> &F,
                                                  const ReducedMotions &motions,
                                                  const MotionState &start);
} // namespace Signorini
