// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/solvers/stiffness/stiffness_inverse.h>

#include <map>

namespace Signorini {
/** The inverse of A = L Lᵀ by CHOLMOD's supernodal Cholesky factorisation, serial, with chosen
 * unknowns eliminated last. */
class CondensedInverse final : public MatrixInverse {
public:
  /**
   * Factorises A.
   * @param last the chosen unknowns, without repetitions; may be empty.
   * @throws ComputationError if A is not positive definite or memory runs out.
   */
  CondensedInverse(const TrilinosWrappers::SparseMatrix &matrix, double unit,
                   const std::vector<Index> &last);
  ~CondensedInverse() override;

  std::optional<TrailingFactor> trailing_factor(const std::vector<Index> &unknowns) const override;

private:
  class Factor;

  void apply(std::vector<Vector> &x, const std::vector<Vector> &b) const override;

  std::unique_ptr<Factor> factor_;
  std::map<Index, unsigned int> rows_;
};
} // namespace Signorini
