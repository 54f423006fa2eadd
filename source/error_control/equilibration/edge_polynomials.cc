// SPDX-License-Identifier: LGPL-2.1-or-later
// Polynomials on an edge by Legendre's and by Bernstein's basis.

#include <signorini/error_control/equilibration/edge_polynomials.h>

#include <deal.II/base/quadrature_lib.h>

#include <cmath>
#include <utility>

namespace Signorini {
std::array<double, max_legendre> legendre(const unsigned int degree, const double z) {
  // A division takes longer than the rest.
  static const auto inverse = [] {
    std::array<double, max_legendre> inverse = {};
    for (unsigned int k = 1; k < max_legendre; ++k)
      inverse[k] = 1. / k;
    return inverse;
  }();
  std::array<double, max_legendre> P = {{1., z}};
  for (unsigned int k = 2; k <= degree; ++k)
    P[k] = (2. - inverse[k]) * z * P[k - 1] - (1. - inverse[k]) * P[k - 2];
  return P;
}

std::array<std::array<double, 3>, max_legendre> legendre_jets(const unsigned int degree,
                                                              const double z) {
  const auto values = legendre(degree, z);
  std::array<std::array<double, 3>, max_legendre> P = {{{{1., 0., 0.}}, {{z, 1., 0.}}}};
  for (unsigned int k = 2; k <= degree; ++k)
    P[k] = {{values[k], P[k - 2][1] + (2. * k - 1.) * P[k - 1][0],
             P[k - 2][2] + (2. * k - 1.) * P[k - 1][1]}};
  return P;
}

std::vector<double> legendre_values(const unsigned int degree, const double s) {
  const auto P = legendre(degree, 2. * s - 1.);
  std::vector<double> values;
  for (unsigned int k = 0; k <= degree; ++k)
    values.push_back(std::sqrt(2. * k + 1.) * P[k]);
  return values;
}

std::vector<double> bernstein_coefficients(const std::vector<double> &legendre) {
  const unsigned int n = legendre.size() - 1;
  std::vector<double> sum(n + 1, 0.);
  for (unsigned int k = 0; k <= n; ++k) {
    // P_k has the coefficients (-1)^{k-i} (k choose i); then the degree is raised to n.
    std::vector<double> b = {k % 2 == 0 ? 1. : -1.};
    for (unsigned int i = 1; i <= k; ++i)
      b.push_back(-b.back() * (k - i + 1) / i);
    for (unsigned int degree = k; degree < n; ++degree) {
      std::vector<double> raised(degree + 2);
      for (unsigned int i = 0; i <= degree + 1; ++i)
        raised[i] = (i > 0 ? b[i - 1] * i / (degree + 1.) : 0.) +
                    (i <= degree ? b[i] * (degree + 1. - i) / (degree + 1.) : 0.);
      b = std::move(raised);
    }
    for (unsigned int i = 0; i <= n; ++i)
      sum[i] += std::sqrt(2. * k + 1.) * legendre[k] * b[i];
  }
  return sum;
}

double bernstein_value(std::vector<double> b, const double s) {
  for (; b.size() > 1; b.pop_back())
    for (std::size_t i = 0; i + 1 < b.size(); ++i)
      b[i] = (1. - s) * b[i] + s * b[i + 1];
  return b[0];
}

std::vector<double> legendre_coefficients(const std::vector<double> &bernstein) {
  return legendre_projection(bernstein.size() - 1, QGauss<1>(bernstein.size()),
                             [&](const double s) { return bernstein_value(bernstein, s); });
}
} // namespace Signorini
