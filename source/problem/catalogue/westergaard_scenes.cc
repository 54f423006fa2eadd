// SPDX-License-Identifier: LGPL-2.1-or-later
// A3, B1, B1q, B1t, B2, B3, B4: fields of Westergaard's stress function Z(x+iy), which meet all
// contact conditions on y = 0 (p = Re Z, sigma_12 = 0), times the cut-off 1 - y^2; lambda = mu = 1.
//
//   s11 = Re Z - y Im Z',  s22 = Re Z + y Im Z',  s12 = -y Re Z',  Zh = int Z,  kappa = 2,
//   2 mu u1 = (kappa-1)/2 Re Zh - y Im Z,   2 mu u2 = (kappa+1)/2 Im Zh - y Re Z.

#include <deal.II/base/numbers.h>

#include <cmath>
#include <complex>

#include "catalogue_scenes.h"
#include "manufactured.h"

namespace Signorini {
namespace {
using Complex = std::complex<double>;

/** The values of Zh = int Z, Z and Z' at a point of the upper half-plane. */
struct StressFunction {
  Complex Zh, Z, dZ;
};

using StressFunctionOf = std::function<StressFunction(const Complex &)>;

/** Returns u = (1 - y^2) w. The second derivatives of w are left out, because -div sigma(w) = 0. */
Jets2 field(const StressFunctionOf &Z, const Jets2 &at) {
  // On the branch cut the value from above is meant: not -0.
  const double y = std::abs(at[1].value);
  const StressFunction f = Z(Complex(at[0].value, y));
  // y Z' -> 0 on y = 0, also where Z' has a pole.
  const Complex ydZ = y > 0. ? y * f.dZ : Complex(0.);
  const Jet2 w1(
    f.Zh.real() / 4. - y * f.Z.imag() / 2.,
    Tensor<1, 2>({f.Z.real() / 4. - ydZ.imag() / 2., -3. * f.Z.imag() / 4. - ydZ.real() / 2.}));
  const Jet2 w2(
    3. * f.Zh.imag() / 4. - y * f.Z.real() / 2.,
    Tensor<1, 2>({3. * f.Z.imag() / 4. - ydZ.real() / 2., f.Z.real() / 4. + ydZ.imag() / 2.}));
  const Jet2 cut = 1. - at[1] * at[1];
  return {cut * w1, cut * w2};
}

using RealFunction = std::function<double(double)>;

Scene<2> westergaard_scene(const StressFunctionOf &Z, const RealFunction &pressure,
                           const RealFunction &gap, const std::vector<double> &transitions) {
  Scene<2> scene = contact_scene<2>(
    make_rectangle({0., 0.}, {1., 1.}, {1, 1}), isotropic<2>(), "top", "bottom",
    [gap](const Point<2> &x) { return gap(x[0]); },
    [pressure](const Point<2> &x) { return pressure(x[0]); });
  set_exact_solution<2>(scene, [Z](const Jets2 &x) { return field(Z, x); });
  scene.kinks = lines_at<2>({{transitions, {}}});
  return scene;
}

double flat(const double) {
  return 0.;
}

/** Returns g = u_n + (x - xi)_+/2: open behind xi. */
RealFunction opening_gap(const StressFunctionOf &Z, const double xi) {
  return [=](const double x) { return -field(Z, {x, 0.})[1].value + 0.5 * std::max(x - xi, 0.); };
}

/** Returns Z = i c0 (z-xi)^s, which has p = -c0 sin(pi s) (xi-x)_+^s. */
StressFunctionOf power(const double c0, const double xi, const double s) {
  return [=](const Complex &z) {
    const Complex t = z - xi, i(0., 1.);
    return StressFunction{i * c0 * std::pow(t, s + 1.) / (s + 1.), i * c0 * std::pow(t, s),
                          i * c0 * s * std::pow(t, s - 1.)};
  };
}

/** A3: Z = -(2i/pi) (z-xi) log(z-xi). */
Scene<2> make_a3() {
  constexpr double A = 2., xi = numbers::SQRT1_2;
  const StressFunctionOf Z = [=](const Complex &z) {
    const Complex t = z - xi, factor(0., -A / numbers::PI);
    if (t == Complex(0.))
      return StressFunction{};
    const Complex logarithm = std::log(t);
    return StressFunction{factor * t * t * (logarithm / 2. - 0.25), factor * t * logarithm,
                          factor * (logarithm + 1.)};
  };
  return westergaard_scene(Z, [](const double x) { return -A * std::max(xi - x, 0.); },
                           opening_gap(Z, xi), {xi});
}

/** B1, B1q and B1t: the true singularity of a contact end. */
Scene<2> make_b1_at(const double xi) {
  return westergaard_scene(power(1., xi, 0.5),
                           [=](const double x) { return -std::sqrt(std::max(xi - x, 0.)); }, flat,
                           {xi});
}

/** B2 and B3: contact on (a, b), c0 = 2. */
constexpr double c0 = 2.;
const double a = 1. / std::sqrt(10.), b = numbers::E / 4.;
const double middle = (a + b) / 2., radius = (b - a) / 2.;

double ellipse(const double x) {
  return -c0 * std::sqrt(std::max((x - a) * (b - x), 0.));
}

/** Returns Z = i c0 R, R = sqrt(z-a) sqrt(z-b). */
StressFunction two_ends(const Complex &z) {
  const Complex i(0., 1.), t = z - middle, R = std::sqrt(z - a) * std::sqrt(z - b);
  return {i * c0 * (t * R / 2. - radius * radius / 2. * std::log((t + R) / radius)), i * c0 * R,
          i * c0 * t / R};
}

Scene<2> make_b2() {
  return westergaard_scene(two_ends, ellipse, flat, {a, b});
}

/** B3: Hertz' pressure, exact for the parabolic gap (kappa+1) c0 (x-middle)^2/(8 mu). */
Scene<2> make_b3() {
  const StressFunctionOf Z = [](const Complex &z) {
    const Complex i(0., 1.), t = z - middle;
    const StressFunction f = two_ends(z);
    return StressFunction{f.Zh - i * c0 / 2. * t * t, f.Z - i * c0 * t, f.dZ - i * c0};
  };
  return westergaard_scene(
    Z, ellipse, [](const double x) { return 3. / 8. * c0 * (x - middle) * (x - middle); }, {a, b});
}

/** B4: weaker than the true singularity, s = 1/4. */
Scene<2> make_b4() {
  constexpr double xi = 0.5, s = 0.25;
  const StressFunctionOf Z = power(2., xi, s);
  return westergaard_scene(Z,
                           [](const double x) {
                             return -2. * std::sin(numbers::PI * s) *
                                    std::pow(std::max(xi - x, 0.), s);
                           },
                           opening_gap(Z, xi), {xi});
}

/** Returns the text of a scene: all but gap, stress function and pressure is common. */
std::string describe(const std::string &gap, const std::string &Z_and_p) {
  return "Body      the unit square 0 < x < 1, 0 < y < 1\n"
         "Material  E = 2.5, nu = 0.25 (lambda = mu = 1), plane strain\n"
         "Boundary  clamped at y = 1, contact at y = 0, traction sigma(u) n on x = 0 and x = 1\n"
         "Load      body force -div sigma(u)\n"
         "Gap       " +
         gap +
         "\n"
         "Exact u   u1 = (1 - y^2) (Re Zh/2 - y Im Z)/2, u2 = (1 - y^2) (3 Im Zh/2 - y Re Z)/2\n" +
         Z_and_p;
}

std::string describe_b1(const std::string &xi) {
  return describe("0", "Z         i (z-xi)^(1/2), xi = " + xi +
                         ", with z = x + i y\n"
                         "Zh        the integral of Z from xi\n"
                         "Exact p   -(xi-x)_+^(1/2)\n");
}
} // namespace

std::vector<CatalogueEntry<2>> westergaard_scenes() {
  return {
    {"A3", "contact pressure with a kink where contact ends",
     describe("-u2(x,0) + (x-xi)_+/2",
              "Z         -(2 i/pi) (z-xi) log(z-xi), xi = 1/sqrt(2), with z = x + i y\n"
              "Zh        the integral of Z from xi\n"
              "Exact p   -2 (xi-x)_+\n"),
     make_a3},
    {"B1", "the true singularity of a contact end: square root pressure, flat foundation",
     describe_b1("1/sqrt(2)"), []() { return make_b1_at(numbers::SQRT1_2); }},
    // The transition is always in the middle of its patch (patches odd in number).
    {"B1q", "as B1, contact ends at x = 1/2", describe_b1("1/2"), []() { return make_b1_at(0.5); }},
    // The transition is one or two thirds into its patch on every level.
    {"B1t", "as B1, contact ends at x = 1/3", describe_b1("1/3"),
     []() { return make_b1_at(1. / 3.); }},
    {"B2", "square root pressure at both ends of the contact zone, flat foundation",
     describe("0", "Z         2 i R, R = (z-a)^(1/2) (z-b)^(1/2), with z = x + i y\n"
                   "Zh        the integral of Z from b\n"
                   "Exact p   -2 ((x-a) (b-x))_+^(1/2), a = 1/sqrt(10), b = e/4\n"),
     make_b2},
    {"B3", "Hertz' contact: elliptic pressure on a parabolic foundation",
     describe("3/4 (x-m)^2, m = (a+b)/2",
              "Z         2 i (R - (z-m)), m = (a+b)/2, R = (z-a)^(1/2) (z-b)^(1/2), with z = "
              "x + i y\n"
              "Zh        the integral of Z from b, minus i (b-a)^2/4\n"
              "Exact p   -2 ((x-a) (b-x))_+^(1/2), a = 1/sqrt(10), b = e/4\n"),
     make_b3},
    {"B4", "a contact end with a stronger singularity, pressure like the fourth root",
     describe("-u2(x,0) + (x-xi)_+/2", "Z         2 i (z-xi)^(1/4), xi = 1/2, with z = x + i y\n"
                                       "Zh        the integral of Z from xi\n"
                                       "Exact p   -sqrt(2) (xi-x)_+^(1/4)\n"),
     make_b4}};
}
} // namespace Signorini
