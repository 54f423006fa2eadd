// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/solvers/contact/dual_problem.h>

#include <functional>

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

/** z on a set of indices, z = M^{-1} r with M close to C there, symmetric positive definite. */
using SetPreconditioner = std::function<dealii::Vector<double>(const std::vector<unsigned int> &set,
                                                               const dealii::Vector<double> &r)>;

/** What MPRGP is told. */
struct MprgpOptions
{
  /** For the KKT residual. */
  double tolerance = 1e-10;
  /** Products with C before giving up. */
  unsigned int maximum_iterations = 100000;
  /** Of C restricted to the free set, where P is inside of K; empty: none. */
  SetPreconditioner preconditioner = {};
};

/**
 * MPRGP, modified proportioning with reduced gradient projections (Dostal and Schoeberl, Comput.
 * Optim. Appl. 30 (2005) 23-43), with preconditioning in the face: conjugate gradients on the free
 * set while the free gradient outweighs what the active set could gain; a step along that gain
 * otherwise; where a bound stops a step, a projected gradient step of the length 1.9/|C| behind it.
 * |C| is estimated by ten steps of the power method.
 *
 * QPResult::iterations counts products with C; nothing else of C is needed but its diagonal.
 */
QPResult solve_by_mprgp(const BoundConstrainedQP &qp,
                        const dealii::Vector<double> &start,
                        const MprgpOptions &options);
} // namespace Signorini
