// SPDX-License-Identifier: LGPL-2.1-or-later
// Formulas of the parameter file, on top of muParser. (FunctionParser takes up to twice the time,
// and accepts what nobody means: 1, 2 and x = 3 and 0.2<x<0.4.)

#include <signorini/base/errors.h>
#include <signorini/base/message.h>
#include <signorini/base/text.h>
#include <signorini/problem/scene/expression.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <regex>
#include <string>

#include "formulas.h"

namespace Signorini {
namespace {
constexpr std::array<const char *, 3> coordinate_names = {{"x", "y", "z"}};

/** The largest number of constants. Every formula stores all of them, so that time grows like their
 * square: 0.2 s for this many. */
constexpr std::size_t max_constants = 1000;

/**
 * Finds what muParser accepts and nobody means: `1, 2` is 2, `x = 3` an assignment, and 0.2<x<0.4
 * is (0.2<x)<0.4.
 * @return what is wrong, or nothing.
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

/** The operators that rewrite_powers() puts in. */
constexpr const char *square_operator = "'", *cube_operator = "~";

/**
 * Returns the formula with own operators behind the bracket in place of (...)^2 and (...)^3:
 * muParser multiplies out the powers of a plain coordinate only and calls the library's pow for all
 * else, which costs more than the rest of a typical formula. The formula must be one that muParser
 * accepts. A digit that begins a longer number, or a tower a^2^b = a^(2^b), stays.
 */
std::string rewrite_powers(const std::string &text) {
  static const std::regex squares(R"(\)\s*\^\s*2(?![\w.]|\s*\^))"),
    cubes(R"(\)\s*\^\s*3(?![\w.]|\s*\^))");
  const std::string once = std::regex_replace(text, squares, std::string(")") + square_operator);
  return std::regex_replace(once, cubes, std::string(")") + cube_operator);
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

/** One muParser bound to its own coordinates. */
template <int dim>
class Expression<dim>::Parser {
public:
  /** @param text a formula as the user wrote it, or as rewrite_powers() returns it. */
  Parser(const std::string &text, const Constants &constants, const bool rewritten) {
    parser_.DefineConst("pi", numbers::PI);
    for (const auto &constant : constants)
      parser_.DefineConst(constant.first, constant.second);
    define_functions(parser_);
    if (rewritten) {
      parser_.DefinePostfixOprt(
        square_operator, +[](const double x) { return x * x; });
      parser_.DefinePostfixOprt(
        cube_operator, +[](const double x) { return x * x * x; });
    }
    for (unsigned int d = 0; d < dim; ++d)
      parser_.DefineVar(coordinate_names[d], &coordinates_[d]);
    parser_.SetExpr(text);
    uses_coordinates = !parser_.GetUsedVar().empty();
    parser_.Eval();
  }
  Parser(const Parser &) = delete;
  Parser &operator=(const Parser &) = delete;

  double evaluate(const Point<dim> &x) {
    std::copy(x.begin_raw(), x.end_raw(), coordinates_.begin());
    return parser_.Eval();
  }

  bool uses_coordinates = false;

private:
  std::array<double, dim> coordinates_ = {};
  mu::Parser parser_;
};

template <int dim>
Expression<dim>::Expression(const std::string &text, const Constants &constants,
                            const std::string &where)
  : text_(trim(text))
  , constants_(constants)
  , where_(where) {
  const std::string misuse = find_misuse(text_);
  if (!misuse.empty())
    throw input_error(where_, ": the expression ", quote(text_), " cannot be used: ", misuse,
                      "; allowed: a formula in x, y, the constants and pi.");
  try {
    Parser parser(text_, constants_, false);
    if (parser.uses_coordinates)
      parsers_ = std::make_shared<Threads::ThreadLocalStorage<std::shared_ptr<Parser>>>();
    else
      constant_ = parser.evaluate(Point<dim>());
  } catch (const mu::ParserError &error) {
    throw input_error(where_, ": the expression ", quote(text_),
                      " cannot be parsed: ", reason_of(error),
                      "; allowed: a formula in x, y, the constants and pi.");
  }
}

template <int dim>
typename Expression<dim>::Parser &Expression<dim>::thread_parser() const {
  std::shared_ptr<Parser> &parser = parsers_->get();
  if (parser == nullptr)
    parser = std::make_shared<Parser>(rewrite_powers(text_), constants_, true);
  return *parser;
}

template <int dim>
double Expression<dim>::operator()(const Point<dim> &x) const {
  return constant_ ? *constant_ : thread_parser().evaluate(x);
}

// muParser's own bulk mode starts OpenMP threads for every call; a cell has too few points for
// that.
template <int dim>
void Expression<dim>::evaluate(const std::vector<Point<dim>> &points,
                               std::vector<double> &values) const {
  if (constant_)
    values.assign(points.size(), *constant_);
  else
    std::transform(points.begin(), points.end(), values.begin(),
                   [&parser = thread_parser()](const Point<dim> &x) { return parser.evaluate(x); });
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
    if (equals == std::string::npos || !is_name(name))
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
