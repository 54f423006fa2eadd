// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/problem/geometry/geometry.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace Signorini {
/** Named numbers that expressions may use. */
using Constants = std::map<std::string, double>;

enum class Operation;

/** The box of all points between two corners. */
template <int dim>
struct FormulaBox {
  Point<dim> lower, upper;

  Point<dim> centre() const {
    return lower + 0.5 * (upper - lower);
  }
};

/** What a formula does in a box. */
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

/**
 * The tree of a formula in x, y (and z) that muParser accepts: its values, its derivatives, and
 * bounds of its values in a box.
 *
 * Bounds are natural interval evaluations of the tree, intersected with f(c) + f'(box)(box - c) at
 * the centre c (R. E. Moore, Interval Analysis, 1966; W. Tucker, Validated Numerics, 2011). They
 * are not rounded outwards: they are right up to rounding of the values. A condition, abs, min, max
 * or a step (sign, floor, ...) that a box does not decide is a *switch*: the bounds contain both
 * branches. Where its argument is affine in the coordinates, it changes on a line that is known.
 */
template <int dim>
class FormulaTree {
public:
  /** Parses a text. @throws std::invalid_argument if it is not one that muParser accepts. */
  FormulaTree(const std::string &text, const Constants &constants);

  /** Returns whether the formula uses none of the coordinates. */
  bool is_constant() const;

  double value(const Point<dim> &x) const;
  /** Computes n values; not finite where the formula is not defined. */
  void values(const Point<dim> *points, std::size_t n, double *values) const;
  /** Returns the exact derivatives; at a switch, those of one branch. */
  Tensor<1, dim> gradient(const Point<dim> &x) const;

  Enclosure<dim> enclose(const FormulaBox<dim> &box) const;

  /** Returns whether Gauss' rules of 4 points in each direction integrate the formula on either
   * side of the given @p lines: it varies by at most @p tolerance, or no other switch is undecided
   * in the box, no value hides between n_samples in each direction, and their fourth differences
   * are below a twentieth of their range. */
  bool is_shown(const FormulaBox<dim> &box, const std::vector<KinkLine<dim>> &lines,
                double tolerance) const;

  /** Returns the lines of all switches that a box does not decide and whose arguments are affine in
   * it. @param all whether every undecided switch has such a line. */
  std::vector<KinkLine<dim>> lines_in(const FormulaBox<dim> &box, bool &all) const;

private:
  /** A part of the formula: an operation on earlier parts. */
  struct Node {
    Operation operation;
    std::array<unsigned int, 3> arguments;
    /** A number, or the number of a coordinate or of a monotone function. */
    double value;
    /** The number of its switch. */
    unsigned int switch_number;
  };
  class Reader;
  template <typename Number>
  struct Run;

  /** Evaluates all parts of the tree. */
  template <typename Number>
  void evaluate(Run<Number> &run) const;
  /** Evaluates one part at n points. @param parts those of earlier parts. */
  static void evaluate_block(const Node &node, const Point<dim> *points, std::size_t n,
                             const double *parts, double *result);
  template <typename Number>
  Enclosure<dim> enclosure(const Run<Number> &run) const;
  /** Returns the line of a switch whose argument is affine. */
  template <typename Number>
  std::optional<KinkLine<dim>> line_of(unsigned int k, const Run<Number> &run) const;
  /** Visits an evaluation and, as long as it returns true, those on both branches of the first
   * undecided switch with a line. @return whether all switches have lines. */
  template <typename Number, typename Visitor>
  bool visit_branches(Run<Number> &run, const Visitor &visit) const;
  /** Returns whether samples on the branches of an evaluation show what it does in a box. */
  template <typename Number>
  bool is_smooth(const FormulaBox<dim> &box, const Run<Number> &of_box) const;

  /** The number of samples in each direction. */
  static constexpr unsigned int n_samples = 8;
  std::vector<Node> nodes_;
  unsigned int n_switches_ = 0;
};
} // namespace Signorini
