// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/solvers/contact/dual_problem.h>
#include <signorini/solvers/kinematics/pressing_patches.h>
#include <signorini/solvers/kinematics/seen_motions.h>

#include <memory>
#include <optional>

namespace Signorini
{
/**
 * Solves the dual problem with separate springs, C = diag(c): P_i = -(B_i z - F_i)_+/c_i, where z
 * minimises
 *
 * 1/2 Σ_i (B_i z - F_i)_+^2/c_i + 1/2 z.K z - b.z
 *
 * (Winkler's bedding), by Newton's method with a line search. The solution is a start for the true
 * compliance. It carries the load b, so its pressing patches can carry b, too.
 */
MotionState solve_on_bedding(const ReducedMotions &motions,
                             const dealii::Vector<double> &F,
                             const dealii::Vector<double> &c);

/** The compliance C + B Q⁻¹ Bᵀ of a body that also moves by B z against a stiffness Q, n x n,
 * positive definite. It needs the same columns of C as its caller needs of it. */
class StiffenedCompliance final : public ComplianceOperator
{
public:
  StiffenedCompliance(std::shared_ptr<const ComplianceOperator> C,
                      const Matrix &B,
                      const SmallCholesky &Q);

  unsigned int size() const override;
  Vector apply(const Vector &P) const override;
  Vector diagonal() const override;
  Matrix columns(const Indices &numbers) const override;
  const Matrix &dense() const override;
  bool is_explicit() const override;

private:
  /** Returns entry (i, j) of B Q⁻¹ Bᵀ. */
  double by_motion(unsigned int i, unsigned int j) const;

  std::shared_ptr<const ComplianceOperator> C_;
  /** The factor V in V Vᵀ = B Q⁻¹ Bᵀ, m x n. */
  Matrix V_;
  /** The dense matrix, empty until its first use. */
  mutable Matrix dense_;
};

/**
 * Solves the dual problem with free motions by a primal active set method, for problems on which
 * proximal iteration does not settle: bodies that are nearly rigid compared with the gaps that they
 * close.
 *
 * The method begins with a pressure in balance, on as few patches as there are motions, and solves
 * exactly on the patches that press (solve_on_pressing()). Where a patch would pull, the step ends
 * at the first zero, and the patch leaves. Where the exact solution presses everywhere, the patch
 * with the largest penetration joins. The energy 1/2 Pᵀ C P - Pᵀ F falls in every step, so no set
 * comes back (J. Nocedal, S. Wright: Numerical Optimization, 2006, section 16.5).
 *
 * @param max_solves the limit of the number of solves.
 * @param n_solves counts the solves.
 * @return nothing if there is no pressure in balance or the steps do not end.
 */
std::optional<MotionState> descend(const ComplianceOperator &C,
                                   const dealii::Vector<double> &F,
                                   const ReducedMotions &motions,
                                   unsigned int max_solves,
                                   unsigned int &n_solves);
} // namespace Signorini
