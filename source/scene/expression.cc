// SPDX-License-Identifier: LGPL-2.1-or-later
// Formulas of the parameter file, on top of muParser.

#include <signorini/parameters/exceptions.h>
#include <signorini/parameters/lists.h>
#include <signorini/scene/expression.h>

#include <deal.II/base/numbers.h>

#include <muParser.h>

#include <array>
#include <cctype>
#include <cmath>

namespace Signorini
{
namespace
{
constexpr std::array<const char *, 3> coordinate_names = {{"x", "y", "z"}};

double choose(const double condition, const double then_value, const double else_value)
{
  return condition != 0. ? then_value : else_value;
}

/**
 * muParser takes `1, 2` for 2 and `x = 3` for an assignment; neither can be meant.
 * @return what is wrong, or nothing.
 */
std::string find_misuse(const std::string &text)
{
  int depth = 0;
  for (std::size_t i = 0; i < text.size(); ++i)
  {
    const char before = i > 0 ? text[i - 1] : ' ';
    const char after = i + 1 < text.size() ? text[i + 1] : ' ';
    depth += text[i] == '(' ? 1 : (text[i] == ')' ? -1 : 0);
    if (text[i] == ',' && depth == 0)
      return "a comma stands outside of a function's parentheses";
    if (text[i] == '=' && after != '=' && std::string("=<>!").find(before) == std::string::npos)
      return "'=' assigns; comparisons are written '=='";
    if (text[i] == '"')
      return "a quotation mark has no meaning here";
  }
  return trim(text).empty() ? "it is empty" : "";
}

/** The functions that muParser lacks. */
void define_functions(mu::Parser &parser)
{
  parser.DefineFun("floor", static_cast<double (*)(double)>(std::floor));
  parser.DefineFun("ceil", static_cast<double (*)(double)>(std::ceil));
  parser.DefineFun("pow", static_cast<double (*)(double, double)>(std::pow));
  parser.DefineFun("erf", static_cast<double (*)(double)>(std::erf));
  parser.DefineFun("erfc", static_cast<double (*)(double)>(std::erfc));
  parser.DefineFun("if", choose);
}

/** Whether a constant cannot have this name because formulas know it already. */
bool is_taken(const std::string &name)
{
  mu::Parser parser;
  define_functions(parser);
  return name == "x" || name == "y" || name == "z" || name == "pi" ||
         parser.GetFunDef().count(name) > 0;
}

bool is_name(const std::string &text)
{
  if (text.empty() || (std::isalpha(static_cast<unsigned char>(text[0])) == 0 && text[0] != '_'))
    return false;
  for (const char c : text)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '_')
      return false;
  return true;
}
} // namespace

/** One muParser bound to its own coordinates. */
template <int dim>
class Expression<dim>::Parser
{
public:
  Parser(const std::string &text, const Constants &constants)
  {
    parser_.DefineConst("pi", dealii::numbers::PI);
    for (const auto &constant : constants)
      parser_.DefineConst(constant.first, constant.second);
    define_functions(parser_);
    for (unsigned int d = 0; d < dim; ++d)
      parser_.DefineVar(coordinate_names[d], &coordinates_[d]);
    parser_.SetExpr(text);
    uses_coordinates_ = !parser_.GetUsedVar().empty();
    parser_.Eval();
  }

  double evaluate(const dealii::Point<dim> &x)
  {
    for (unsigned int d = 0; d < dim; ++d)
      coordinates_[d] = x[d];
    return parser_.Eval();
  }

  bool uses_coordinates() const
  {
    return uses_coordinates_;
  }

private:
  std::array<double, dim> coordinates_ = {};
  mu::Parser parser_;
  bool uses_coordinates_ = false;
};

template <int dim>
Expression<dim>::Expression(const std::string &text,
                            const Constants &constants,
                            const std::string &where)
  : text_(trim(text))
  , constants_(constants)
  , where_(where)
{
  const std::string misuse = find_misuse(text_);
  if (!misuse.empty())
    throw InputError(where_ + ": the expression '" + text_ + "' cannot be used: " + misuse + ".");
  try
  {
    parser_ = std::make_unique<Parser>(text_, constants_);
  }
  catch (const mu::ParserError &error)
  {
    std::string reason = error.GetMsg();
    while (!reason.empty() && reason.back() == '.')
      reason.pop_back();
    throw InputError(where_ + ": the expression '" + text_ + "' cannot be parsed: " + reason +
                     "; allowed: a formula in x, y, the constants and pi.");
  }
}

template <int dim>
Expression<dim>::Expression(const Expression &other)
  : text_(other.text_)
  , constants_(other.constants_)
  , where_(other.where_)
  , parser_(std::make_unique<Parser>(other.text_, other.constants_))
{
}

template <int dim>
Expression<dim>::Expression(Expression &&other) noexcept = default;

template <int dim>
Expression<dim>::~Expression() = default;

template <int dim>
double Expression<dim>::operator()(const dealii::Point<dim> &x) const
{
  return parser_->evaluate(x);
}

template <int dim>
bool Expression<dim>::is_constant() const
{
  return !parser_->uses_coordinates();
}

Constants read_constants(const std::string &text, const std::string &where)
{
  Constants constants;
  for (const std::string &part : split_list(text, ','))
  {
    const auto equals = part.find('=');
    const std::string name = trim(part.substr(0, equals));
    if (equals == std::string::npos || !is_name(name))
      throw InputError(where + ": found '" + part +
                       "', allowed: name=number, separated by commas.");
    if (is_taken(name) || constants.count(name) > 0)
      throw InputError(where + ": the name '" + name +
                       "' is taken; x, y, z, pi and the functions are known, and a constant is set "
                       "once.");
    const Expression<1> value(part.substr(equals + 1), constants, where);
    const double number = value(dealii::Point<1>(0.));
    if (!value.is_constant() || !std::isfinite(number))
      throw InputError(where + ": the value of '" + name + "' must be a finite number, found '" +
                       value.text() + "'.");
    constants[name] = number;
  }
  return constants;
}

template class Expression<1>;
template class Expression<2>;
} // namespace Signorini
