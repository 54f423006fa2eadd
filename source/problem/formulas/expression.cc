// SPDX-License-Identifier: LGPL-2.1-or-later
// Formulas of the parameter file: muParser says whether a text is one, its tree evaluates it.
// (FunctionParser accepts texts that nobody means: 1, 2 and x = 3 and 0.2<x<0.4.)

#include <signorini/base/errors.h>
#include <signorini/base/message.h>
#include <signorini/base/text.h>
#include <signorini/problem/formulas/expression.h>

#include <deal.II/base/numbers.h>

#include <boost/algorithm/string/case_conv.hpp>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <map>
#include <regex>
#include <stdexcept>
#include <string>

#include "formulas.h"

namespace Signorini {
namespace {
constexpr std::array<const char *, 3> coordinate_names = {{"x", "y", "z"}};

/** The largest number of constants. Every formula stores all of them, so that time grows like their
 * square: 0.2 s for this many. */
constexpr std::size_t max_constants = 1000;

/**
 * Finds a construction that muParser accepts and nobody means: `1, 2` is 2, `x = 3` an assignment,
 * and 0.2<x<0.4 is (0.2<x)<0.4.
 * @return the objection, or nothing.
 */
std::string find_misuse(const std::string &text) {
  // The number of comparisons since the last operator that ends one, by depth of parentheses.
  std::vector<unsigned int> comparisons = {0};
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i], next = i + 1 < text.size() ? text[i + 1] : ' ';
    if (c == ',' && comparisons.size() == 1)
      return "a comma stands outside of a function's parentheses";
    if (c == '"')
      return "a quotation mark has no meaning here";
    if (c == '=' && next != '=')
      return "'=' assigns; comparisons are written '=='";
    if (c == '(')
      comparisons.push_back(0);
    else if (c == ')' && comparisons.size() > 1)
      comparisons.pop_back();
    else if (std::string(",&|?:").find(c) != std::string::npos)
      comparisons.back() = 0;
    const bool compares = c == '<' || c == '>' || (next == '=' && (c == '=' || c == '!'));
    if (compares && ++comparisons.back() > 1)
      return "it compares the answer of a comparison; a<x<b is written (a<x) && (x<b)";
    i += compares && next == '=' ? 1 : 0;
  }
  return trim(text).empty() ? "it is empty" : "";
}

/** Returns how an operator of other languages is written; empty if the formula has none. */
std::string translation_for(const std::string &text, const Constants &constants) {
  static const std::map<std::string, std::string> operators = {
    {"or", "||"}, {"and", "&&"}, {"not", "== 0"}, {"**", "^"}};
  static const std::regex any("\\b(or|and|not)\\b|\\*\\*", std::regex::icase);
  std::smatch found;
  if (!std::regex_search(text, found, any) || constants.count(found.str()) > 0)
    return "";
  return quote(found.str()) + " is written '" +
         operators.at(boost::algorithm::to_lower_copy(found.str())) + "'";
}

/** Returns muParser's message without its full stop, with at most a part of a long token. */
std::string reason_of(const mu::ParserError &error) {
  std::string reason = error.GetMsg();
  const std::string &token = error.GetToken();
  const auto found = token.empty() ? std::string::npos : reason.find('"' + token + '"');
  if (found != std::string::npos)
    reason.replace(found + 1, token.size(), shorten(trim(token)));
  while (!reason.empty() && reason.back() == '.')
    reason.pop_back();
  return reason;
}

/** Returns whether formulas use this name already, so that a constant cannot have it. */
bool is_taken(const std::string &name) {
  mu::Parser parser;
  define_functions(parser);
  return name == "x" || name == "y" || name == "z" || name == "pi" ||
         parser.GetFunDef().count(name) > 0 || parser.GetConst().count(name) > 0;
}

bool is_name(const std::string &text) {
  return !text.empty() && std::isdigit(static_cast<unsigned char>(text[0])) == 0 &&
         std::all_of(text.begin(), text.end(),
                     [](const unsigned char c) { return std::isalnum(c) != 0 || c == '_'; });
}

/** Lets muParser read a formula. @throws mu::ParserError */
template <int dim>
void check_syntax(const std::string &text, const Constants &constants) {
  std::array<double, dim> x = {};
  mu::Parser parser;
  parser.DefineConst("pi", numbers::PI);
  for (const auto &[name, value] : constants)
    parser.DefineConst(name, value);
  define_functions(parser);
  for (unsigned int d = 0; d < dim; ++d)
    parser.DefineVar(coordinate_names[d], &x[d]);
  parser.SetExpr(text);
  // Names the variable that stands where none may be; Eval() would call it a token.
  parser.GetUsedVar();
  parser.Eval();
}
} // namespace

void define_functions(mu::Parser &parser) {
  parser.DefineFun("floor", static_cast<double (*)(double)>(std::floor));
  parser.DefineFun("ceil", static_cast<double (*)(double)>(std::ceil));
  parser.DefineFun("pow", static_cast<double (*)(double, double)>(std::pow));
  parser.DefineFun("erf", static_cast<double (*)(double)>(std::erf));
  parser.DefineFun("erfc", static_cast<double (*)(double)>(std::erfc));
  parser.DefineFun(
    "if", +[](const double condition, const double yes, const double no) {
      return condition != 0. ? yes : no;
    });
}

template <int dim>
Expression<dim>::Expression(const std::string &text, const Constants &constants,
                            const std::string &where)
  : text_(trim(text))
  , where_(where) {
  const std::string misuse = find_misuse(text_), translation = translation_for(text_, constants);
  if (!misuse.empty())
    throw input_error(where_, ": the expression ", quote(text_),
                      " cannot be used: ", translation.empty() ? misuse : translation,
                      "; allowed: a formula in x, y, the constants and pi.");
  try {
    check_syntax<dim>(text_, constants);
    formula_ = std::make_shared<const FormulaTree<dim>>(text_, constants);
  } catch (const mu::ParserError &error) {
    throw input_error(where_, ": the expression ", quote(text_),
                      " cannot be parsed: ", translation.empty() ? reason_of(error) : translation,
                      "; allowed: a formula in x, y, the constants and pi.");
  } catch (const std::invalid_argument &) {
    throw input_error(where_, ": the expression ", quote(text_), " cannot be read",
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
