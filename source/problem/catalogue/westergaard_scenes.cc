// SPDX-License-Identifier: LGPL-2.1-or-later
// A3, B1, B1q, B1t, B2, B3, B4: fields of Westergaard's stress function Z(x+iy), which meet all
// contact conditions on y = 0 (p = Re Z, sigma_12 = 0), times the cut-off 1 - y^2; lambda = mu = 1.
//
//   s11 = Re Z - y Im Z',  s22 = Re Z + y Im Z',  s12 = -y Re Z',  Zh = int Z,  kappa = 2,
//   2 mu u1 = (kappa-1)/2 Re Zh - y Im Z,   2 mu u2 = (kappa+1)/2 Im Zh - y Re Z.

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <complex>

#include "catalogue_scenes.h"

namespace Signorini
{
namespace
{
using Complex = std::complex<double>;

/** The values of Zh = int Z, Z and Z' at a point of the upper half-plane. */
struct StressFunction
{
  Complex Zh, Z, dZ;
};

using StressFunctionOf = std::function<StressFunction(const Complex &)>;

constexpr double lambda = 1., mu = 1., kappa = (lambda + 3. * mu) / (lambda + mu);

/** The uncut displacement w with its gradient d. */
struct UncutField
{
  std::array<double, 2> w;
  std::array<std::array<double, 2>, 2> d;
};

UncutField uncut_field(const StressFunction &Z, const double y)
{
  constexpr double m = 2. * mu, a = (kappa - 1.) / 2., b = (kappa + 1.) / 2.;
  // y Z' -> 0 on y = 0, also where Z' has a pole.
  const Complex ydZ = y > 0. ? y * Z.dZ : Complex(0.);
  return {{(a * Z.Zh.real() - y * Z.Z.imag()) / m, (b * Z.Zh.imag() - y * Z.Z.real()) / m},
          {{{{(a * Z.Z.real() - ydZ.imag()) / m, (-b * Z.Z.imag() - ydZ.real()) / m}},
            {{(b * Z.Z.imag() - ydZ.real()) / m, (a * Z.Z.real() + ydZ.imag()) / m}}}}};
}

/** Returns c(y) w with c = 1 - y^2, and f = -div sigma(c w). */
FieldAtPoint cut_off(const UncutField &uncut, const double y)
{
  const auto &w = uncut.w;
  const auto &d = uncut.d;
  const double c = 1. - y * y, c1 = -2. * y, c2 = -2.;
  const double div = d[0][0] + d[1][1];
  const double s12 = mu * (d[0][1] + d[1][0]), s22 = lambda * div + 2. * mu * d[1][1];
  FieldAtPoint field;
  for (unsigned int i = 0; i < 2; ++i)
  {
    field.u[i] = c * w[i];
    field.du[i] = {c * d[i][0], c * d[i][1] + c1 * w[i]};
  }
  field.f = {-c1 * (s12 + lambda * d[1][0] + mu * d[0][1]) - c2 * mu * w[0],
             -c1 * (s22 + lambda * d[1][1] + mu * (d[1][1] + div)) -
               c2 * (lambda + 2. * mu) * w[1]};
  return field;
}

Field field_of(const StressFunctionOf &Z)
{
  return [Z](const Point<2> &x) {
    // +0.0: on the branch cut the value from above is meant.
    return cut_off(uncut_field(Z(Complex(x[0], std::abs(x[1]))), x[1]), x[1]);
  };
}

Scene<2> make_westergaard_scene(const StressFunctionOf &Z,
                                const Profile &pressure,
                                const Profile &gap,
                                const std::vector<double> &transitions)
{
  return make_manufactured_scene(
    field_of(Z), make_lame_material(lambda, mu), gap, pressure, transitions);
}

/** Returns g = u_n + (x - xi)_+/2: open behind xi. */
Profile opening_gap(const StressFunctionOf &Z, const double xi)
{
  const Field field = field_of(Z);
  return [=](const double x) { return -field(Point<2>(x, 0.)).u[1] + 0.5 * std::max(x - xi, 0.); };
}

const Profile flat = [](const double) { return 0.; };

/** Returns Z = i c0 (z-xi)^s, which has p = -c0 sin(pi s) (xi-x)_+^s. */
StressFunctionOf power(const double c0, const double xi, const double s)
{
  return [=](const Complex &z) {
    const Complex t = z - xi, i(0., 1.);
    return StressFunction{i * c0 * std::pow(t, s + 1.) / (s + 1.),
                          i * c0 * std::pow(t, s),
                          i * c0 * s * std::pow(t, s - 1.)};
  };
}

/** Returns the true singularity of a contact end: p = -(xi-x)_+^{1/2}, flat foundation. */
Scene<2> make_b1_at(const double xi)
{
  return make_westergaard_scene(power(1., xi, 0.5),
                                [=](const double x) { return -std::sqrt(std::max(xi - x, 0.)); },
                                flat,
                                {xi});
}

/** B2 and B3: contact on (a, b), c0 = 2. */
constexpr double c0 = 2.;
const double a = 1. / std::sqrt(10.), b = numbers::E / 4.;
const double middle = (a + b) / 2., radius = (b - a) / 2.;

double ellipse(const double x)
{
  return -c0 * std::sqrt(std::max((x - a) * (b - x), 0.));
}

/** Returns Z = i c0 R, R = sqrt(z-a) sqrt(z-b). */
StressFunction two_ends(const Complex &z)
{
  const Complex i(0., 1.), t = z - middle, R = std::sqrt(z - a) * std::sqrt(z - b);
  return {i * c0 * (t * R / 2. - radius * radius / 2. * std::log((t + R) / radius)),
          i * c0 * R,
          i * c0 * t / R};
}
} // namespace

// A3: Z = -(iA/pi) (z-xi) log(z-xi), A = 2, xi = 1/sqrt(2): p = -A (xi-x)_+ has a kink.
Scene<2> make_a3()
{
  constexpr double A = 2., xi = numbers::SQRT1_2;
  const StressFunctionOf Z = [=](const Complex &z) {
    const Complex t = z - xi, factor(0., -A / numbers::PI);
    if (t == Complex(0.))
      return StressFunction{};
    const Complex logarithm = std::log(t);
    return StressFunction{
      factor * t * t * (logarithm / 2. - 0.25), factor * t * logarithm, factor * (logarithm + 1.)};
  };
  return make_westergaard_scene(
    Z, [](const double x) { return -A * std::max(xi - x, 0.); }, opening_gap(Z, xi), {xi});
}

Scene<2> make_b1()
{
  return make_b1_at(numbers::SQRT1_2);
}

// B1q: the transition is always at the same place in its patch: in the middle (patches odd in
// number).
Scene<2> make_b1q()
{
  return make_b1_at(0.5);
}

// B1t: the transition is one or two thirds into its patch on every level.
Scene<2> make_b1t()
{
  return make_b1_at(1. / 3.);
}

// B2: p = -c0 sqrt((x-a)(b-x))_+ on a flat foundation.
Scene<2> make_b2()
{
  return make_westergaard_scene(two_ends, ellipse, flat, {a, b});
}

// B3: Hertz' pressure, exact for the parabolic gap (kappa+1) c0 (x-middle)^2/(8 mu).
Scene<2> make_b3()
{
  const StressFunctionOf Z = [](const Complex &z) {
    const Complex i(0., 1.), t = z - middle;
    StressFunction hertz = two_ends(z);
    hertz.Zh -= i * c0 / 2. * t * t;
    hertz.Z -= i * c0 * t;
    hertz.dZ -= i * c0;
    return hertz;
  };
  return make_westergaard_scene(
    Z,
    ellipse,
    [](const double x) { return (kappa + 1.) * c0 * (x - middle) * (x - middle) / (8. * mu); },
    {a, b});
}

// B4: weaker than the true singularity, s = 1/4, c0 = 2, xi = 1/2.
Scene<2> make_b4()
{
  constexpr double xi = 0.5, s = 0.25;
  const StressFunctionOf Z = power(2., xi, s);
  return make_westergaard_scene(Z,
                                [](const double x) {
                                  return -2. * std::sin(numbers::PI * s) *
                                         std::pow(std::max(xi - x, 0.), s);
                                },
                                opening_gap(Z, xi),
                                {xi});
}
} // namespace Signorini
