// SPDX-License-Identifier: LGPL-2.1-or-later
// Projected successive over-relaxation, algorithm (i)-(iii).

#include <signorini/solvers/contact/psor.h>

#include <cmath>
#include <stdexcept>

namespace Signorini
{
double psor_sweep(const BoundConstrainedQP &qp, const double relaxation, dealii::Vector<double> &P)
{
  const dealii::FullMatrix<double> &C = qp.C->dense();
  double squared_increment = 0.;
  for (unsigned int i = 0; i < qp.size(); ++i)
  {
    const double *row = &C(i, 0);
    double CP_i = 0.;
    for (unsigned int j = 0; j < qp.size(); ++j)
      CP_i += row[j] * P[j];
    const double lambda = P[i] - (CP_i - qp.F[i]) / row[i];
    const double relaxed = (1. - relaxation) * P[i] + relaxation * lambda;
    const double projected = qp.K.project(i, relaxed);
    squared_increment += (projected - P[i]) * (projected - P[i]);
    P[i] = projected;
  }
  return std::sqrt(squared_increment);
}

QPResult solve_by_psor(const BoundConstrainedQP &qp,
                       const dealii::Vector<double> &start,
                       const PsorOptions &options)
{
  if (!(options.relaxation > 0. && options.relaxation < 2.))
    throw std::invalid_argument("Projected SOR converges for relaxations between 0 and 2 only.");
  QPResult result;
  result.P = start;
  qp.K.project(result.P);
  result.converged = qp.size() == 0; // nothing to do
  double last_increment = 0.;
  while (result.iterations < options.maximum_iterations && !result.converged)
  {
    ++result.iterations;
    const double increment = psor_sweep(qp, options.relaxation, result.P);
    const double small = options.tolerance * result.P.l2_norm();
    if (increment <= small)
    {
      if (result.increment_iterations == 0)
        result.increment_iterations = result.iterations;
      // The increments fall like rho^k: what is left is about increment rho/(1 - rho).
      const double rho = last_increment > 0. ? increment / last_increment : 0.;
      const bool crawling = rho < 1. && increment * rho > 50. * (1. - rho) * small;
      result.kkt_residual = qp.kkt_residual(result.P);
      result.converged = result.kkt_residual <= options.tolerance && !crawling;
    }
    last_increment = increment;
  }
  if (!result.converged)
    result.kkt_residual = qp.kkt_residual(result.P);
  return result;
}
} // namespace Signorini
