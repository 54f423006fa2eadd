// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/lac/trilinos_sparse_matrix.h>
#include <deal.II/lac/trilinos_vector.h>

#include <memory>
#include <string>
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
   * x = A^{-1} b. The residual of every solve is computed; one step of iterative refinement is
   * taken when it is larger than rounding explains. Collective.
   * @throws ComputationError if |b - A x| > 1e-8 |b| remains.
   */
  void solve(Vector &x, const Vector &b) const;

  /** How many times solve() was called. */
  unsigned int n_solves() const
  {
    return n_solves_;
  }
  /** The largest |b - A x| / |b| so far. */
  double largest_residual() const
  {
    return largest_residual_;
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

  const dealii::TrilinosWrappers::SparseMatrix &A_;
  /** Largest sum of a row. */
  double norm_of_A_;
  mutable unsigned int n_solves_ = 0;
  mutable double largest_residual_ = 0.;
};

/**
 * Factorises A, which must outlive the result. @p name is a value of Solver/Linear solver;
 * automatic is condensed on one rank and amesos_mumps on several.
 *
 * @param contact_unknowns those that the contact pressure acts on; the condensed factorisation
 *   eliminates them last. Collective.
 * @throws InputError if @p name does not work on so many ranks, ComputationError if the
 *   factorisation fails.
 */
std::unique_ptr<StiffnessInverse>
factorise(const dealii::TrilinosWrappers::SparseMatrix &A,
          const std::string &name,
          const std::vector<dealii::types::global_dof_index> &contact_unknowns = {});
} // namespace Signorini
