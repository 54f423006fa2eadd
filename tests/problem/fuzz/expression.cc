// SPDX-License-Identifier: LGPL-2.1-or-later
// Any text as a formula: it is refused by an InputError, or has the value that muParser gives it.

#include <signorini/base/errors.h>
#include <signorini/problem/formulas/expression.h>

#include <deal.II/base/numbers.h>

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <string>

#include "problem/formulas/formulas.h"

using namespace Signorini;

namespace {
/** Few digits: products are exact, so that no rounding is blown up to a difference. */
const std::vector<dealii::Point<2>> points = {{0.5, -1.25}, {0., 0.}, {2., 3.}, {-1., 1.}};
const Constants constants = {{"a", 2.}, {"E", 0.75}};

double evaluate_plainly(const std::string &text, const dealii::Point<2> &x) {
  double coordinates[2] = {x[0], x[1]};
  mu::Parser parser;
  parser.DefineConst("pi", dealii::numbers::PI);
  for (const auto &constant : constants)
    parser.DefineConst(constant.first, constant.second);
  define_functions(parser);
  parser.DefineVar("x", &coordinates[0]);
  parser.DefineVar("y", &coordinates[1]);
  parser.SetExpr(text);
  return parser.Eval();
}

bool agree(const double a, const double b) {
  return (std::isnan(a) && std::isnan(b)) || a == b ||
         std::abs(a - b) <= 1e-9 * std::max(std::abs(a), std::abs(b));
}
} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, const std::size_t size) {
  const std::string text(reinterpret_cast<const char *>(data), size);
  try {
    const Expression<2> expression(text, constants, "here");
    for (const dealii::Point<2> &x : points) {
      const double value = expression(x), plain = evaluate_plainly(expression.text(), x);
      if (!agree(value, plain)) {
        std::cerr << "'" << expression.text() << "' at (" << x << "): " << value
                  << ", muParser alone: " << plain << std::endl;
        std::abort();
      }
    }
  } catch (const InputError &) {
  }
  return 0;
}
