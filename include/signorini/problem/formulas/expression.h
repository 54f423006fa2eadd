// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/base/errors.h>
#include <signorini/base/text.h>
#include <signorini/problem/formulas/formula.h>

#include <deal.II/base/point.h>

#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

namespace Signorini {
/**
 * A formula in x, y (and z).
 *
 * It may contain the operators and functions of muParser (+ - * / ^ < > <= >= == != && || ?:, sin,
 * cos, tan, exp, log, sqrt, abs, min, max, ...), besides them floor, ceil, pow, erf, erfc and
 * if(c,a,b), the constant pi and the named constants. Evaluation is thread-safe.
 */
template <int dim>
class Expression {
public:
  /** Parses the text. @throws InputError beginning with @p where if the text cannot be parsed. */
  Expression(const std::string &text, const Constants &constants, const std::string &where);

  /** Returns the value at a point; it is not finite where the formula is not defined. */
  double operator()(const Point<dim> &x) const;

  /** Computes the values at many points; @p values has as many entries as @p points. */
  void evaluate(const std::vector<Point<dim>> &points, std::vector<double> &values) const;

  /** Returns whether the formula uses none of the coordinates. */
  bool is_constant() const {
    return constant_.has_value();
  }

  const std::string &text() const {
    return text_;
  }
  /** Returns the origin that the formula was read from, for messages about its values. */
  const std::string &where() const {
    return where_;
  }

  /** Returns the tree of the formula. */
  const FormulaTree<dim> &formula() const {
    return *formula_;
  }

private:
  std::string text_, where_;
  std::shared_ptr<const FormulaTree<dim>> formula_;
  /** The value of a formula without coordinates. */
  std::optional<double> constant_;
};

/** Throws InputError with "WHERE: found FOUND at (X), allowed: ALLOWED." */
template <int dim>
[[noreturn]] void refuse_value(const std::string &where, const std::string &found,
                               const Point<dim> &x, const std::string &allowed) {
  std::ostringstream message;
  message << where << ": found " << found << " at (" << x << "), allowed: " << allowed << ".";
  throw InputError(message.str());
}

/**
 * Reads "E=1, nu=0.3": each value is an expression of the constants before it.
 * @throws InputError beginning with @p where.
 */
Constants read_constants(const std::string &text, const std::string &where);
} // namespace Signorini
