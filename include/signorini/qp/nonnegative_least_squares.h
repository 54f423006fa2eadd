// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <vector>

namespace Signorini
{
/** A y for the y >= 0 with the smallest |b - A y|. */
struct ConeProjection
{
  /** The columns with y > 0, and y there. */
  std::vector<unsigned int> columns;
  dealii::Vector<double> weights;
  /** b - A y. */
  dealii::Vector<double> remainder;
};

/** See remainder_outside_cone(). */
ConeProjection project_on_cone(const dealii::FullMatrix<double> &A,
                               const dealii::Vector<double> &b,
                               double rounding);

/**
 * b - A y for the y >= 0 with the smallest |b - A y|: what is left of b outside of the cone of the
 * columns of A, n x m with small n. Columns have norm one. The remainder r satisfies A^T r <= 0 and
 * r.b = |r|^2. (C. L. Lawson, R. J. Hanson: Solving Least Squares Problems, 1974, chapter 23.)
 *
 * @param rounding relative to |b|: a column joins only if it lessens the residual by more.
 */
dealii::Vector<double> remainder_outside_cone(const dealii::FullMatrix<double> &A,
                                              const dealii::Vector<double> &b,
                                              double rounding);
} // namespace Signorini
