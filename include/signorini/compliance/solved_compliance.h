// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/compliance/compliance.h>

namespace Signorini
{
/** C = D^T A^{-1} D by products, one solve each: for methods that ask for few products and for no
 * entries. Each column that is asked for costs a solve, too, and is not kept. */
class SolvedCompliance final : public ComplianceOperator
{
public:
  /** @param diagonal in place of C_kk, which would cost as many solves as there are patches; it
   * only scales the residual. All arguments must outlive the object. */
  SolvedCompliance(const StiffnessInverse &inverse, const Coupling &condensed_D, Vector diagonal);

  unsigned int size() const override;
  Vector apply(const Vector &P) const override;
  Vector diagonal() const override;
  Matrix columns(const Indices &numbers) const override;
  const Matrix &dense() const override;
  bool is_explicit() const override;

private:
  const StiffnessInverse &inverse_;
  const Coupling &D_;
  Vector diagonal_;
  /** Made when it is first asked for. */
  mutable Matrix dense_;
};
} // namespace Signorini
