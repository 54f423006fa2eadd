// SPDX-License-Identifier: LGPL-2.1-or-later
// The leading exponent of plane elasticity at a corner: roots of entire functions.

#include <signorini/problem/scene/corners.h>

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

/** The function constant + linear z + square z^2 + sine sin(frequency z) + cosine cos(frequency z);
 * its roots z are exponents. */
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
  /** Returns a bound of the terms: f is known up to rounding of this number. */
  double size(const Complex z) const
  {
    return std::abs(constant) + std::abs(linear * z) + std::abs(square * z * z) +
           (std::abs(sine) + std::abs(cosine)) * std::cosh(frequency * z.imag());
  }
};

/** Returns the functions of (W1) to (W6). Functions that are products are given by their factors,
 * so that roots are simple at straight angles and at cracks. */
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

/** Returns the root that Newton's method finds from z, or nothing. */
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

/** Returns whether solutions with this exponent are polynomials. */
bool is_integer(const Complex exponent)
{
  return std::abs(exponent - std::round(exponent.real())) < 1e-6;
}

/** Returns the smallest Re z > 0 of the roots, which Newton's method finds from the points of a
 * grid. With |frequency Im z| > 6 + log(1 + kappa) a sine or cosine is larger than all other terms;
 * roots come in pairs z, conj(z). */
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

// Where the sides of a 2-D body meet, and how rough a displacement may be there.

namespace
{
using dealii::numbers::PI;

/** An end of a smooth part of a side, with the direction in which the side leaves it. */
struct SideEnd
{
  unsigned int side;
  dealii::Point<2> position;
  dealii::Tensor<1, 2> direction;
  /** Whether a walk with the body on its left leaves the point along this side. */
  bool leaves;
};

/** Returns the end at s of the part that lies in the direction of @p towards. */
SideEnd
side_end(const Side<2> &side, const unsigned int number, const double s, const double towards)
{
  const dealii::Tensor<1, 2> normal = side.normal(s, towards);
  const dealii::Tensor<1, 2> along_walk({-normal[1], normal[0]});
  const dealii::Tensor<1, 2> direction = (towards > s ? 1. : -1.) * side.tangent(s, towards);
  const bool leaves = along_walk * direction > 0.;
  return {number, side.point(s), leaves ? along_walk : -along_walk, leaves};
}

/** Returns the ends of a side, and those of its smooth parts at corners inside. */
std::vector<SideEnd> ends_of(const Side<2> &side, const unsigned int number)
{
  std::vector<SideEnd> ends;
  const double length = side.length();
  if (!side.is_closed())
    ends = {side_end(side, number, 0., length), side_end(side, number, length, 0.)};
  for (const double s : side.corners())
    for (const double towards : {s - length, s + length})
      ends.push_back(side_end(side, number, s, towards));
  return ends;
}

/** Returns the angle from the direction of one end counter-clockwise to that of the other, in (0, 2
 * pi]. */
double opening(const SideEnd &first, const SideEnd &second)
{
  const dealii::Tensor<1, 2> &a = first.direction, &b = second.direction;
  const double angle = std::atan2(a[0] * b[1] - a[1] * b[0], a * b);
  // A body does not end in a cusp: parallel sides are those of a crack.
  return angle > 1e-8 ? angle : angle + 2. * PI;
}
} // namespace

std::vector<Corner> corners(const Geometry<2> &geometry)
{
  std::vector<SideEnd> leaving, arriving;
  for (unsigned int i = 0; i < geometry.sides.size(); ++i)
    for (const SideEnd &end : ends_of(geometry.sides[i], i))
      (end.leaves ? leaving : arriving).push_back(end);
  std::vector<Corner> found;
  for (const SideEnd &first : leaving)
  {
    // Where the body touches itself, it lies between a side and the next one.
    std::vector<Corner> here;
    for (const SideEnd &second : arriving)
      if (first.position.distance(second.position) < 1e-8 * geometry.diameter())
        here.push_back({first.position, opening(first, second), {{first.side, second.side}}});
    const auto next = std::min_element(
      here.begin(), here.end(), [](const Corner &a, const Corner &b) { return a.angle < b.angle; });
    if (next != here.end())
      found.push_back(*next);
  }
  return found;
}

std::vector<EdgeSupport> possible_supports(const Role role)
{
  switch (role)
  {
  case Role::clamped:
  case Role::displacement:
    return {EdgeSupport::held};
  case Role::roller:
    return {EdgeSupport::sliding};
  case Role::contact:
    return {EdgeSupport::free, EdgeSupport::sliding};
  case Role::free:
  case Role::traction:
    break;
  }
  return {EdgeSupport::free};
}

double corner_exponent(const Scene<2> &scene, const Corner &corner)
{
  const double kappa = kolosov_constant(scene.material->relative_hooke(corner.position));
  double smallest = largest_corner_exponent;
  for (const EdgeSupport first : possible_supports(scene.boundary[corner.sides[0]].role))
    for (const EdgeSupport second : possible_supports(scene.boundary[corner.sides[1]].role))
      smallest = std::min(smallest, corner_exponent(corner.angle, first, second, kappa));
  return smallest;
}
} // namespace Signorini
