// SPDX-License-Identifier: LGPL-2.1-or-later
// The leading exponents of plane elasticity in wedges of one and of several materials: roots of
// entire functions.

#include <signorini/base/dealii.h>
#include <signorini/problem/scene/wedges.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/numbers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numeric>
#include <optional>

namespace Signorini {
namespace {
using Complex = std::complex<double>;

/** The function constant + linear z + square z^2 + sine sin(frequency z) + cosine cos(frequency z);
 * its roots z are exponents. */
struct CornerFunction {
  double constant, linear, square, sine, cosine, frequency;

  Complex value(const Complex z) const {
    return constant + z * (linear + square * z) + sine * std::sin(frequency * z) +
           cosine * std::cos(frequency * z);
  }
  Complex derivative(const Complex z) const {
    return linear + 2. * square * z +
           frequency * (sine * std::cos(frequency * z) - cosine * std::sin(frequency * z));
  }
};

/** Returns the functions of (W1) to (W6). Functions that are products are given by their factors,
 * so that roots are simple at straight angles and at cracks. */
std::vector<CornerFunction> corner_functions(const double angle, const EdgeSupport first,
                                             const EdgeSupport second, const double kappa) {
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

/** Returns the root that Newton's method finds from z, or nothing. */
template <typename EntireFunction>
std::optional<Complex> root_near(const EntireFunction &f, Complex z) {
  Complex step = 1.;
  for (unsigned int i = 0; i < 60 && std::abs(step) >= 1e-15 * std::abs(z); ++i) {
    step = f.value(z) / f.derivative(z);
    z -= step;
    // Far from all roots steps may lead to where the sine overflows.
    if (!(std::abs(step) < 1e3) || !(std::abs(f.frequency * z.imag()) < 100.))
      return {};
  }
  return std::abs(step) > 1e-6 * std::abs(z) ? std::nullopt : std::optional(z);
}

/** Returns the smallest Re z > 0, at most @p largest, of the roots that are no integers, for which
 * solutions are no polynomials. Newton's method finds them from the points of a grid. With
 * |frequency Im z| > 6 + log(1 + kappa) a sine or cosine is larger than all other terms; roots come
 * in pairs z, conj(z).
 */
template <typename EntireFunction>
double min_real_part(const EntireFunction &f, const double kappa, const double largest) {
  const double spacing = 0.5 / f.frequency;
  const double highest = (6. + std::log(1. + kappa)) / f.frequency;
  double smallest = largest;
  for (double x = 0.5 * spacing; x < smallest + spacing; x += spacing)
    for (double y = 0.; y < highest; y += spacing)
      if (const std::optional<Complex> root = root_near(f, Complex(x, y)))
        if (root->real() > 1e-6 && std::abs(*root - std::round(root->real())) > 1e-6)
          smallest = std::min(smallest, root->real());
  return smallest;
}
} // namespace

double corner_exponent(const double angle, const EdgeSupport first, const EdgeSupport second,
                       const double kappa) {
  Assert(angle > 0. && angle < 2. * numbers::PI + 1e-6,
         ExcMessage("The angle of a corner lies between 0 and 2 pi."));
  Assert(kappa > 1. - 1e-6, ExcMessage("Kolosov's constant is at least one."));
  double smallest = max_corner_exponent;
  for (const CornerFunction &f : corner_functions(angle, first, second, kappa))
    smallest = std::min(smallest, min_real_part(f, kappa, smallest));
  return smallest;
}

namespace {
/** The displacements u_r, u_theta over r^lambda and the stresses sigma_theta,theta, sigma_r,theta
 * over lambda r^(lambda - 1) at an angle. */
using EdgeState = std::array<Complex, 4>;

/** Returns the state on the other edge of a layer, by Kolosov's formula. */
EdgeState across(const WedgeLayer &layer, const Complex lambda, const EdgeState &state) {
  const double kappa = layer.kappa, two_mu = 2. * layer.shear_modulus;
  const Complex a = (two_mu * state[0] + state[2]) / (kappa + 1.),
                b = (state[3] - two_mu * state[1]) / (kappa + 1.), c = state[2] - (lambda + 1.) * a,
                d = -state[3] - (lambda - 1.) * b;
  const Complex x = (lambda - 1.) * layer.angle, y = (lambda + 1.) * layer.angle;
  const Complex ax = a * std::cos(x) + b * std::sin(x), bx = a * std::sin(x) - b * std::cos(x),
                cy = c * std::cos(y) + d * std::sin(y), dy = c * std::sin(y) - d * std::cos(y);
  return {{((kappa - lambda) * ax - cy) / two_mu, ((kappa + lambda) * bx + dy) / two_mu,
           (lambda + 1.) * ax + cy, (lambda - 1.) * bx + dy}};
}

/** Returns two states that span those which an edge admits. */
std::array<EdgeState, 2> admitted(const EdgeCondition &edge) {
  if (edge.support == EdgeSupport::free)
    return {{{{1., 0., 0., 0.}}, {{0., 1., 0., 0.}}}};
  if (edge.support == EdgeSupport::held)
    return {{{{0., 0., 1., 0.}}, {{0., 0., 0., 1.}}}};
  return {{{{1., 0., 0., 0.}}, {{0., 0., 1., -edge.ratio}}}};
}

/** Returns the two numbers that vanish where an edge admits a state. */
std::array<Complex, 2> violation(const EdgeCondition &edge, const EdgeState &state) {
  if (edge.support == EdgeSupport::free)
    return {{state[2], state[3]}};
  if (edge.support == EdgeSupport::held)
    return {{state[0], state[1]}};
  return {{state[1], state[3] + edge.ratio * state[2]}};
}

/** Returns two states that span those beyond an edge that slips, from two that span those before
 * it: their combination whose tractions have the given ratio, and a jump of u_r. */
std::array<EdgeState, 2> slipped(const std::array<EdgeState, 2> &states, const double ratio) {
  const std::array<Complex, 2> misfits = {
    {states[0][3] + ratio * states[0][2], states[1][3] + ratio * states[1][2]}};
  EdgeState fitting;
  for (unsigned int i = 0; i < fitting.size(); ++i)
    fitting[i] = misfits[1] * states[0][i] - misfits[0] * states[1][i];
  return {{fitting, {{1., 0., 0., 0.}}}};
}

/** The determinant (W7) of the conditions on the second edge for the states that the first one
 * admits. */
struct LayeredFunction {
  const SlippingWedges &wedges;
  const EdgeCondition &first, &second;
  double frequency;

  Complex value(const Complex lambda) const {
    std::array<EdgeState, 2> states = admitted(first);
    const auto cross = [&](const std::vector<WedgeLayer> &layers) {
      for (EdgeState &state : states)
        for (const WedgeLayer &layer : layers)
          state = across(layer, lambda, state);
    };
    cross(wedges.first);
    if (!wedges.second.empty()) {
      states = slipped(states, wedges.ratio);
      cross(wedges.second);
    }
    const std::array<Complex, 2> a = violation(second, states[0]), b = violation(second, states[1]);
    return a[0] * b[1] - a[1] * b[0];
  }
  Complex derivative(const Complex lambda) const {
    constexpr double step = 1e-5;
    return (value(lambda + step) - value(lambda - step)) / (2. * step);
  }
};
} // namespace

double opening(const std::vector<WedgeLayer> &layers) {
  return std::accumulate(
    layers.begin(), layers.end(), 0.,
    [](const double angle, const WedgeLayer &layer) { return angle + layer.angle; });
}

double corner_exponent(const std::vector<WedgeLayer> &layers, const EdgeCondition &first,
                       const EdgeCondition &second) {
  Assert(!layers.empty(), ExcMessage("A wedge has a material."));
  if (layers.size() == 1 && first.ratio == 0. && second.ratio == 0.)
    return corner_exponent(layers[0].angle, first.support, second.support, layers[0].kappa);
  return corner_exponent(SlippingWedges{layers, {}}, first, second);
}

double corner_exponent(const SlippingWedges &wedges, const EdgeCondition &first,
                       const EdgeCondition &second) {
  double kappa = 1.;
  for (const auto *const layers : {&wedges.first, &wedges.second})
    for (const WedgeLayer &layer : *layers)
      kappa = std::max(kappa, layer.kappa);
  const double angle = opening(wedges.first) + opening(wedges.second);
  return min_real_part(LayeredFunction{wedges, first, second, angle}, kappa, 1.);
}
} // namespace Signorini
