// SPDX-License-Identifier: LGPL-2.1-or-later
// Any text as a formula: it has the value that muParser gives it, or both refuse it; but for the
// texts that muParser accepts and nobody means.

#include <signorini/base/errors.h>
#include <signorini/problem/formulas/expression.h>

#include <deal.II/base/numbers.h>

#include <muParser.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <string>

using namespace Signorini;

namespace {
/** Few digits: products are exact, so that no rounding is blown up to a difference. */
const std::vector<dealii::Point<2>> points = {{0.5, -1.25}, {0., 0.}, {2., 3.}, {-1., 1.}};
const Constants constants = {{"a", 2.}, {"E", 0.75}};

/** Defines the functions that muParser lacks. */
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

/** @throws mu::ParserError */
double evaluate_plainly(const std::string &text, const dealii::Point<2> &x) {
  double coordinates[2] = {x[0], x[1]};
  mu::Parser parser;
  parser.DefineConst("pi", dealii::numbers::PI);
  for (const auto &constant : constants)
    parser.DefineConst(constant.first, constant.second);
  define_functions(parser);
  parser.DefineVar("x", &coordinates[0]);
  parser.DefineVar("y", &coordinates[1]);
  // It takes 0.5 && 2 for 0 && 2 where it computes with numbers in advance.
  parser.EnableOptimizer(false);
  parser.SetExpr(text);
  return parser.Eval();
}

bool agree(const double a, const double b) {
  return (std::isnan(a) && std::isnan(b)) || a == b ||
         std::abs(a - b) <= 1e-9 * std::max(std::abs(a), std::abs(b));
}

[[noreturn]] void stop(const std::string &text, const std::string &difference) {
  std::cerr << "'" << text << "': " << difference << std::endl;
  std::abort();
}

/** Stops unless muParser refuses a text, too, or nobody means what it accepts. */
void check_refusal(const std::string &text, const std::string &message) {
  for (const char *const known : {"a comma stands between", "'=' assigns", "it compares the answer",
                                  "more than 500 parentheses"})
    if (message.find(known) != std::string::npos)
      return;
  try {
    evaluate_plainly(text, points[0]);
  } catch (const mu::ParserError &) {
    return;
  }
  stop(text, "muParser accepts it; " + message);
}
} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, const std::size_t size) {
  const std::string text(reinterpret_cast<const char *>(data), size);
  // muParser takes these for blanks or for the end.
  if (std::any_of(text.begin(), text.end(), [](const char c) { return c >= 0 && c < '\t'; }))
    return 0;
  try {
    const Expression<2> expression(text, constants, "here");
    for (const dealii::Point<2> &x : points)
      try {
        const double value = expression(x), plain = evaluate_plainly(expression.text(), x);
        if (!agree(value, plain))
          stop(text, std::to_string(value) + ", muParser: " + std::to_string(plain));
      } catch (const mu::ParserError &error) {
        stop(text, "muParser refuses it: " + error.GetMsg());
      }
  } catch (const InputError &error) {
    check_refusal(text, error.what());
  }
  return 0;
}
