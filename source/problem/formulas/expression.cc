// SPDX-License-Identifier: LGPL-2.1-or-later
// Formulas and constants of the parameter file.

#include <signorini/base/errors.h>
#include <signorini/base/message.h>
#include <signorini/base/text.h>
#include <signorini/problem/formulas/expression.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <stdexcept>
#include <string>

#include "formula_tree.h"

namespace Signorini {
namespace {
/** The largest number of constants. */
constexpr std::size_t max_constants = 1000;

/** Returns whether formulas use this name already, so that a constant cannot have it. */
bool is_taken(const std::string &name) {
  return name == "x" || name == "y" || name == "z" || FormulaParts::is_known_function(name) ||
         FormulaParts::known_constants().count(name) > 0;
}

bool is_name(const std::string &text) {
  return !text.empty() && std::isdigit(static_cast<unsigned char>(text[0])) == 0 &&
         std::all_of(text.begin(), text.end(),
                     [](const unsigned char c) { return std::isalnum(c) != 0 || c == '_'; });
}
} // namespace

template <int dim>
Expression<dim>::Expression(const std::string &text, const Constants &constants,
                            const std::string &where)
  : text_(trim(text))
  , where_(where) {
  try {
    formula_ = std::make_shared<const FormulaTree<dim>>(text_, constants);
  } catch (const std::invalid_argument &reason) {
    throw input_error(where_, ": the expression ", quote(text_), " cannot be read: ", reason.what(),
                      "; allowed: a formula in x, y, the constants and pi.");
  }
  if (formula_->is_constant())
    constant_ = formula_->value(Point<dim>());
}

template <int dim>
double Expression<dim>::operator()(const Point<dim> &x) const {
  return constant_ ? *constant_ : formula_->value(x);
}

template <int dim>
void Expression<dim>::evaluate(const std::vector<Point<dim>> &points,
                               std::vector<double> &values) const {
  AssertDimension(values.size(), points.size());
  if (constant_)
    values.assign(points.size(), *constant_);
  else
    formula_->values(points.data(), points.size(), values.data());
}

Constants read_constants(const std::string &text, const std::string &where) {
  Constants constants;
  const std::vector<std::string> parts = split_list(text, ',');
  if (parts.size() > max_constants)
    throw input_error(where, ": found ", parts.size(), " constants, allowed: at most ",
                      max_constants, ".");
  for (const std::string &part : parts) {
    const auto equals = part.find('=');
    const std::string name = trim(part.substr(0, equals));
    if (equals == std::string::npos || !is_name(name) || part.find(';') != std::string::npos)
      throw input_error(where, ": found ", quote(part),
                        ", allowed: name=number, separated by commas.");
    if (is_taken(name) || constants.count(name) > 0)
      throw input_error(where, ": the name ", quote(name),
                        " is taken; x, y, z, pi and the functions are known, and a constant is set "
                        "once.");
    const Expression<1> value(part.substr(equals + 1), constants, where);
    const double number = value(Point<1>(0.));
    if (!value.is_constant() || !std::isfinite(number))
      throw input_error(where, ": the value of ", quote(name), " must be a finite number, found ",
                        quote(value.text()), ".");
    constants[name] = number;
  }
  return constants;
}

template class Expression<1>;
template class Expression<2>;
template class Expression<3>;
} // namespace Signorini
