// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/stiffness_inverse/stiffness_inverse.h>

#include <deal.II/lac/lapack_full_matrix.h>

#include <map>

namespace Signorini
{
/**
 * A = L L^T by CHOLMOD's supernodal Cholesky factorisation, on one rank, with chosen unknowns
 * eliminated last. Written in blocks, 2 the chosen unknowns,
 *
 *     A = (A_11 A_21^T)   L = (L_11     )   S = A_22 - A_21 A_11^{-1} A_21^T = L_22 L_22^T,
 *         (A_21 A_22  ),      (L_21 L_22),
 *
 * so that (A^{-1})_22 = S^{-1} is known without a single solve.
 */
class CondensedInverse final : public StiffnessInverse
{
public:
  using Index = dealii::types::global_dof_index;

  /**
   * @param last the unknowns of block 2, without repetitions; may be empty.
   * @throws ComputationError if A is not positive definite or memory runs out.
   */
  CondensedInverse(const dealii::TrilinosWrappers::SparseMatrix &A, const std::vector<Index> &last);
  ~CondensedInverse() override;

  /** L_22, lower triangular, as many rows as there are chosen unknowns. */
  dealii::LAPACKFullMatrix<double> schur_factor() const;
  /** Whether all @p unknowns belong to block 2. */
  bool eliminates_last(const std::vector<Index> &unknowns) const;
  /** The row of L_22 that belongs to an unknown. @throws std::out_of_range if it was not chosen. */
  unsigned int schur_row(const Index unknown) const
  {
    return schur_rows_.at(unknown);
  }

private:
  class Factor;

  void apply(Vector &x, const Vector &b) const override;

  std::unique_ptr<Factor> factor_;
  std::map<Index, unsigned int> schur_rows_;
};
} // namespace Signorini
