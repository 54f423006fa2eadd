// SPDX-License-Identifier: LGPL-2.1-or-later
// The tree of a formula: values, derivatives, bounds in boxes, and the lines where it switches.

#include <signorini/problem/formulas/formula.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

#include "formula_reader.h"
#include "formula_tree.h"

namespace Signorini {
namespace FormulaParts {
namespace {
/** Returns whether a line is among others in a box, up to rounding. */
template <int dim>
bool is_among(const std::vector<KinkLine<dim>> &lines, const KinkLine<dim> &line,
              const FormulaBox<dim> &box) {
  const double rounding = 1e-9 * box.upper.distance(box.lower) + 1e-12 * box.upper.norm();
  return std::any_of(lines.begin(), lines.end(), [&](const KinkLine<dim> &other) {
    return line.coincides(other, box.centre(), rounding);
  });
}

/** A part in a box. */
struct Box {
  Interval value;
  bool is_fixed = false;
  /** The switches that the box does not decide. */
  std::uint64_t undecided = 0;
};

/** The parts of a formula in a box. */
template <int dim>
class BoxRun {
public:
  BoxRun(const Formula &formula, const FormulaBox<dim> &box)
    : formula_(formula)
    , box_(box) {
    for (const Node &node : formula.nodes)
      parts_.push_back({node.value, node.is_fixed});
    evaluate(box, parts_.size());
  }
  /** Evaluates one branch of an undecided switch. */
  BoxRun on_branch(const Index number, const bool after) const {
    return with_fixed(number, parts_[number].value.upper() - (after ? 0. : 1.));
  }
  /** Evaluates the branch on which all undecided switches have their values at a point. @return
   * nothing if one of them does not change on @p line. */
  std::optional<BoxRun> beside(const KinkLine<dim> &line, const Point<dim> &x) const {
    Index number = 0;
    const auto found = line_of_switch(number);
    if (!found)
      return root().undecided == 0 ? std::optional<BoxRun>(*this) : std::nullopt;
    if (!is_among({line}, *found, box_))
      return {};
    return with_fixed(number, value(x, number)).beside(line, x);
  }
  double value_at(const Point<dim> &x) const {
    return median(value(x, formula_.root));
  }

  const Box &root() const {
    return parts_[formula_.root];
  }
  /** Returns the intersection of the tree's bounds with f(c) + f'(box)(box - c). */
  Enclosure<dim> bounds() const {
    Enclosure<dim> result;
    const Point<dim> centre = box_.centre();
    Interval mean = value(centre, formula_.root);
    for (int d = 0; d < dim; ++d) {
      const Interval &slope = slope_of(formula_.root, d);
      mean += slope * (parts_[d].value - centre[d]);
      result.varies[d] = !is_zero(slope);
    }
    Interval best = intersect(root().value, mean);
    if (empty(best))
      best = empty(root().value) ? Interval::whole() : root().value;
    result.lower = best.lower();
    result.upper = best.upper();
    return result;
  }
  /** Finds the first undecided switch that changes on a line: its argument is affine, or depends on
   * one coordinate and is monotone in it. @return the line. */
  std::optional<KinkLine<dim>> line_of_switch(Index &number) const {
    for (const Index i : formula_.switches) {
      const Node &node = formula_.nodes[i];
      if ((root().undecided >> node.bit & 1U) == 0 || parts_[node.arguments[0]].undecided != 0)
        continue;
      bool is_affine = true;
      unsigned int n_directions = 0, last = 0;
      Tensor<1, dim> normal;
      for (int d = 0; d < dim; ++d) {
        const Interval &slope = slope_of(node.arguments[0], d);
        normal[d] = slope.lower();
        is_affine = is_affine && singleton(slope);
        if (!is_zero(slope)) {
          ++n_directions;
          last = d;
        }
      }
      const bool is_monotone = n_directions == 1 && !zero_in(slope_of(node.arguments[0], last));
      if (n_directions == 0 || !(is_affine || is_monotone))
        continue;
      number = i;
      if (!is_affine)
        return KinkLine<dim>{Point<dim>::unit_vector(last), root_of_switch(i, last)};
      // The middle of an affine expression is its value at the centre.
      const double value = median(parts_[node.arguments[0]].value) - level_of_switch(i);
      return KinkLine<dim>{normal / normal.norm(),
                           (normal * box_.centre() - value) / normal.norm()};
    }
    return {};
  }
  /** Returns whether 8 samples in each direction show the formula: they are close enough
   * for its slopes, and smooth. */
  bool is_smooth() const {
    constexpr unsigned int n = 8;
    std::array<unsigned int, dim + 1> stride = {{1}};
    for (int d = 0; d < dim; ++d)
      stride[d + 1] = stride[d] * (box_.upper[d] > box_.lower[d] ? n : 1);
    std::vector<double> samples;
    BoxRun sample(*this);
    for (Index i = 0; i < stride[dim]; ++i) {
      const Point<dim> x = part_of(box_, i, n).centre();
      sample.evaluate({x, x}, formula_.n_values);
      samples.push_back(median(sample.root().value));
    }
    const auto [low, high] = std::minmax_element(samples.begin(), samples.end());
    double fourth = 0.;
    for (int d = 0; d < dim; ++d)
      for (Index i = 0; i < samples.size(); ++i)
        if (const Index s = stride[d]; stride[d + 1] > s && i / s % n + 4 < n)
          fourth =
            std::max(fourth, std::abs(samples[i] - 4. * samples[i + s] + 6. * samples[i + 2 * s] -
                                      4. * samples[i + 3 * s] + samples[i + 4 * s]));
    // A parabola with its top in the box has a largest step of 0.65 of the range that the samples
    // show. There the slopes of the whole box may be too large by any factor; those of its parts
    // are not.
    const double shown = *high - *low;
    if (fourth <= 0.05 * shown && largest_step(n) <= 0.7 * shown)
      return true;
    constexpr unsigned int most_halvings = 5;
    return fourth <= 0.002 * shown &&
           BoxRun(*this).steps_are_small(n, 0.7 * shown, most_halvings, box_);
  }

private:
  BoxRun with_fixed(const Index number, const Interval &value) const {
    BoxRun result(*this);
    result.parts_[number] = {value, true};
    result.evaluate(box_, parts_.size());
    return result;
  }
  const Interval &slope_of(const Index i, const int d) const {
    return parts_[formula_.slopes[i][d]].value;
  }
  /** Returns part i of a box, which is cut into n parts in each direction in which it has a width.
   */
  static FormulaBox<dim> part_of(const FormulaBox<dim> &box, Index i, const unsigned int n) {
    FormulaBox<dim> part = box;
    for (int d = 0; d < dim; ++d)
      if (const double width = (box.upper[d] - box.lower[d]) / n; width > 0.) {
        part.lower[d] += i % n * width;
        part.upper[d] = part.lower[d] + width;
        i /= n;
      }
    return part;
  }
  Index n_parts(const unsigned int n) const {
    Index product = 1;
    for (int d = 0; d < dim; ++d)
      product *= box_.upper[d] > box_.lower[d] ? n : 1;
    return product;
  }
  /** Returns a bound of the change from one of n samples of the box in each direction to the next,
   * by the slopes where the parts were evaluated last. */
  double largest_step(const unsigned int n) const {
    double step = 0.;
    for (int d = 0; d < dim; ++d)
      if (const double width = box_.upper[d] - box_.lower[d]; width > 0.)
        step += norm(slope_of(formula_.root, d)) * width / n;
    return step;
  }
  /** Returns whether the steps between samples are not above a limit by the slopes in parts of the
   * box where it was evaluated last. These are halved where their bounds are too large. */
  bool steps_are_small(const unsigned int n, const double limit, const unsigned int halvings,
                       const FormulaBox<dim> &part) {
    evaluate(part, parts_.size());
    if (largest_step(n) <= limit)
      return true;
    bool are_small = halvings > 0;
    for (Index i = 0; are_small && i < n_parts(2); ++i)
      are_small = steps_are_small(n, limit, halvings - 1, part_of(part, i, 2));
    return are_small;
  }
  /** Returns the value of the argument at which a switch changes; an integer_step changes at the
   * upper one of two values. */
  double level_of_switch(const Index i) const {
    return formula_.nodes[i].operation->kind == Kind::integer_step ? parts_[i].value.upper() : 0.;
  }
  /** Returns where a monotone argument of one coordinate reaches the level of its switch; one end
   * of the box if it does not. */
  double root_of_switch(const Index i, const unsigned int d) const {
    const auto above = [&](const double at) {
      Point<dim> x = box_.centre();
      x[d] = at;
      return median(value(x, formula_.nodes[i].arguments[0])) - level_of_switch(i);
    };
    double from = box_.lower[d], to = box_.upper[d];
    const bool rises = above(to) > above(from);
    for (unsigned int bisection = 0; bisection < 60; ++bisection) {
      const double middle = from + 0.5 * (to - from);
      ((above(middle) > 0.) == rises ? to : from) = middle;
    }
    return to;
  }
  /** Returns the value of a part at a point of the box, on the same branches. */
  Interval value(const Point<dim> &x, const Index part) const {
    BoxRun at_x(*this);
    at_x.evaluate({x, x}, formula_.n_values);
    return at_x.parts_[part].value;
  }
  void evaluate(const FormulaBox<dim> &box, const Index n_parts) {
    for (int d = 0; d < dim; ++d) {
      // Without the boundary, which has no area.
      const double margin = 1e-9 * (box.upper[d] - box.lower[d]);
      parts_[d].value = Interval(box.lower[d] + margin, box.upper[d] - margin);
    }
    for (Index i = 3; i < n_parts; ++i)
      if (!parts_[i].is_fixed) {
        parts_[i] = part(formula_.nodes[i]);
        parts_[i].is_fixed = false;
      }
  }
  Box part(const Node &node) const {
    const Box &a = parts_[node.arguments[0]], &b = parts_[node.arguments[1]],
              &c = parts_[node.arguments[2]];
    const bool is_choice = node.operation->kind == Kind::choice;
    if (is_choice && (singleton(a.value) || !zero_in(a.value)))
      return is_zero(a.value) ? c : b;
    Box result = {node.operation->bounds(a.value, b.value, c.value), false,
                  a.undecided | b.undecided | c.undecided};
    if (singleton(result.value))
      result.undecided = 0;
    else if (node.operation->is_step())
      // One switch of its own decides between two values, not between more.
      result.undecided |= 1ULL << (width(result.value) == 1. ? node.bit : last_bit);
    else if (is_choice && a.undecided == 0)
      result.undecided |= 1ULL << last_bit;
    return result;
  }

  const Formula &formula_;
  FormulaBox<dim> box_;
  std::vector<Box> parts_;
};

/** Visits an evaluation and, as long as @p visit returns true, those on both branches of the first
 * undecided switch with a line, and so on. @return whether all undecided switches have lines. */
template <int dim, typename Visitor>
bool visit_branches(const BoxRun<dim> &run, const Visitor &visit, const unsigned int depth = 6) {
  Index number = 0;
  std::optional<KinkLine<dim>> line;
  if (depth > 0)
    line = run.line_of_switch(number);
  if (!visit(run, line) || !line)
    return run.root().undecided == 0;
  const bool before = visit_branches(run.on_branch(number, false), visit, depth - 1);
  return visit_branches(run.on_branch(number, true), visit, depth - 1) && before;
}
} // namespace
} // namespace FormulaParts

using namespace FormulaParts;

template <int dim>
FormulaTree<dim>::FormulaTree(const std::string &text, const Constants &constants,
                              const Definitions &definitions) {
  const auto formula = std::make_shared<Formula>();
  const Reader reader(text, constants, definitions, dim, *formula);
  formula_ = formula;
}

template <int dim>
bool FormulaTree<dim>::is_constant() const {
  const Node &root = formula_->nodes[formula_->root];
  return root.is_fixed && root.operation == nullptr;
}

namespace {
/** Evaluates parts at many points, some of them at a time. @param visit takes the number of the
 * first point, how many they are, and a function that returns the values of a part there. */
template <int dim, typename Visitor>
void evaluate(const Formula &formula, const Point<dim> *const points, const std::size_t n,
              const std::vector<Index> &parts, const Visitor &visit) {
  // Points of a batch share the call of each operation. The values of all parts stay in the cache.
  const std::size_t width = std::min<std::size_t>(n, 64);
  boost::container::small_vector<double, 2048> run(formula.nodes.size() * width,
                                                   boost::container::default_init);
  const auto at = [&](const Index part) { return run.data() + part * width; };
  for (const Index i : parts)
    if (formula.nodes[i].operation == nullptr)
      std::fill_n(at(i), width, formula.nodes[i].value);
  for (std::size_t start = 0, size; start < n; start += size) {
    size = std::min(n - start, width);
    for (std::size_t q = 0; q < size; ++q)
      for (Index d = 0; d < dim; ++d)
        at(d)[q] = points[start + q][d];
    for (const Index i : parts)
      if (const auto &[operation, of, value, is_fixed, bit] = formula.nodes[i];
          operation != nullptr) {
        if (size == 1)
          *at(i) = operation->value(*at(of[0]), *at(of[1]), *at(of[2]));
        else
          operation->values(at(of[0]), at(of[1]), at(of[2]), size, at(i));
      }
    visit(start, size, at);
  }
}
} // namespace

template <int dim>
double FormulaTree<dim>::value(const Point<dim> &x) const {
  double value;
  values(&x, 1, &value);
  return value;
}

template <int dim>
void FormulaTree<dim>::values(const Point<dim> *const points, const std::size_t n,
                              double *const values) const {
  evaluate(*formula_, points, n, formula_->for_values,
           [&](const std::size_t start, const std::size_t size, const auto &at) {
             for (std::size_t c = 0; c < formula_->roots.size(); ++c)
               std::copy_n(at(formula_->roots[c]), size, values + c * n + start);
           });
}

template <int dim>
void FormulaTree<dim>::gradients(const Point<dim> *const points, const std::size_t n,
                                 Tensor<1, dim> *const gradients) const {
  evaluate(*formula_, points, n, formula_->for_gradients,
           [&](const std::size_t start, const std::size_t size, const auto &at) {
             for (std::size_t c = 0; c < formula_->roots.size(); ++c)
               for (int d = 0; d < dim; ++d) {
                 const double *const slope = at(formula_->slopes[formula_->roots[c]][d]);
                 for (std::size_t q = 0; q < size; ++q)
                   gradients[c * n + start + q][d] = slope[q];
               }
           });
}

template <int dim>
Enclosure<dim> FormulaTree<dim>::enclose(const FormulaBox<dim> &box) const {
  return BoxRun(*formula_, box).bounds();
}

template <int dim>
std::vector<KinkLine<dim>> FormulaTree<dim>::lines_in(const FormulaBox<dim> &box, bool &all) const {
  std::vector<KinkLine<dim>> lines;
  all = visit_branches(BoxRun(*formula_, box), [&](const BoxRun<dim> & /*run*/, const auto &line) {
    if (line && !is_among(lines, *line, box))
      lines.push_back(*line);
    return true;
  });
  return lines;
}

template <int dim>
bool FormulaTree<dim>::is_shown(const FormulaBox<dim> &box, const std::vector<KinkLine<dim>> &lines,
                                const double tolerance) const {
  bool is_shown = true;
  visit_branches(BoxRun(*formula_, box), [&](const BoxRun<dim> &run, const auto &line) {
    if (!is_shown || run.bounds().width() <= tolerance)
      return false;
    is_shown = run.root().undecided == 0 ? run.is_smooth() : line && is_among(lines, *line, box);
    return is_shown;
  });
  return is_shown;
}

template <int dim>
LineEffect FormulaTree<dim>::effect_of(const KinkLine<dim> &line, const FormulaBox<dim> &box,
                                       const std::vector<Point<dim>> &points,
                                       const double tolerance) const {
  Assert(points.size() > 1, ExcMessage("Points lie on both sides of the line."));
  const BoxRun<dim> run(*formula_, box);
  if (run.root().undecided == 0 || run.bounds().width() <= tolerance)
    return LineEffect::none;
  const auto first = run.beside(line, points.front()), second = run.beside(line, points.back());
  if (!first || !second)
    return LineEffect::unclear;
  for (const BoxRun<dim> *const side : {&*first, &*second})
    if (!(side->bounds().width() <= tolerance || side->is_smooth()))
      return LineEffect::unclear;
  bool agree = true;
  for (const Point<dim> &x : points)
    agree = agree && std::abs(second->value_at(x) - first->value_at(x)) <= tolerance;
  return agree ? LineEffect::none : LineEffect::some;
}

template class FormulaTree<1>;
template class FormulaTree<2>;
template class FormulaTree<3>;
} // namespace Signorini
