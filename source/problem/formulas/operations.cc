// SPDX-License-Identifier: LGPL-2.1-or-later
// The operations of formulas, on numbers and on intervals.

#include <signorini/base/instructions.h>

#include <algorithm>
#include <cmath>

#include "formula_tree.h"

namespace Signorini {
namespace FormulaParts {
namespace {
// The answer of a comparison is 0, 1, or both.
double positive(const double a) {
  return a > 0.;
}
double not_negative(const double a) {
  return a >= 0.;
}
double equals_zero(const double a) {
  return a == 0.;
}
Interval equals_zero(const Interval &a) {
  return {double(is_zero(a)), double(zero_in(a))};
}
double choose(const double a, const double b, const double c) {
  return a != 0. ? b : c;
}
/** Returns an interval that contains both values; BoxRun knows where the condition is decided. */
Interval choose(const Interval &, const Interval &b, const Interval &c) {
  return hull(b, c);
}

/** Whether (b, a) lies above the negative half axis, where atan2(a, b) jumps by 2 pi. Only a box
 * that touches this axis leaves it open: elsewhere one formula holds on both sides. */
double above_cut(double, double) {
  return 1.;
}
Interval above_cut(const Interval &a, const Interval &b) {
  return {double(!(a.lower() < 0. && a.upper() >= 0. && b.lower() <= 0.)), 1.};
}

/** Returns the angle of (b, a) in the part of a box that lies above the cut. On each line along an
 * axis it increases or decreases, so that the corners have the bounds. */
double angle(const double a, const double b) {
  // The sum of -0 and 0 is 0.
  return std::atan2(a + 0., b);
}
Interval angle(const Interval &a, const Interval &b) {
  const Interval upper = singleton(above_cut(a, b)) ? a : Interval(0., a.upper());
  return hull(hull(Interval(angle(upper.lower(), b.lower())), angle(upper.lower(), b.upper())),
              hull(Interval(angle(upper.upper(), b.lower())), angle(upper.upper(), b.upper())));
}

/** A product in which zero times infinity is zero. */
double times(const double a, const double b) {
  // Without branches, which registers of several numbers do not have.
  return (b == 0. ? 0. : a) * (a == 0. ? 0. : b);
}
Interval times(const Interval &a, const Interval &b) {
  return is_zero(a) || is_zero(b) ? 0. : zero_in(a) || zero_in(b) ? hull(a * b, 0.) : a * b;
}

constexpr std::size_t row_length = 8;

/** Computes f for a row of numbers. The compiler does this in registers, because the length is
 * known and the results overlap no argument. */
template <typename Rule>
SIGNORINI_INLINE inline void compute_row(const Rule &f, const double *const a,
                                         const double *const b, const double *const c,
                                         double *__restrict const result) {
  for (std::size_t k = 0; k < row_length; ++k)
    result[k] = f(a[k], b[k], c[k]);
}

/** Makes an operation of a function that takes numbers and intervals. */
template <typename Rule>
Operation rule(const char *name, const Rule &function, const char *in_a = nullptr,
               const char *in_b = nullptr, const Kind kind = Kind::smooth,
               const unsigned int precedence = 0) {
  static const Rule f = function;
  return {
    name, kind, in_a, in_b, precedence, 1, [](double a, double b, double c) { return f(a, b, c); },
    // No operation adds a product, so that the digits are the same with all instruction sets.
    [](const double *a, const double *b, const double *c, std::size_t n, double *result) {
      run(instructions_of_this_machine(), [=](auto) SIGNORINI_INLINE {
        std::size_t q = 0;
        for (; q + row_length <= n; q += row_length)
          compute_row(f, a + q, b + q, c + q, result + q);
        for (; q < n; ++q)
          result[q] = f(a[q], b[q], c[q]);
      });
    },
    [](const Interval &a, const Interval &b, const Interval &c) -> Interval { return f(a, b, c); }};
}

template <double (*f)(double)>
double monotone(const double a, double, double) {
  return f(a);
}
/** Returns f on an interval where it increases or decreases, restricted to where it is defined. */
template <double (*f)(double)>
Interval monotone(const Interval &a, const double low, const double high) {
  return hull(Interval(f(std::clamp(a.lower(), low, high))), f(std::clamp(a.upper(), low, high)));
}
template <double (*f)(double)>
Operation monotone(const char *name, const char *derivative, double low = -HUGE_VAL,
                   double high = HUGE_VAL) {
  [[maybe_unused]] static const double ends[] = {low, high};
  return rule(
    name, [](auto a, auto, auto) { return monotone<f>(a, ends[0], ends[1]); }, derivative);
}

/** The derivative of a step: 0 in a box on one side of the jump, otherwise the whole line. */
constexpr const char *jump = "1e300*(f - f)";

/** Makes a monotone step. */
template <double (*f)(double)>
Operation make_step(const char *name, const Kind kind) {
  Operation operation = monotone<f>(name, jump);
  operation.kind = kind;
  return operation;
}

double power(const double a, const double b) {
  return b == 2. ? a * a : b == 3. ? a * a * a : std::pow(a, b);
}
Interval power(const Interval &a, const Interval &b) {
  const double n = b.lower();
  return singleton(b) && n == std::round(n) && std::abs(n) < 1e9
           ? pow(a, static_cast<int>(n))
           : exp(b * monotone<std::log>(a, 0., HUGE_VAL));
}
} // namespace

const std::vector<Operation> &operations() {
  using std::cos, std::max, std::min, std::sin;
  static const std::vector<Operation> list = {
    {"||", Kind::definition, "a ? 1 : b ? 1 : 0", nullptr, 1},
    {"&&", Kind::definition, "a ? b ? 1 : 0 : 0", nullptr, 2},
    {"<=", Kind::definition, "_not_negative(b - a)", nullptr, 3},
    {">=", Kind::definition, "b <= a", nullptr, 3},
    {"==", Kind::definition, "_zero(b - a)", nullptr, 3},
    {"!=", Kind::definition, "a == b ? 0 : 1", nullptr, 3},
    {"<", Kind::definition, "_positive(b - a)", nullptr, 3},
    {">", Kind::definition, "b < a", nullptr, 3},
    rule(
      "+", [](auto a, auto b, auto) { return a + b; }, "1", "1", Kind::smooth, 4),
    rule(
      "-", [](auto a, auto b, auto) { return a - b; }, "1", "-1", Kind::smooth, 4),
    rule(
      "*", [](auto a, auto b, auto) { return a * b; }, "b", "a", Kind::product, 5),
    rule(
      "_times", [](auto a, auto b, auto) { return times(a, b); }, "b", "a", Kind::product),
    rule(
      "/", [](auto a, auto b, auto) { return a / b; }, "1/b", "-f/b", Kind::smooth, 5),
    rule(
      "^", [](auto a, auto b, auto) { return power(a, b); }, "b*a^(b-1)", "f*log(a)", Kind::power),
    make_step<positive>("_positive", Kind::sign_step),
    make_step<not_negative>("_not_negative", Kind::sign_step),
    rule(
      "_zero", [](auto a, auto, auto) { return equals_zero(a); }, jump, nullptr, Kind::zero_step),
    rule(
      "?", [](auto a, auto b, auto c) { return choose(a, b, c); }, jump, nullptr, Kind::choice),
    rule(
      "_larger", [](auto, auto b, auto c) { return max(c, b); }, nullptr, nullptr, Kind::choice),
    rule(
      "_smaller", [](auto, auto b, auto c) { return min(c, b); }, nullptr, nullptr, Kind::choice),
    rule(
      "sin", [](auto a, auto, auto) { return sin(a); }, "cos(a)"),
    rule(
      "cos", [](auto a, auto, auto) { return cos(a); }, "-sin(a)"),
    make_step<std::floor>("floor", Kind::integer_step),
    monotone<std::exp>("exp", "f"),
    monotone<std::log>("log", "1/a", 0.),
    monotone<std::log2>("log2", "1/(a*log(2))", 0.),
    monotone<std::log10>("log10", "1/(a*log(10))", 0.),
    monotone<std::sqrt>("sqrt", "0.5/f", 0.),
    monotone<std::asin>("asin", "1/sqrt(1 - a^2)", -1., 1.),
    monotone<std::acos>("acos", "-1/sqrt(1 - a^2)", -1., 1.),
    monotone<std::atan>("atan", "1/(1 + a^2)"),
    monotone<std::sinh>("sinh", "sqrt(1 + f^2)"),
    monotone<std::tanh>("tanh", "1 - f^2"),
    monotone<std::asinh>("asinh", "1/sqrt(a^2 + 1)"),
    monotone<std::acosh>("acosh", "1/sqrt(a^2 - 1)", 1.),
    monotone<std::atanh>("atanh", "1/(1 - a^2)", -1., 1.),
    monotone<std::erf>("erf", "2/sqrt(pi)*exp(-a^2)"),
    monotone<std::erfc>("erfc", "-2/sqrt(pi)*exp(-a^2)"),
    {"ln", Kind::definition, "log(a)"},
    {"tan", Kind::definition, "sin(a)/cos(a)"},
    {"cosh", Kind::definition, "0.5*(exp(a) + exp(-a))"},
    {"ceil", Kind::definition, "-floor(-a)"},
    {"rint", Kind::definition, "floor(a + 0.5)"},
    {"abs", Kind::definition, "_larger(_positive(a), a, 0 - a)"},
    {"sign", Kind::definition, "_positive(a) - _positive(-a)"},
    {"if", Kind::definition, "a ? b : c", nullptr, 0, 3},
    {"pow", Kind::definition, "a^b", nullptr, 0, 2},
    {"max", Kind::definition, "_larger(a < b, b, a)", nullptr, 0, 0},
    {"min", Kind::definition, "_smaller(b < a, b, a)", nullptr, 0, 0},
    {"sum", Kind::definition, "a + b", nullptr, 0, 0},
    {"avg", Kind::definition, "a + b", nullptr, 0, 0},
    rule("_vanishes", [](auto a, auto, auto) { return double(is_zero(a)); }),
    rule(
      "_above_cut", [](auto a, auto b, auto) { return above_cut(a, b); }, jump, nullptr,
      Kind::sign_step),
    rule(
      "_angle", [](auto a, auto b, auto) { return angle(a, b); }, "b/(a^2 + b^2)",
      "-a/(a^2 + b^2)"),
    {"atan2", Kind::definition,
     "_vanishes(a) ? (b < 0 ? pi : 0) : _above_cut(a, b) ? _angle(a, b) : -_angle(-a, b)", nullptr,
     0, 2}};
  return list;
}

const Operation *find_operation(const std::string &name) {
  const auto found =
    std::find_if(operations().begin(), operations().end(),
                 [&](const Operation &operation) { return name == operation.name; });
  return found == operations().end() ? nullptr : &*found;
}

bool is_known_function(const std::string &name) {
  return find_operation(name) != nullptr && name[0] != '_';
}

const Constants &known_constants() {
  static const Constants constants = {
    {"pi", std::acos(-1.)}, {"_pi", std::acos(-1.)}, {"_e", std::exp(1.)}};
  return constants;
}
} // namespace FormulaParts
} // namespace Signorini
