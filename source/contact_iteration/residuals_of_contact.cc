// SPDX-License-Identifier: LGPL-2.1-or-later
// How far U and P are from a solution of (5).

#include "residuals_of_contact.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace Signorini
{
void add_product(const Coupling &D, const dealii::Vector<double> &P, NodalVector &vector)
{
  for (unsigned int k = 0; k < P.size(); ++k)
    if (P[k] != 0.)
      for (const auto &[row, value] : D.column(k))
        vector[row] += value * P[k];
}

double rounding_of(const StiffnessOperator &A)
{
  NodalVector x(A.size()), y(A.size());
  for (unsigned int i = 0; i < x.size(); ++i)
    x[i] = std::sin(1. + 2.3 * i);
  A.apply(y, x);
  return std::numeric_limits<double>::epsilon() * y.l2_norm() / x.l2_norm();
}

namespace
{
double relative_or_absolute(const double value, const double scale)
{
  return scale > 0. ? value / scale : value;
}

/** Stationarity. @return the residual. */
NodalVector measure_forces(const ContactSystem &system, ContactIterationResult &result)
{
  constexpr double least_share_of_terms = 1e-3;
  NodalVector pressing(system.A.size()), r(system.A.size());
  add_product(system.condensed_D, result.P, pressing);
  system.A.apply(r, result.U);
  const double of_contact = pressing.l2_norm();
  const double largest = std::max({r.l2_norm(), of_contact, system.f.l2_norm()});
  // Where nothing touches, prescribed displacements may move the body as a whole: nothing else
  // tells how small its forces are.
  const double scale = std::max({of_contact, system.loads, least_share_of_terms * largest});
  r *= -1.;
  r += system.f;
  r += pressing;
  result.stationarity = relative_or_absolute(r.l2_norm(), scale);
  result.rounding_of_stationarity =
    relative_or_absolute(result.rounding_of_A * result.U.l2_norm(), scale);
  return r;
}

/** |P - min(0, P - W/diag C)| relative to max(|P|, |F/diag C|), F = C P - W; |P.W|. */
void measure_contact(const ContactSystem &system, ContactIterationResult &result)
{
  const dealii::Vector<double> W = system.opening(result.U);
  const dealii::Vector<double> diagonal = system.model.diagonal();
  const dealii::Vector<double> C_P = system.model.apply(result.P);
  double sum = 0., size_of_P = 0., size_of_F = 0., work = 0., terms = 0., energy = 0.;
  for (unsigned int k = 0; k < W.size(); ++k)
  {
    const double P = result.P[k], C_kk = result.scale * diagonal[k];
    sum += std::pow(P - std::min(0., P - W[k] / C_kk), 2);
    size_of_P += P * P;
    size_of_F += std::pow((result.scale * C_P[k] - W[k]) / C_kk, 2);
    work += P * W[k];
    terms += std::abs(P) * (std::abs(system.gap[k]) + std::abs(W[k] + system.gap[k]));
    energy += result.scale * P * C_P[k];
  }
  const double scale = std::max(size_of_P, size_of_F);
  result.kkt_residual = std::sqrt(relative_or_absolute(sum, scale));
  result.complementarity = relative_or_absolute(std::abs(work), energy);
  result.rounding_of_complementarity =
    relative_or_absolute(std::numeric_limits<double>::epsilon() * terms, energy);
}
} // namespace

NodalVector measure(const ContactSystem &system,
                    const ContactIterationOptions &options,
                    ContactIterationResult &result)
{
  constexpr double multiples_of_rounding = 10.;
  const NodalVector r = measure_forces(system, result);
  measure_contact(system, result);
  const auto is_small = [](const double residual, const double allowed, const double rounding) {
    return residual <= std::max(allowed, multiples_of_rounding * rounding);
  };
  // Where nothing touches there is nothing that a tolerance of contact allows.
  const bool touches =
    std::any_of(result.P.begin(), result.P.end(), [](const double P_k) { return P_k != 0.; });
  const double allowed = touches ? options.stationarity : std::min(options.stationarity, 1e-9);
  result.converged =
    result.kkt_residual <= options.tolerance &&
    is_small(result.stationarity, allowed, result.rounding_of_stationarity) &&
    is_small(result.complementarity, options.stationarity, result.rounding_of_complementarity);
  return r;
}
} // namespace Signorini
