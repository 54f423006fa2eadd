// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/problem/scene/formula.h>

#include <cctype>
#include <cstdlib>
#include <stdexcept>
#include <string>

#include "formula_tree.h"

namespace Signorini {
/** A function of one argument that increases or decreases where it is defined. */
struct MonotoneFunction {
  const char *name;
  double (*f)(double);
  /** The ends of where it is defined. */
  std::array<double, 2> domain;
};

/** The monotone functions that formulas know. */
inline const std::array<MonotoneFunction, 16> monotone_functions = {
  {{"exp", std::exp, {{-HUGE_VAL, HUGE_VAL}}},
   {"log", std::log, {{0., HUGE_VAL}}},
   {"ln", std::log, {{0., HUGE_VAL}}},
   {"log2", std::log2, {{0., HUGE_VAL}}},
   {"log10", std::log10, {{0., HUGE_VAL}}},
   {"sqrt", std::sqrt, {{0., HUGE_VAL}}},
   {"asin", std::asin, {{-1., 1.}}},
   {"acos", std::acos, {{-1., 1.}}},
   {"atan", std::atan, {{-HUGE_VAL, HUGE_VAL}}},
   {"sinh", std::sinh, {{-HUGE_VAL, HUGE_VAL}}},
   {"tanh", std::tanh, {{-HUGE_VAL, HUGE_VAL}}},
   {"asinh", std::asinh, {{-HUGE_VAL, HUGE_VAL}}},
   {"acosh", std::acosh, {{1., HUGE_VAL}}},
   {"atanh", std::atanh, {{-1., 1.}}},
   {"erf", std::erf, {{-HUGE_VAL, HUGE_VAL}}},
   {"erfc", std::erfc, {{-HUGE_VAL, HUGE_VAL}}}}};

/** Reads a formula with the precedence of muParser: ?:, ||, &&, comparisons, + -, * /, signs, ^. */
template <int dim>
class FormulaTree<dim>::Reader {
public:
  Reader(const std::string &text, const Constants &constants, FormulaTree &formula)
    : text_(text)
    , constants_(constants)
    , formula_(formula) {
    read_choice();
    if (next() != '\0')
      fail();
  }

private:
  using Index = unsigned int;

  [[noreturn]] void fail() const {
    throw std::invalid_argument("unknown formula");
  }
  char next() {
    while (std::isspace(static_cast<unsigned char>(text_[at_])) != 0)
      ++at_;
    return text_[at_];
  }
  bool take(const std::string &token) {
    next();
    if (text_.compare(at_, token.size(), token) != 0)
      return false;
    at_ += token.size();
    return true;
  }

  Index add(const Operation operation, const Index a = 0, const Index b = 0, const Index c = 0,
            const double value = 0.) {
    const bool switches = operation == Operation::less || operation == Operation::less_or_equal ||
                          operation == Operation::maximum || operation == Operation::absolute ||
                          operation == Operation::sign || operation == Operation::floor;
    formula_.nodes_.push_back(
      {operation, {{a, b, c}}, value, switches ? formula_.n_switches_++ : 0});
    return formula_.nodes_.size() - 1;
  }
  Index constant(const double value) {
    return add(Operation::number, 0, 0, 0, value);
  }
  Index negative(const Index a) {
    return add(Operation::times, constant(-1.), a);
  }
  /** Returns a == 0, i.e. not a. */
  Index inverse(const Index a) {
    return add(Operation::equal, a, constant(0.));
  }

  Index read_choice() {
    const Index condition = read_either();
    if (!take("?"))
      return condition;
    const Index yes = read_choice();
    if (!take(":"))
      fail();
    const Index no = read_choice();
    return add(Operation::choice, condition, yes, no);
  }
  Index read_either() {
    Index a = read_both();
    while (take("||")) {
      const Index b = read_both();
      a = add(Operation::either, a, b);
    }
    return a;
  }
  Index read_both() {
    Index a = read_comparison();
    while (take("&&")) {
      const Index b = read_comparison();
      a = add(Operation::both, a, b);
    }
    return a;
  }
  Index read_comparison() {
    Index a = read_sum();
    while (true) {
      if (take("<="))
        a = add(Operation::less_or_equal, a, read_sum());
      else if (take(">=")) {
        const Index b = read_sum();
        a = add(Operation::less_or_equal, b, a);
      } else if (take("=="))
        a = add(Operation::equal, a, read_sum());
      else if (take("!="))
        a = inverse(add(Operation::equal, a, read_sum()));
      else if (take("<"))
        a = add(Operation::less, a, read_sum());
      else if (take(">")) {
        const Index b = read_sum();
        a = add(Operation::less, b, a);
      } else
        return a;
    }
  }
  Index read_sum() {
    Index a = read_product();
    while (next() == '+' || next() == '-') {
      const Operation operation = text_[at_++] == '+' ? Operation::plus : Operation::minus;
      const Index b = read_product();
      a = add(operation, a, b);
    }
    return a;
  }
  Index read_product() {
    Index a = read_signed();
    while (next() == '*' || next() == '/') {
      const Operation operation = text_[at_++] == '*' ? Operation::times : Operation::divided;
      const Index b = read_signed();
      a = add(operation, a, b);
    }
    return a;
  }
  Index read_signed() {
    if (take("-"))
      return negative(read_signed());
    return take("+") ? read_signed() : read_power();
  }
  Index read_power() {
    const Index a = read_operand();
    return take("^") ? add(Operation::power, a, read_signed()) : a;
  }

  Index read_operand() {
    if (take("(")) {
      const Index a = read_choice();
      if (!take(")"))
        fail();
      return a;
    }
    const char c = next();
    if (std::isdigit(static_cast<unsigned char>(c)) != 0 || c == '.')
      return constant(read_number());
    std::string name;
    while (std::isalnum(static_cast<unsigned char>(text_[at_])) != 0 || text_[at_] == '_')
      name += text_[at_++];
    return take("(") ? read_function(name) : read_name(name);
  }
  /** std::strtod would read hexadecimal numbers, too. */
  double read_number() {
    const std::size_t start = at_;
    const auto digits = [this] {
      while (std::isdigit(static_cast<unsigned char>(text_[at_])) != 0 || text_[at_] == '.')
        ++at_;
    };
    digits();
    if (text_[at_] == 'e' || text_[at_] == 'E') {
      ++at_;
      if (text_[at_] == '+' || text_[at_] == '-')
        ++at_;
      digits();
    }
    return std::strtod(text_.substr(start, at_ - start).c_str(), nullptr);
  }
  Index read_name(const std::string &name) {
    for (int d = 0; d < dim; ++d)
      if (name == std::string(1, "xyz"[d]))
        return add(Operation::coordinate, 0, 0, 0, d);
    if (name == "pi" || name == "_pi")
      return constant(std::acos(-1.));
    if (name == "_e")
      return constant(std::exp(1.));
    const auto found = constants_.find(name);
    if (found == constants_.end())
      fail();
    return constant(found->second);
  }

  Index read_function(const std::string &name) {
    std::vector<Index> arguments;
    do
      arguments.push_back(read_choice());
    while (take(","));
    if (!take(")"))
      fail();
    const Index a = arguments[0], n = arguments.size();
    for (std::size_t i = 0; i < monotone_functions.size() && n == 1; ++i)
      if (name == monotone_functions[i].name)
        return add(Operation::monotone, a, 0, 0, i);
    if (name == "if" && n == 3)
      return add(Operation::choice, a, arguments[1], arguments[2]);
    if (n == 2 && (name == "pow" || name == "atan2"))
      return name == "pow" ? add(Operation::power, a, arguments[1]) : add_angle(a, arguments[1]);
    return n == 1 ? read_function(name, a) : read_list(name, arguments);
  }
  Index read_function(const std::string &name, const Index a) {
    if (name == "sin")
      return add(Operation::sine, a);
    if (name == "cos")
      return add(Operation::cosine, a);
    if (name == "tan")
      return add(Operation::divided, add(Operation::sine, a), add(Operation::cosine, a));
    if (name == "cosh") {
      const Index up = add(Operation::monotone, a), down = add(Operation::monotone, negative(a));
      return add(Operation::times, constant(0.5), add(Operation::plus, up, down));
    }
    if (name == "abs")
      return add(Operation::absolute, a);
    if (name == "sign")
      return add(Operation::sign, a);
    if (name == "floor")
      return add(Operation::floor, a);
    if (name == "ceil")
      return negative(add(Operation::floor, negative(a)));
    if (name == "rint")
      return add(Operation::floor, add(Operation::plus, a, constant(0.5)));
    return read_list(name, {a});
  }
  Index read_list(const std::string &name, const std::vector<Index> &arguments) {
    Index result = arguments[0];
    if (name != "min" && name != "max" && name != "sum" && name != "avg")
      fail();
    if (name == "min")
      result = negative(result);
    for (std::size_t i = 1; i < arguments.size(); ++i)
      if (name == "min")
        result = add(Operation::maximum, result, negative(arguments[i]));
      else
        result = add(name == "max" ? Operation::maximum : Operation::plus, result, arguments[i]);
    if (name == "avg")
      return add(Operation::divided, result, constant(arguments.size()));
    return name == "min" ? negative(result) : result;
  }
  /** atan2(y, x) is atan(y/x), and pi more or less where x < 0. */
  Index add_angle(const Index y, const Index x) {
    const Index zero = constant(0.), pi = constant(std::acos(-1.));
    const Index atan = add(Operation::monotone, add(Operation::divided, y, x), 0, 0, 8);
    const Index shift = add(Operation::choice, add(Operation::less, y, zero), negative(pi), pi);
    const Index left = add(Operation::plus, atan, shift);
    const Index inside = add(Operation::choice, add(Operation::less, x, zero), left, atan);
    const Index above = add(Operation::times, constant(0.5), add(Operation::sign, y));
    return add(Operation::choice, add(Operation::equal, x, zero), add(Operation::times, above, pi),
               inside);
  }

  const std::string &text_;
  const Constants &constants_;
  FormulaTree &formula_;
  std::size_t at_ = 0;
};
} // namespace Signorini
