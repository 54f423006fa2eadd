// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/options.h>

#include <deal.II/lac/trilinos_sparse_matrix.h>
#include <deal.II/lac/trilinos_vector.h>

#include <memory>
#include <vector>

namespace Signorini
{
/** A^{-1}, factorised once and applied many times. */
class StiffnessInverse
{
public:
  using Vector = dealii::TrilinosWrappers::MPI::Vector;

  virtual ~StiffnessInverse() = default;

  /**
   * x = A^{-1} b. The residual of every solve is computed. Where it is not small, one step of
   * iterative refinement is taken; its size tells how many digits of x rounding has spoilt.
   * Collective.
   * @throws ComputationError if fewer than four digits are left.
   */
  void solve(Vector &x, const Vector &b) const;

  /** How many times solve() was called. */
  unsigned int n_solves() const
  {
    return n_solves_;
  }
  /** The largest |b - A x| / |b| so far, in the norm |r|^2 = sum r_i^2 / A_ii. */
  double largest_residual() const
  {
    return largest_residual_;
  }
  /** The largest relative error of an x so far that is due to rounding, as far as it was estimated:
   * 0 where residuals were small. */
  double rounding_error() const
  {
    return rounding_error_;
  }

protected:
  explicit StiffnessInverse(const dealii::TrilinosWrappers::SparseMatrix &A);

  /**
   * One solve, not counted, for a b that no kernel is orthogonal to: factors of a singular matrix
   * betray themselves there, but not for loads in its range. Derived classes call it once, unless
   * their pivots show that A is regular.
   * @throws ComputationError
   */
  void refuse_singular_matrix() const;

private:
  /** x = A^{-1} b by the factors alone. */
  virtual void apply(Vector &x, const Vector &b) const = 0;

  /** (sum r_i^2 / A_ii)^{1/2}: rows of stiff and of soft parts of a body count alike. */
  double scaled_norm(const Vector &r) const;
  /** Adds A^{-1} r to x. @return the size of that correction relative to x. */
  double refine(Vector &x, const Vector &r) const;

  const dealii::TrilinosWrappers::SparseMatrix &A_;
  /** A_ii^{-1/2}. */
  Vector scaling_;
  mutable unsigned int n_solves_ = 0;
  mutable double largest_residual_ = 0.;
  mutable double rounding_error_ = 0.;
};

/** What automatic stands for on so many ranks: condensed on one, amesos_mumps on several. */
LinearSolver resolve(LinearSolver solver, unsigned int n_ranks);

/**
 * Factorises A, which must outlive the result. condensed works on one rank only.
 *
 * @param contact_unknowns those that the contact pressure acts on; the condensed factorisation
 *   eliminates them last. Collective.
 * @throws ComputationError if the factorisation fails.
 */
std::unique_ptr<StiffnessInverse>
factorise(const dealii::TrilinosWrappers::SparseMatrix &A,
          LinearSolver solver,
          const std::vector<dealii::types::global_dof_index> &contact_unknowns = {});
} // namespace Signorini
