// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>

#include <deal.II/base/quadrature.h>

#include <array>
#include <vector>

namespace Signorini {
/** The highest degree of Legendre's polynomials here, and one more. */
constexpr unsigned int max_legendre = 24;

/** Returns Legendre's polynomials P_0 to P_degree at z in [-1,1]; zeros after them. */
std::array<double, max_legendre> legendre(unsigned int degree, double z);

/** Returns Legendre's polynomials, each with its first and second derivative; zeros after them. */
std::array<std::array<double, 3>, max_legendre> legendre_jets(unsigned int degree, double z);

/** Returns the orthonormal Legendre polynomials of degrees 0 to @p degree on [0,1] at s. */
std::vector<double> legendre_values(unsigned int degree, double s);

/** Returns the coefficients ∫ f L_i ds of orthonormal Legendre polynomials of degrees 0 to @p
 * degree on [0,1], by a rule on [0,1] or on a part of it. */
template <typename Function>
std::vector<double> legendre_projection(const unsigned int degree, const Quadrature<1> &rule,
                                        const Function &f) {
  std::vector<double> coefficients(degree + 1, 0.);
  for (unsigned int q = 0; q < rule.size(); ++q) {
    const double s = rule.point(q)[0], value = rule.weight(q) * f(s);
    const std::vector<double> L = legendre_values(degree, s);
    for (unsigned int i = 0; i <= degree; ++i)
      coefficients[i] += value * L[i];
  }
  return coefficients;
}

/** Returns the coefficients of Bernstein, of degree n, of a sum of orthonormal Legendre polynomials
 * of degrees 0 to n on [0,1]. The values of the polynomial lie between the smallest and the largest
 * coefficient. */
std::vector<double> bernstein_coefficients(const std::vector<double> &legendre);

/** Returns the coefficients of orthonormal Legendre polynomials from those of Bernstein. */
std::vector<double> legendre_coefficients(const std::vector<double> &bernstein);

/** Returns the value at s of the polynomial with these coefficients of Bernstein. */
double bernstein_value(std::vector<double> coefficients, double s);
} // namespace Signorini
