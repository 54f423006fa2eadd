// SPDX-License-Identifier: LGPL-2.1-or-later
// The leading exponent of plane elasticity at a corner: roots of entire functions.

#include <signorini/scene/corner_exponent.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <optional>
#include <utility>
#include <vector>

namespace Signorini
{
namespace
{
using Complex = std::complex<double>;

/** constant + linear z + square z^2 + sine sin(frequency z) + cosine cos(frequency z); its roots z
 * are exponents. */
struct CornerFunction
{
  double constant, linear, square, sine, cosine, frequency;

  Complex value(const Complex z) const
  {
    return constant + z * (linear + square * z) + sine * std::sin(frequency * z) +
           cosine * std::cos(frequency * z);
  }
  Complex derivative(const Complex z) const
  {
    return linear + 2. * square * z +
           frequency * (sine * std::cos(frequency * z) - cosine * std::sin(frequency * z));
  }
  /** A bound of the terms: f is known up to rounding of this number. */
  double size(const Complex z) const
  {
    return std::abs(constant) + std::abs(linear * z) + std::abs(square * z * z) +
           (std::abs(sine) + std::abs(cosine)) * std::cosh(frequency * z.imag());
  }
};

/** (W1) to (W6). Functions that are products are given by their factors, so that roots are simple
 * at straight angles and at cracks. */
std::vector<CornerFunction> corner_functions(const double angle,
                                             const EdgeSupport first,
                                             const EdgeSupport second,
                                             const double kappa)
{
  const double s = std::sin(angle), s2 = std::sin(2. * angle);
  const auto either = [&](const EdgeSupport support) {
    return first == support || second == support;
  };
  if (!either(EdgeSupport::held) && !either(EdgeSupport::sliding))
    return {{0., s, 0., 1., 0., angle}, {0., -s, 0., 1., 0., angle}};
  if (!either(EdgeSupport::free) && !either(EdgeSupport::sliding))
    return {{0., s, 0., kappa, 0., angle}, {0., -s, 0., kappa, 0., angle}};
  if (!either(EdgeSupport::sliding))
    return {
      {2. * kappa - (kappa + 1.) * (kappa + 1.), 0., 4. * s * s, 0., -2. * kappa, 2. * angle}};
  if (either(EdgeSupport::free))
    return {{0., s2, 0., 1., 0., 2. * angle}};
  if (either(EdgeSupport::held))
    return {{0., -s2, 0., kappa, 0., 2. * angle}};
  const double c = std::cos(angle);
  return {{0., 0., 0., c, s, angle}, {0., 0., 0., c, -s, angle}};
}

/** Newton's method; nothing if it ends elsewhere. */
std::optional<Complex> root_near(const CornerFunction &f, Complex z)
{
  for (unsigned int i = 0; i < 60; ++i)
  {
    const Complex step = f.value(z) / f.derivative(z);
    // Far from all roots steps may lead to where the sine overflows.
    if (!(std::abs(step) < 1e3))
      return {};
    z -= step;
    if (!(std::abs(f.frequency * z.imag()) < 100.))
      return {};
    if (std::abs(step) < 1e-15 * std::abs(z))
      break;
  }
  if (std::abs(f.value(z)) > 1e-12 * f.size(z))
    return {};
  return z;
}

/** Whether solutions with this exponent are polynomials. */
bool is_integer(const Complex exponent)
{
  return std::abs(exponent - std::round(exponent.real())) < 1e-6;
}

/** Newton's method from the points of a grid. With |frequency Im z| > 6 + log(1 + kappa) a sine or
 * cosine is larger than all other terms; roots come in pairs z, conj(z). */
double smallest_real_part(const CornerFunction &f, const double kappa)
{
  const double spacing = 0.5 / f.frequency;
  const double highest = (6. + std::log(1. + kappa)) / f.frequency;
  double smallest = largest_corner_exponent;
  for (double x = 0.5 * spacing; x < smallest + spacing; x += spacing)
    for (double y = 0.; y < highest; y += spacing)
      if (const std::optional<Complex> root = root_near(f, Complex(x, y)))
        if (root->real() > 1e-6 && !is_integer(*root))
          smallest = std::min(smallest, root->real());
  return smallest;
}
} // namespace

double corner_exponent(const double angle,
                       const EdgeSupport first,
                       const EdgeSupport second,
                       const double kappa)
{
  Assert(angle > 0. && angle < 2. * dealii::numbers::PI + 1e-6,
         dealii::ExcMessage("The angle of a corner lies between 0 and 2 pi."));
  Assert(kappa > 1. - 1e-6, dealii::ExcMessage("Kolosov's constant is at least one."));
  double smallest = largest_corner_exponent;
  for (const CornerFunction &f : corner_functions(angle, first, second, kappa))
    smallest = std::min(smallest, smallest_real_part(f, kappa));
  return smallest;
}

double kolosov_constant(const dealii::SymmetricTensor<4, 2> &hooke)
{
  // E_iijj = 4 (lambda + mu) and E_ijij = 2 lambda + 6 mu do not change with the axes.
  double traces = 0., squares = 0.;
  for (unsigned int i = 0; i < 2; ++i)
    for (unsigned int j = 0; j < 2; ++j)
    {
      traces += hooke[i][i][j][j];
      squares += hooke[i][j][i][j];
    }
  return 2. * squares / traces;
}
} // namespace Signorini
