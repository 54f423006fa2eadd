// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/compliance/compliance.h>

#include <vector>

namespace Signorini
{
/**
 * C = D^T A^{-1} D by columns C_k = D^T A^{-1} D_k, one solve each, computed when they are asked
 * for and kept. Columns are symmetrised among each other.
 */
class ColumnCompliance final : public ComplianceOperator
{
public:
  ColumnCompliance(const StiffnessInverse &inverse,
                   const Coupling &condensed_D,
                   double &seconds,
                   ColumnProgress progress);

  unsigned int size() const override;
  /** Asks for the columns with P_k != 0. */
  Vector apply(const Vector &P) const override;
  /** Asks for all columns. */
  Vector diagonal() const override;
  Matrix columns(const Indices &numbers) const override;
  const Matrix &dense() const override;
  bool is_explicit() const override;

private:
  /** Computes what is missing of the given columns. */
  void require(const Indices &numbers) const;
  /** D^T A^{-1} D_k for the given k, m x n. */
  Matrix solve_for(const Indices &numbers) const;
  Indices all() const;

  const StiffnessInverse &inverse_;
  const Coupling &D_;
  double &seconds_;
  ColumnProgress progress_;
  /** Columns and rows of the known numbers. */
  mutable Matrix C_;
  mutable std::vector<bool> known_;
  mutable unsigned int n_known_ = 0;
};
} // namespace Signorini
