// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/qp/compliance_operator.h>
#include <signorini/qp/small_matrix.h>

#include <memory>

namespace Signorini
{
/**
 * C + B Q^{-1} B^T: the compliance of a body that also moves by B z against a stiffness Q, n x n,
 * positive definite. Asks for the same columns of C as it is asked for.
 */
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
  /** Entry (i, j) of B Q^{-1} B^T. */
  double by_motion(unsigned int i, unsigned int j) const;

  std::shared_ptr<const ComplianceOperator> C_;
  /** V V^T = B Q^{-1} B^T, m x n. */
  Matrix V_;
  /** Empty until it is asked for. */
  mutable Matrix dense_;
};
} // namespace Signorini
