// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/problem/scene/formula.h>

#include <boost/numeric/interval.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace Signorini {
/** The operations of a formula. */
enum class Operation {
  number,
  coordinate,
  plus,
  minus,
  times,
  divided,
  power,
  less,
  less_or_equal,
  equal,
  both,
  either,
  choice,
  maximum,
  absolute,
  sign,
  floor,
  sine,
  cosine,
  monotone
};

namespace FormulaNumbers {
namespace lib = boost::numeric::interval_lib;
using Interval = boost::numeric::interval<
  double, lib::policies<lib::rounded_arith_exact<double>, lib::checking_base<double>>>;

constexpr double infinity = std::numeric_limits<double>::infinity();
/** The switch of what is undecided for another reason than the sign of one argument. */
constexpr std::uint64_t unknown_switch = std::uint64_t(1) << 63;

inline Interval whole() {
  return {-infinity, infinity};
}
/** Returns the interval between two ends in any order; NaN stands for anything. */
inline Interval between(const double a, const double b) {
  return std::isnan(a) || std::isnan(b) ? whole() : Interval(std::min(a, b), std::max(a, b));
}
inline bool is_point(const Interval &a, const double value) {
  return a.lower() == value && a.upper() == value;
}
inline bool is_point(const double a, const double value) {
  return a == value;
}
inline double hull_of(const double a, double) {
  return a;
}
inline Interval hull_of(const Interval &a, const Interval &b) {
  return boost::numeric::hull(a, b);
}

/** Returns f on an interval, where it increases or decreases, restricted to where it is defined. */
inline double apply(double (*const f)(double), const std::array<double, 2> &, const double a) {
  return f(a);
}
inline Interval apply(double (*const f)(double), const std::array<double, 2> &domain,
                      const Interval &a) {
  return between(f(std::clamp(a.lower(), domain[0], domain[1])),
                 f(std::clamp(a.upper(), domain[0], domain[1])));
}

inline double cosine_of(const double a) {
  return std::cos(a);
}
inline Interval cosine_of(const Interval &a) {
  constexpr double pi = 3.14159265358979323846;
  if (!(a.upper() - a.lower() < 2. * pi))
    return {-1., 1.};
  Interval values = between(std::cos(a.lower()), std::cos(a.upper()));
  // At the multiples k pi the cosine is 1 for even k and -1 for odd ones.
  for (double k = std::ceil(a.lower() / pi); k * pi <= a.upper(); ++k)
    values = hull_of(values, Interval(std::fmod(k, 2.) == 0. ? 1. : -1.));
  return values;
}

/** Returns a^b; b stands alone, so that integers are recognised. */
inline double power_of(const double a, const double b) {
  return b == 2. ? a * a : b == 3. ? a * a * a : std::pow(a, b);
}
inline Interval power_of(const Interval &a, const Interval &b) {
  const double n = b.lower();
  if (is_point(b, std::round(n)) && n < 0.)
    return 1. / power_of(a, -b);
  if (is_point(b, std::round(n))) {
    const Interval ends = between(power_of(a.lower(), n), power_of(a.upper(), n));
    return std::fmod(n, 2.) == 0. && a.lower() < 0. && a.upper() > 0. ? hull_of(ends, Interval(0.))
                                                                      : ends;
  }
  const double low = std::max(a.lower(), 0.), high = std::max(a.upper(), 0.);
  return hull_of(between(std::pow(low, b.lower()), std::pow(low, b.upper())),
                 between(std::pow(high, b.lower()), std::pow(high, b.upper())));
}

/** A value with its derivatives, and the switches that are undecided. */
template <int dim, typename Number>
struct Jet {
  Jet(const Number &number = Number(0.))
    : value(number) {
    slope.fill(Number(0.));
  }

  Number value;
  std::array<Number, dim> slope;
  std::uint64_t undecided = 0;

  /** Returns f(this) by the chain rule. */
  Jet follow(const Number &f, const Number &derivative) const {
    Jet result(*this);
    result.value = f;
    for (Number &d : result.slope)
      d = is_point(d, 0.) ? d : d * derivative;
    return result;
  }
  /** Adds factor times another slope. */
  void add(const Number &factor, const Jet &other) {
    for (int d = 0; d < dim; ++d)
      if (!is_point(other.slope[d], 0.))
        slope[d] += factor * other.slope[d];
    undecided |= other.undecided;
  }
};

template <int dim, typename Number>
Jet<dim, Number> sum(const Jet<dim, Number> &a, const double factor, const Jet<dim, Number> &b) {
  Jet<dim, Number> result(a);
  result.value = a.value + factor * b.value;
  result.add(Number(factor), b);
  return result;
}

template <int dim, typename Number>
Jet<dim, Number> product(const Jet<dim, Number> &a, const Jet<dim, Number> &b) {
  if (is_point(a.value, 0.) || is_point(b.value, 0.))
    if (a.undecided != 0 || b.undecided != 0)
      return Jet<dim, Number>();
  Jet<dim, Number> result = a.follow(a.value * b.value, b.value);
  result.add(a.value, b);
  return result;
}

template <int dim, typename Number>
Jet<dim, Number> quotient(const Jet<dim, Number> &a, const Jet<dim, Number> &b) {
  const Number inverse = Number(1.) / b.value;
  return product(a, b.follow(inverse, -inverse * inverse));
}

template <int dim, typename Number>
Jet<dim, Number> power_of(const Jet<dim, Number> &a, const Jet<dim, Number> &b) {
  const Number value = power_of(a.value, b.value);
  Jet<dim, Number> result =
    a.follow(value, b.value * power_of(a.value, Number(b.value - Number(1.))));
  if (std::any_of(b.slope.begin(), b.slope.end(),
                  [](const Number &d) { return !is_point(d, 0.); })) {
    static constexpr std::array<double, 2> positive = {{0., infinity}};
    result.add(value * apply(std::log, positive, a.value), b);
  }
  result.undecided |= b.undecided;
  return result;
}

/** Returns what is one of two values. */
template <int dim, typename Number>
Jet<dim, Number> hull_of(const Jet<dim, Number> &a, const Jet<dim, Number> &b) {
  Jet<dim, Number> result(hull_of(a.value, b.value));
  for (int d = 0; d < dim; ++d)
    result.slope[d] = hull_of(a.slope[d], b.slope[d]);
  result.undecided = a.undecided | b.undecided;
  return result;
}

/** Returns what jumps between two values where an argument changes its sign: the derivatives in the
 * coordinates of the argument may be anything. */
template <int dim>
Jet<dim, Interval> jump(const Jet<dim, Interval> &low, const Jet<dim, Interval> &high,
                        const Jet<dim, Interval> &argument, const std::uint64_t switches) {
  Jet<dim, Interval> result = hull_of(low, high);
  for (int d = 0; d < dim; ++d)
    if (!is_point(argument.slope[d], 0.))
      result.slope[d] = whole();
  result.undecided |= argument.undecided | switches;
  return result;
}
template <int dim>
Jet<dim, double> jump(const Jet<dim, double> &low, const Jet<dim, double> &,
                      const Jet<dim, double> &, std::uint64_t) {
  return low;
}
} // namespace FormulaNumbers
} // namespace Signorini
