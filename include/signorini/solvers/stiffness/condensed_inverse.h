// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/solvers/stiffness/stiffness_inverse.h>

#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <algorithm>
#include <map>
#include <memory>
#include <vector>

namespace Signorini {
/** The rows of a serial matrix, with columns in increasing order. */
struct Rows {
  explicit Rows(const TrilinosWrappers::SparseMatrix &A);

  bool same_pattern(const int i, const int j) const {
    return std::equal(column + start[i], column + start[i + 1], column + start[j],
                      column + start[j + 1]);
  }

  int n = 0;
  int *start = nullptr;
  int *column = nullptr;
  double *value = nullptr;
};

class CholeskyFactor;

/** The factors of a sparse symmetric positive definite matrix by CHOLMOD. */
class SparseCholesky {
public:
  /** @throws ComputationError if A is not positive definite or memory runs out. */
  explicit SparseCholesky(const Rows &A);
  ~SparseCholesky();

  /** Replaces x by A⁻¹ x. */
  void solve(std::vector<double> &x) const;

private:
  std::unique_ptr<CholeskyFactor> factor_;
};

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
  void apply(std::vector<Vector> &x, const std::vector<Vector> &b) const override;

  std::unique_ptr<CholeskyFactor> factor_;
  std::map<Index, unsigned int> rows_;
};
} // namespace Signorini
