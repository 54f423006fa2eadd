// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/problem/geometry/box_tree.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <array>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace Signorini {
/** Named numbers that expressions may use. */
using Constants = std::map<std::string, double>;

/** Formulas with a name, in any order. As a name f is the formula, as a function f(p, q, r) the
 * formula with p, q, r instead of a, b, c. */
using Definitions = std::map<std::string, std::string>;

namespace FormulaParts {
struct Formula;
}

/** The box of all points between two corners. */
template <int dim>
struct FormulaBox {
  Point<dim> lower, upper;

  Point<dim> centre() const {
    return lower + 0.5 * (upper - lower);
  }
};

/** Bounds of a formula in a box. */
template <int dim>
struct Enclosure {
  /** Bounds of the values at all points of the box but those of a set without area. */
  double lower, upper;
  /** The coordinates that the values may depend on. */
  std::array<bool, dim> varies;

  double width() const {
    return upper - lower;
  }
};

/** Whether a formula changes on a line, as far as bounds can tell. */
enum class LineEffect { none, some, unclear };

/**
 * The tree of a formula in x, y (and z): its values, its derivatives, and bounds of its values in a
 * box.
 *
 * Bounds are natural interval evaluations of the tree, intersected with f(c) + f'(box)(box - c) at
 * the centre c (R. E. Moore, Interval Analysis, 1966; W. Tucker, Validated Numerics, 2011). They
 * are not rounded outwards: they are right up to rounding of the values. A condition, abs, min, max
 * or a step (sign, floor, ...) that a box does not decide is a *switch*: the bounds contain both
 * branches. Where its argument is affine in the coordinates, or depends on one of them and is
 * monotone, it changes on a line that is known.
 */
template <int dim>
class FormulaTree {
public:
  /** Parses a formula; or, with definitions, formulas separated by ';' that may also name these,
   * and derivatives dx(f), dy(f), dz(f). @throws std::invalid_argument with the reason if it cannot
   * be read. */
  FormulaTree(const std::string &text, const Constants &constants,
              const Definitions &definitions = {});

  /** Returns whether the formula uses none of the coordinates. */
  bool is_constant() const;

  double value(const Point<dim> &x) const;
  /** Computes n values of each formula; not finite where it is not defined. */
  void values(const Point<dim> *points, std::size_t n, double *values) const;
  /** Computes the exact derivatives of each formula at n points; at a switch, those of one branch.
   */
  void gradients(const Point<dim> *points, std::size_t n, Tensor<1, dim> *gradients) const;
  Tensor<1, dim> gradient(const Point<dim> &x) const {
    Tensor<1, dim> gradient;
    gradients(&x, 1, &gradient);
    return gradient;
  }

  Enclosure<dim> enclose(const FormulaBox<dim> &box) const;

  /** Returns whether few points show the formula in a box: it varies by at most
   * @p tolerance, or no switch but those of the given @p lines is undecided, and on all sides of
   * these lines 8 samples in each direction are close enough for its largest slope and have small
   * fourth differences. Where these are smaller still, the slopes in parts of the box count. */
  bool is_shown(const FormulaBox<dim> &box, const std::vector<KinkLine<dim>> &lines,
                double tolerance) const;

  /** Returns the lines of the switches that a box does not decide, also of those inside of others.
   * There are lines where the argument is affine in the box, or depends on one coordinate and is
   * monotone. @param all whether every undecided switch has a line. */
  std::vector<KinkLine<dim>> lines_in(const FormulaBox<dim> &box, bool &all) const;

  /** Returns whether the formula changes on a line: whether the branches on its two sides, followed
   * through the box, differ by more than @p tolerance. It is unclear where the box does not decide
   * other switches, or samples do not show a branch.
   * @param points of the box; the first one lies on one side of the line, the last one on the
   * other.
   */
  LineEffect effect_of(const KinkLine<dim> &line, const FormulaBox<dim> &box,
                       const std::vector<Point<dim>> &points, double tolerance) const;

private:
  std::shared_ptr<const FormulaParts::Formula> formula_;
};
} // namespace Signorini
