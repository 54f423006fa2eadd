// SPDX-License-Identifier: LGPL-2.1-or-later
// The tree of a formula: values, derivatives, bounds in boxes, and the lines where it switches.

#include <signorini/problem/scene/formula.h>

#include <algorithm>
#include <bitset>
#include <cmath>

#include "formula_reader.h"
#include "formula_tree.h"

namespace Signorini {
using namespace FormulaNumbers;

template <int dim>
FormulaTree<dim>::FormulaTree(const std::string &text, const Constants &constants) {
  Reader(text, constants, *this);
}

template <int dim>
bool FormulaTree<dim>::is_constant() const {
  return std::none_of(nodes_.begin(), nodes_.end(),
                      [](const Node &node) { return node.operation == Operation::coordinate; });
}

namespace {
enum Branch { no, yes, undecided };

/** Returns whether an argument is positive at all points of a box but those of a set without area.
 * @param at_zero the answer where the argument is zero. */
Branch sign_of(const double value, const bool at_zero) {
  return value > 0. || (at_zero && value == 0.) ? yes : no;
}
Branch sign_of(const Interval &value, const bool at_zero) {
  if (is_point(value, 0.))
    return at_zero ? yes : no;
  return value.lower() >= 0. ? yes : value.upper() <= 0. ? no : undecided;
}
Branch truth_of(const double value) {
  return value != 0. ? yes : no;
}
Branch truth_of(const Interval &value) {
  if (is_point(value, 0.))
    return no;
  return value.lower() > 0. || value.upper() < 0. ? yes : undecided;
}

double larger_of(const double a, const double b) {
  return std::max(a, b);
}
Interval larger_of(const Interval &a, const Interval &b) {
  return {std::max(a.lower(), b.lower()), std::max(a.upper(), b.upper())};
}
double lower_end(const double a) {
  return a;
}
double lower_end(const Interval &a) {
  return a.lower();
}
double upper_end(const double a) {
  return a;
}
double upper_end(const Interval &a) {
  return a.upper();
}

/** Returns the derivative of a monotone function. @param f its values. */
template <typename Number>
Number derivative(const std::string &name, const Number &a, const Number &f) {
  const std::array<double, 2> positive = {{0., infinity}};
  const auto root = [&](const Number &square) { return apply(std::sqrt, positive, square); };
  const auto bell = [&] {
    return Number(2. / std::sqrt(std::acos(-1.))) *
           apply(std::exp, {{-infinity, infinity}}, Number(-power_of(a, Number(2.))));
  };
  const Number one(1.), square = power_of(a, Number(2.));
  if (name == "exp")
    return f;
  if (name == "log" || name == "ln")
    return one / a;
  if (name == "log2" || name == "log10")
    return one / (a * Number(std::log(name == "log2" ? 2. : 10.)));
  if (name == "sqrt")
    return Number(0.5) / f;
  if (name == "asin" || name == "acos")
    return Number(name == "asin" ? 1. : -1.) / root(Number(one - square));
  if (name == "atan")
    return one / (one + square);
  if (name == "sinh")
    return root(Number(one + power_of(f, Number(2.))));
  if (name == "tanh")
    return one - power_of(f, Number(2.));
  if (name == "asinh")
    return one / root(Number(square + one));
  if (name == "acosh")
    return one / root(Number(square - one));
  if (name == "atanh")
    return one / (one - square);
  return name == "erf" ? bell() : Number(-bell());
}

std::uint64_t bit(const unsigned int k) {
  return k < 63 ? std::uint64_t(1) << k : unknown_switch;
}
} // namespace

/** One evaluation of all parts with jets of a type of numbers. */
template <int dim>
template <typename Number>
struct FormulaTree<dim>::Run {
  using Value = Jet<dim, Number>;

  std::array<Number, dim> x;
  /** The switches whose branch is given, and the branches. */
  std::uint64_t forced = 0, branches = 0;
  std::vector<Value> parts = {};
  /** What the switches compare with zero. */
  std::vector<Value> arguments = {};

  Branch decide(const unsigned int k, const Value &argument, const bool at_zero) {
    arguments[k] = argument;
    if ((forced & bit(k) & ~unknown_switch) != 0)
      return (branches & bit(k)) != 0 ? yes : no;
    return sign_of(argument.value, at_zero);
  }
  /** Returns one of two values, by the sign of the argument. */
  Value step(const unsigned int k, const Value &argument, const bool at_zero, const double low,
             const double high) {
    const Branch branch = decide(k, argument, at_zero);
    if (branch == undecided)
      return jump(Value(Number(low)), Value(Number(high)), argument, bit(k));
    return Value(Number(branch == yes ? high : low));
  }
  /** Returns whether two values are equal: nowhere, but on a line, if they vary. */
  static Value equal(const Value &a, const Value &b) {
    const Value difference = sum(a, -1., b);
    const Branch differs = truth_of(difference.value);
    const bool varies = std::any_of(difference.slope.begin(), difference.slope.end(),
                                    [](const Number &d) { return !is_point(d, 0.); });
    if (differs == undecided && (difference.undecided != 0 || !varies))
      return jump(Value(Number(0.)), Value(Number(1.)), difference, unknown_switch);
    return Value(Number(differs == no ? 1. : 0.));
  }
  Value larger(const unsigned int k, const Value &difference, const Value &a, const Value &b) {
    const Branch branch = decide(k, difference, true);
    if (branch != undecided)
      return branch == yes ? a : b;
    Value result = hull_of(a, b);
    result.value = larger_of(a.value, b.value);
    result.undecided |= bit(k);
    return result;
  }
  Value sign(const unsigned int k, const Value &a) {
    return is_point(a.value, 0.) ? Value() : step(k, a, false, -1., 1.);
  }
  /** A box may touch the next step with its upper end. */
  Value floor(const unsigned int k, const Value &a) {
    const double low = std::floor(lower_end(a.value)), high = std::floor(upper_end(a.value));
    if (low == high)
      return Value(Number(low));
    if (high == low + 1.)
      return step(k, sum(a, -1., Value(Number(high))), true, low, high);
    return jump(Value(Number(low)), Value(Number(high)), a, unknown_switch);
  }
  static Value both(const Value &a, const Value &b) {
    const Branch of_a = truth_of(a.value), of_b = truth_of(b.value);
    if (of_a == no || of_b == no)
      return Value();
    const Value &rest = of_a == undecided ? a : b;
    if (of_a == yes && of_b == yes)
      return Value(Number(1.));
    const bool known = rest.undecided != 0;
    const Value first = jump(Value(), Value(Number(1.)), rest, known ? 0 : unknown_switch);
    return of_a == undecided && of_b == undecided ? jump(first, first, b, 0) : first;
  }
  static Value not_of(const Value &a) {
    const Branch of_a = truth_of(a.value);
    if (of_a != undecided)
      return Value(Number(of_a == yes ? 0. : 1.));
    return jump(Value(), Value(Number(1.)), a, a.undecided != 0 ? 0 : unknown_switch);
  }
  static Value choose(const Value &condition, const Value &a, const Value &b) {
    const Branch branch = truth_of(condition.value);
    if (branch != undecided)
      return branch == yes ? a : b;
    return jump(a, b, condition, condition.undecided != 0 ? 0 : unknown_switch);
  }
  static Value cosine(const Value &a, const double shift) {
    const Number moved = a.value - Number(shift);
    return a.follow(cosine_of(moved), Number(-cosine_of(Number(moved - Number(half_pi)))));
  }
  static constexpr double half_pi = 1.57079632679489661923;

  Value part(const Node &node) {
    const Value &a = parts[node.arguments[0]], &b = parts[node.arguments[1]];
    const unsigned int k = node.switch_number;
    switch (node.operation) {
    case Operation::number:
      return Value(Number(node.value));
    case Operation::coordinate: {
      const auto d = static_cast<unsigned int>(node.value);
      Value result(x[d]);
      result.slope[d] = Number(1.);
      return result;
    }
    case Operation::plus:
      return sum(a, 1., b);
    case Operation::minus:
      return sum(a, -1., b);
    case Operation::times:
      return product(a, b);
    case Operation::divided:
      return quotient(a, b);
    case Operation::power:
      return power_of(a, b);
    case Operation::less:
      return step(k, sum(b, -1., a), false, 0., 1.);
    case Operation::less_or_equal:
      return step(k, sum(b, -1., a), true, 0., 1.);
    case Operation::equal:
      return equal(a, b);
    case Operation::both:
      return both(a, b);
    case Operation::either:
      return not_of(both(not_of(a), not_of(b)));
    case Operation::choice:
      return choose(a, b, parts[node.arguments[2]]);
    case Operation::maximum:
      return larger(k, sum(a, -1., b), a, b);
    case Operation::absolute:
      return larger(k, a, a, product(Value(Number(-1.)), a));
    case Operation::sign:
      return sign(k, a);
    case Operation::floor:
      return floor(k, a);
    case Operation::sine:
      return cosine(a, half_pi);
    case Operation::cosine:
      return cosine(a, 0.);
    default: {
      const auto &[name, f, domain] = monotone_functions[static_cast<unsigned int>(node.value)];
      const Number value = apply(f, domain, a.value);
      return a.follow(value, derivative(name, a.value, value));
    }
    }
  }
};

template <int dim>
template <typename Number>
void FormulaTree<dim>::evaluate(Run<Number> &run) const {
  run.parts.assign(nodes_.size(), Jet<dim, Number>());
  run.arguments.resize(n_switches_);
  for (std::size_t i = 0; i < nodes_.size(); ++i)
    run.parts[i] = run.part(nodes_[i]);
}

template <int dim>
void FormulaTree<dim>::values(const Point<dim> *const points, const std::size_t n,
                              double *const values) const {
  constexpr std::size_t block = 32;
  thread_local std::vector<double> parts;
  for (std::size_t start = 0; start < n; start += block) {
    const std::size_t size = std::min(block, n - start);
    parts.resize(nodes_.size() * size);
    for (std::size_t i = 0; i < nodes_.size(); ++i)
      evaluate_block(nodes_[i], points + start, size, parts.data(), parts.data() + i * size);
    std::copy_n(parts.end() - size, size, values + start);
  }
}

template <int dim>
void FormulaTree<dim>::evaluate_block(const Node &node, const Point<dim> *const points,
                                      const std::size_t n, const double *const parts,
                                      double *const result) {
  const double *const a = parts + node.arguments[0] * n, *const b = parts + node.arguments[1] * n,
                      *const c = parts + node.arguments[2] * n;
  const auto fill = [&](const auto &f) {
    for (std::size_t q = 0; q < n; ++q)
      result[q] = f(q);
  };
  switch (node.operation) {
  case Operation::number:
    return fill([&](std::size_t) { return node.value; });
  case Operation::coordinate:
    return fill(
      [&](const std::size_t q) { return points[q][static_cast<unsigned int>(node.value)]; });
  case Operation::plus:
    return fill([&](const std::size_t q) { return a[q] + b[q]; });
  case Operation::minus:
    return fill([&](const std::size_t q) { return a[q] - b[q]; });
  case Operation::times:
    return fill([&](const std::size_t q) { return a[q] * b[q]; });
  case Operation::divided:
    return fill([&](const std::size_t q) { return a[q] / b[q]; });
  case Operation::power:
    return fill([&](const std::size_t q) { return power_of(a[q], b[q]); });
  case Operation::less:
    return fill([&](const std::size_t q) { return a[q] < b[q] ? 1. : 0.; });
  case Operation::less_or_equal:
    return fill([&](const std::size_t q) { return a[q] <= b[q] ? 1. : 0.; });
  case Operation::equal:
    return fill([&](const std::size_t q) { return a[q] == b[q] ? 1. : 0.; });
  case Operation::both:
    return fill([&](const std::size_t q) { return a[q] != 0. && b[q] != 0. ? 1. : 0.; });
  case Operation::either:
    return fill([&](const std::size_t q) { return a[q] != 0. || b[q] != 0. ? 1. : 0.; });
  case Operation::choice:
    return fill([&](const std::size_t q) { return a[q] != 0. ? b[q] : c[q]; });
  case Operation::maximum:
    return fill([&](const std::size_t q) { return std::max(a[q], b[q]); });
  case Operation::absolute:
    return fill([&](const std::size_t q) { return std::abs(a[q]); });
  case Operation::sign:
    return fill([&](const std::size_t q) { return a[q] > 0. ? 1. : a[q] < 0. ? -1. : 0.; });
  case Operation::floor:
    return fill([&](const std::size_t q) { return std::floor(a[q]); });
  case Operation::sine:
    return fill([&](const std::size_t q) { return std::sin(a[q]); });
  case Operation::cosine:
    return fill([&](const std::size_t q) { return std::cos(a[q]); });
  default:
    const auto f = monotone_functions[static_cast<unsigned int>(node.value)].f;
    return fill([&](const std::size_t q) { return f(a[q]); });
  }
}

template <int dim>
double FormulaTree<dim>::value(const Point<dim> &x) const {
  double value = 0.;
  values(&x, 1, &value);
  return value;
}

template <int dim>
Tensor<1, dim> FormulaTree<dim>::gradient(const Point<dim> &x) const {
  Run<double> run;
  std::copy(x.begin_raw(), x.end_raw(), run.x.begin());
  evaluate(run);
  Tensor<1, dim> gradient;
  std::copy(run.parts.back().slope.begin(), run.parts.back().slope.end(), gradient.begin_raw());
  return gradient;
}

namespace {
/** Returns whether two lines are the same in a box, up to rounding. */
template <int dim>
bool are_same(const KinkLine<dim> &a, const KinkLine<dim> &b, const FormulaBox<dim> &box) {
  const double sign = a.normal * b.normal < 0. ? -1. : 1.;
  const double rounding =
    1e-9 * box.upper.distance(box.lower) + 1e-12 * box.upper.distance(Point<dim>());
  return (a.normal - sign * b.normal).norm() < 1e-9 &&
         std::abs(a.signed_distance(box.centre()) - sign * b.signed_distance(box.centre())) <
           rounding;
}

/** Returns the coordinates of a box without its boundary: what happens there has no area. */
template <int dim>
std::array<Interval, dim> interior_of(const FormulaBox<dim> &box) {
  std::array<Interval, dim> x;
  for (int d = 0; d < dim; ++d) {
    const double margin = 1e-9 * (box.upper[d] - box.lower[d]);
    x[d] = Interval(box.lower[d] + margin, box.upper[d] - margin);
  }
  return x;
}
} // namespace

template <int dim>
template <typename Number>
Enclosure<dim> FormulaTree<dim>::enclosure(const Run<Number> &run) const {
  const Jet<dim, Interval> &root = run.parts.back();
  Enclosure<dim> result = {root.value.lower(), root.value.upper(), {}};
  Point<dim> centre;
  for (int d = 0; d < dim; ++d)
    centre[d] = boost::numeric::median(run.x[d]);
  // The formula may have another value on a line through the centre, such as where x == 0.5.
  const double at_centre = run.forced == 0 ? value(centre) : infinity;
  const bool is_typical = at_centre >= result.lower && at_centre <= result.upper;
  Interval mean(is_typical ? at_centre : infinity);
  for (int d = 0; d < dim; ++d) {
    result.varies[d] = !is_point(root.slope[d], 0.);
    if (result.varies[d])
      mean += root.slope[d] * (run.x[d] - centre[d]);
  }
  if (std::isfinite(mean.lower()) && std::isfinite(mean.upper())) {
    result.lower = std::max(result.lower, mean.lower());
    result.upper = std::max(result.lower, std::min(result.upper, mean.upper()));
  }
  if (!(result.lower <= result.upper))
    std::tie(result.lower, result.upper) = std::pair(-infinity, infinity);
  return result;
}

template <int dim>
Enclosure<dim> FormulaTree<dim>::enclose(const FormulaBox<dim> &box) const {
  Run<Interval> run = {interior_of(box)};
  evaluate(run);
  return enclosure(run);
}

template <int dim>
template <typename Number>
std::optional<KinkLine<dim>> FormulaTree<dim>::line_of(const unsigned int k,
                                                       const Run<Number> &run) const {
  const auto &argument = run.arguments[k];
  if (argument.undecided != 0)
    return {};
  Tensor<1, dim> normal;
  Point<dim> centre;
  double width = 0.;
  for (int d = 0; d < dim; ++d) {
    normal[d] = boost::numeric::median(argument.slope[d]);
    width = std::max(width, boost::numeric::width(argument.slope[d]));
    centre[d] = boost::numeric::median(run.x[d]);
  }
  const double size = normal.norm();
  if (!(width <= 1e-12 * size) || size == 0.)
    return {};
  // The middle of the interval of an affine expression is its value at the centre.
  const double value = boost::numeric::median(argument.value);
  return KinkLine<dim>{normal / size, (normal * (centre - Point<dim>()) - value) / size};
}

template <int dim>
template <typename Number, typename Visitor>
bool FormulaTree<dim>::visit_branches(Run<Number> &run, const Visitor &visit) const {
  constexpr unsigned int deepest = 6;
  evaluate(run);
  const std::uint64_t undecided = run.parts.back().undecided;
  std::optional<KinkLine<dim>> line;
  unsigned int k = 0;
  for (; k < std::min(n_switches_, 63U) && !line; ++k)
    if ((undecided & bit(k)) != 0)
      line = line_of(k, run);
  if (std::bitset<64>(run.forced).count() == deepest)
    line.reset();
  if (!visit(run, line) || !line)
    return undecided == 0;
  bool all = true;
  for (const std::uint64_t branch : {std::uint64_t(0), bit(k - 1)}) {
    Run<Number> forced = {run.x};
    forced.forced = run.forced | bit(k - 1);
    forced.branches = run.branches | branch;
    all = visit_branches(forced, visit) && all;
  }
  return all;
}

template <int dim>
std::vector<KinkLine<dim>> FormulaTree<dim>::lines_in(const FormulaBox<dim> &box, bool &all) const {
  Run<Interval> run = {interior_of(box)};
  std::vector<KinkLine<dim>> lines;
  all = visit_branches(run, [&](const Run<Interval> & /*branch*/, const auto &line) {
    if (line && std::none_of(lines.begin(), lines.end(),
                             [&](const auto &other) { return are_same(*line, other, box); }))
      lines.push_back(*line);
    return true;
  });
  return lines;
}

template <int dim>
bool FormulaTree<dim>::is_shown(const FormulaBox<dim> &box, const std::vector<KinkLine<dim>> &lines,
                                const double tolerance) const {
  Run<Interval> run = {interior_of(box)};
  bool is_shown = true;
  visit_branches(run, [&](const Run<Interval> &branch, const auto &line) {
    if (!is_shown || enclosure(branch).width() <= tolerance)
      return false;
    if (branch.parts.back().undecided == 0)
      is_shown = is_smooth(box, branch);
    else
      is_shown = line && std::any_of(lines.begin(), lines.end(), [&](const auto &known) {
                   return are_same(*line, known, box);
                 });
    return is_shown;
  });
  return is_shown;
}

template <int dim>
template <typename Number>
bool FormulaTree<dim>::is_smooth(const FormulaBox<dim> &box, const Run<Number> &of_box) const {
  constexpr unsigned int n = n_samples;
  std::array<unsigned int, dim + 1> stride = {{1}};
  double largest_step = 0.;
  for (unsigned int d = 0; d < dim; ++d) {
    const double width = box.upper[d] - box.lower[d];
    stride[d + 1] = stride[d] * (width > 0. ? n : 1);
    const Interval slope = boost::numeric::abs(of_box.parts.back().slope[d]);
    largest_step += width > 0. && slope.upper() > 0. ? slope.upper() * width / n : 0.;
  }
  Run<double> run;
  run.forced = of_box.forced;
  run.branches = of_box.branches;
  std::vector<double> samples;
  for (unsigned int i = 0; i < stride[dim]; ++i) {
    for (unsigned int d = 0; d < dim; ++d) {
      const unsigned int k = i / stride[d] % n;
      run.x[d] = box.lower[d] + (k + 0.5) / n * (box.upper[d] - box.lower[d]);
    }
    evaluate(run);
    samples.push_back(run.parts.back().value);
  }
  const auto [low, high] = std::minmax_element(samples.begin(), samples.end());
  // A parabola with its top in the box has a largest step of 0.65 of what the samples show.
  if (!(largest_step <= 0.7 * (*high - *low)))
    return false;
  double fourth = 0.;
  for (unsigned int d = 0; d < dim; ++d)
    for (unsigned int i = 0; i < samples.size() && stride[d + 1] > stride[d]; ++i)
      if (const unsigned int s = stride[d]; i / s % n + 4 < n)
        fourth =
          std::max(fourth, std::abs(samples[i] - 4. * samples[i + s] + 6. * samples[i + 2 * s] -
                                    4. * samples[i + 3 * s] + samples[i + 4 * s]));
  return fourth <= 0.05 * (*high - *low);
}

template class FormulaTree<1>;
template class FormulaTree<2>;
template class FormulaTree<3>;
} // namespace Signorini
