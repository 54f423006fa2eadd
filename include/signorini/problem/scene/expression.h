// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/base/errors.h>
#include <signorini/base/text.h>

#include <deal.II/base/point.h>
#include <deal.II/base/thread_local_storage.h>

#include <map>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

namespace Signorini {
/** Named numbers that expressions may use. */
using Constants = std::map<std::string, double>;

/**
 * A formula in x, y (and z), parsed once by muParser.
 *
 * It may contain the operators and functions of muParser (+ - * / ^ < > <= >= == != && || ?:, sin,
 * cos, tan, exp, log, sqrt, abs, min, max, ...), besides them floor, ceil, pow, erf, erfc and
 * if(c,a,b), the constant pi and the named constants. Evaluation is thread-safe: every thread gets
 * a parser of its own.
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
  /** Returns the place that the formula was read from, for messages about its values. */
  const std::string &where() const {
    return where_;
  }

private:
  class Parser;

  /** Returns the parser of this thread, which is made when the thread first evaluates the formula.
   */
  Parser &thread_parser() const;

  std::string text_;
  Constants constants_;
  std::string where_;
  /** The value of a formula without coordinates. */
  std::optional<double> constant_;
  std::shared_ptr<Threads::ThreadLocalStorage<std::shared_ptr<Parser>>> parsers_;
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
