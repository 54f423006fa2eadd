// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/qp/bound_constrained_qp.h>

namespace Signorini
{
/** What the active set method is told. */
struct ActiveSetOptions
{
  /** For the KKT residual. */
  double tolerance = 1e-10;
  /** Linear solves before giving up. */
  unsigned int maximum_iterations = 100000;
};

/**
 * Primal-dual active set method, i.e. the semi-smooth Newton method for
 * P = min(bound, P - W/diag C): patch i is active (in contact) iff P_i - W_i/C_ii < bound_i. With
 * the active set A,  C_AA P_A = F_A - C_AI bound_I,  P_I = bound_I.
 *
 * It ends when a set predicts itself, or when the residual is at the level of rounding (where P and
 * W vanish together on many patches, the sets could differ for ever). When a set comes back, single
 * exchanges (the lowest wrong index changes sides, Murty's rule) end the search: for positive
 * definite C no set can come back under that rule.
 *
 * @param start the first active set is taken from it; empty: every patch is active.
 */
QPResult solve_by_active_set(const BoundConstrainedQP &qp,
                             const dealii::Vector<double> &start,
                             const ActiveSetOptions &options);
} // namespace Signorini
