// SPDX-License-Identifier: LGPL-2.1-or-later
// What muParser is taught.

#include "formulas.h"

#include <cctype>
#include <cmath>

namespace Signorini
{
namespace
{
double choose(const double condition, const double then_value, const double else_value)
{
  return condition != 0. ? then_value : else_value;
}

double square(const double x)
{
  return x * x;
}

double cube(const double x)
{
  return x * x * x;
}
} // namespace

void define_functions(mu::Parser &parser)
{
  parser.DefineFun("floor", static_cast<double (*)(double)>(std::floor));
  parser.DefineFun("ceil", static_cast<double (*)(double)>(std::ceil));
  parser.DefineFun("pow", static_cast<double (*)(double, double)>(std::pow));
  parser.DefineFun("erf", static_cast<double (*)(double)>(std::erf));
  parser.DefineFun("erfc", static_cast<double (*)(double)>(std::erfc));
  parser.DefineFun("if", choose);
}

std::string rewrite_powers(const std::string &text)
{
  const auto next = [&](std::size_t i) {
    while (i < text.size() && std::isspace(static_cast<unsigned char>(text[i])) != 0)
      ++i;
    return i;
  };
  std::string rewritten;
  for (std::size_t i = 0; i < text.size(); ++i)
  {
    rewritten += text[i];
    const std::size_t caret = next(i + 1);
    if (text[i] != ')' || caret >= text.size() || text[caret] != '^')
      continue;
    const std::size_t digit = next(caret + 1), end = digit + 1;
    if (digit >= text.size() || (text[digit] != '2' && text[digit] != '3'))
      continue;
    // Not the beginning of a longer number, nor of a tower a^2^b = a^(2^b).
    const std::size_t follower = next(end);
    const bool is_number =
      end < text.size() &&
      (std::isalnum(static_cast<unsigned char>(text[end])) != 0 || text[end] == '.');
    if (is_number || (follower < text.size() && text[follower] == '^'))
      continue;
    rewritten += text[digit] == '2' ? square_operator : cube_operator;
    i = digit;
  }
  return rewritten;
}

void define_powers(mu::Parser &parser)
{
  parser.DefinePostfixOprt(square_operator, square);
  parser.DefinePostfixOprt(cube_operator, cube);
}
} // namespace Signorini
