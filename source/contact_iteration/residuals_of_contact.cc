// SPDX-License-Identifier: LGPL-2.1-or-later
// How far U and P are from a solution of (5).

#include "residuals_of_contact.h"

#include <algorithm>
#include <cmath>

namespace Signorini
{
void add_product(const Coupling &D, const dealii::Vector<double> &P, NodalVector &vector)
{
  for (unsigned int k = 0; k < P.size(); ++k)
    if (P[k] != 0.)
      for (const auto &[row, value] : D.column(k))
        vector[row] += value * P[k];
}

NodalVector measure(const ContactSystem &system, ContactIterationResult &result)
{
  NodalVector pressing(system.A.size());
  add_product(system.condensed_D, result.P, pressing);
  NodalVector r(system.A.size());
  system.A.apply(r, result.U);
  const double largest = std::max({r.l2_norm(), pressing.l2_norm(), system.f.l2_norm()});
  r *= -1.;
  r += system.f;
  r += pressing;
  result.stationarity = largest > 0. ? r.l2_norm() / largest : 0.;

  // |P - min(0, P - W/diag C)| relative to max(|P|, |F/diag C|), F = C P - W.
  const dealii::Vector<double> W = system.opening(result.U);
  const dealii::Vector<double> diagonal = system.model.diagonal();
  const dealii::Vector<double> C_P = system.model.apply(result.P);
  double sum = 0., size_of_P = 0., size_of_F = 0.;
  for (unsigned int k = 0; k < W.size(); ++k)
  {
    const double P = result.P[k], C_kk = result.scale * diagonal[k];
    sum += std::pow(P - std::min(0., P - W[k] / C_kk), 2);
    size_of_P += P * P;
    size_of_F += std::pow((result.scale * C_P[k] - W[k]) / C_kk, 2);
  }
  const double scale = std::max(size_of_P, size_of_F);
  result.kkt_residual = std::sqrt(scale > 0. ? sum / scale : sum);
  return r;
}
} // namespace Signorini
