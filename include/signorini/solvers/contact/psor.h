// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/solvers/contact/dual_problem.h>

namespace Signorini
{
/** What projected SOR is told. */
struct PsorOptions
{
  /** omega, 0 < omega < 2. */
  double relaxation = 1.1;
  /** For the increment and for the KKT residual. */
  double tolerance = 1e-10;
  unsigned int maximum_iterations = 100000;
};

/** One sweep (ii) of the algorithm, in place. @return |P^{k+1} - P^k|_2. */
double psor_sweep(const BoundConstrainedQP &qp, double relaxation, dealii::Vector<double> &P);

/**
 * The algorithm (i)-(iii):  lambda_i = -(sum_{j<i} C_ij P_j^{k+1} + sum_{j>i} C_ij P_j^k -
 * F_i)/C_ii, P_i^{k+1} = projection of (1 - omega) P_i^k + omega lambda_i onto K.
 *
 * It stops when |P^{k+1} - P^k| <= tolerance |P^{k+1}| and the KKT residual is below the tolerance,
 * and goes on while the increments fall so slowly that the error, estimated from them, is above 50
 * times the tolerance.
 * @throws std::invalid_argument for omega outside (0, 2).
 */
QPResult solve_by_psor(const BoundConstrainedQP &qp,
                       const dealii::Vector<double> &start,
                       const PsorOptions &options);
} // namespace Signorini
