// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/lac/vector.h>

namespace Signorini
{
/**
 * A without its entries, and one step of a solver for it. On one rank.
 *
 * Vectors have an entry for every degree of freedom of V^h in its numbering, in the user's units.
 * A is the stiffness after the essential conditions are eliminated, T^T A T: entries of arguments
 * in constrained rows are not read, those of results are zero.
 */
class StiffnessOperator
{
public:
  using Vector = dealii::Vector<double>;

  virtual ~StiffnessOperator() = default;

  /** The number of degrees of freedom. */
  virtual unsigned int size() const = 0;
  /** y = A x. */
  virtual void apply(Vector &y, const Vector &x) const = 0;
  /** z = V r with a fixed V = V^T, positive definite, close to A^{-1}: one V-cycle. */
  virtual void precondition(Vector &z, const Vector &r) const = 0;
};
} // namespace Signorini
