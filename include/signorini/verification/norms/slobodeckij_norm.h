// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>

#include <deal.II/lac/lapack_full_matrix.h>

#include <vector>

namespace Signorini {
/** Returns the Gram matrix of the seminorm |v|_{1/2}, the double integral below, for the piecewise
 * linear functions on a uniform grid. It does not depend on the length. */
LAPACKFullMatrix<double> seminorm_matrix(unsigned int n_cells);

/**
 * The paper's norm on one side of length L: the dual of
 *
 *     ‖v‖²_{1/2} = ‖v‖²_0 + ∫∫ (v(x) - v(y))² / (x - y)² dx dy,
 *
 * taken over the piecewise linear v on a uniform grid of n_cells cells: ‖q‖² = bᵀ G⁻¹ b,  b_j =
 * ∫ q φ_j,  G the Gram matrix of ‖.‖_{1/2}. This is a lower bound that grows with the grid. It
 * costs n_cells³/3 operations.
 */
class SlobodeckijNorm {
public:
  SlobodeckijNorm(double length, unsigned int n_cells);

  /** Returns the norm of a function given at quadrature points by value times weight. */
  double dual_norm(const std::vector<double> &arc_lengths,
                   const std::vector<double> &weighted_values) const;

  unsigned int n_cells() const {
    return n_cells_;
  }

private:
  double length_;
  unsigned int n_cells_;
  /** The Cholesky factor of G. */
  LAPACKFullMatrix<double> factor_;
};
} // namespace Signorini
