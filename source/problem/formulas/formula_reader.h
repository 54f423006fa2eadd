// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/text.h>

#include <boost/algorithm/string/case_conv.hpp>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <map>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>

#include "formula_tree.h"

namespace Signorini {
namespace FormulaParts {
/**
 * Reads formulas. The grammar, where the operators of a level are those of operations():
 *
 *     choice   = level 1 [ '?' choice ':' choice ]
 *     level i  = level i+1 { operator of level i, level i+1 }, of levels 1 to 5
 *     level 6  = [ '+' or '-' ] operand [ '^' level 6 ]
 *     operand  = number, name, '(' choice ')', or function'(' choice { ',' choice } ')'
 *
 * At most one comparison stands in a level. The language, its functions and constants are those of
 * muParser, less the texts that it accepts and nobody means: `1, 2`, `x = 3` and `0.2<x<0.4`.
 */
class Reader {
public:
  /** Reads a formula; with definitions, formulas separated by ';'. @throws std::invalid_argument
   * with the reason if it is none. */
  Reader(const std::string &text, const Constants &constants, const Definitions &definitions,
         const unsigned int dim, Formula &formula)
    : constants_(constants)
    , definitions_(definitions)
    , formula_(formula)
    , nodes_(formula.nodes) {
    if (trim(text).empty())
      throw std::invalid_argument("it is empty");
    if (text.size() > 19999)
      throw std::invalid_argument("it has more than 19999 characters");
    number(0.);
    for (Index d = 0; d < dim; ++d)
      known_names_[std::string(1, "xyz"[d])] = d;
    for (const std::string &part :
         definitions.empty() ? std::vector<std::string>{text} : split_list(text, ';'))
      formula.roots.push_back(read(part.c_str(), known_names_));
    formula.root = formula.roots.at(0);
    formula.n_values = nodes_.size();
    for (Index i = 0; i < formula.n_values; ++i)
      for (Index d = 0; d < 3; ++d)
        slope(i, d);
    formula.for_values = needed_by(formula.roots);
    std::vector<Index> derivatives;
    for (const Index root : formula.roots)
      derivatives.insert(derivatives.end(), formula.slopes[root].begin(),
                         formula.slopes[root].begin() + dim);
    formula.for_gradients = needed_by(derivatives);
  }

private:
  using Names = std::map<std::string, Index>;

  static constexpr Index zero = 3, unknown = -1;

  bool take(const char *const token) {
    at_ += std::strspn(at_, " \t\n\v\f\r");
    const std::size_t size = std::strlen(token);
    const bool found = std::strncmp(at_, token, size) == 0;
    at_ += found ? size : 0;
    return found;
  }
  void expect(const char *const token, const char *const expected) {
    if (!take(token))
      refuse(expected);
  }

  /** Refuses the next name, number or character. */
  [[noreturn]] void refuse(const std::string &expected) {
    static const std::map<std::string, const char *> remedies = {
      {"or", "'or' is written '||'"},
      {"and", "'and' is written '&&'"},
      {"not", "'not x' is written 'x == 0'"},
      {"*", "a power is written '^'"},
      {"=", "'=' assigns; comparisons are written '=='"},
      {",", "a comma stands between the arguments of a function"}};
    take("");
    std::size_t size = std::strspn(at_, word);
    if (size == 0 && *at_ != '\0')
      do
        ++size;
      while ((at_[size] & 0xC0) == 0x80);
    const std::string found(at_, size);
    const auto remedy = remedies.find(boost::algorithm::to_lower_copy(found));
    throw std::invalid_argument(
      "found " +
      (found.empty() ? "the end"
                     : quote(found) + " at character " + std::to_string(at_ - text_ + 1)) +
      ", expected " + expected +
      (remedy == remedies.end() ? "" : std::string("; ") + remedy->second));
  }

  /** Returns a part, which is made if there is none like it. */
  Index node(const Operation *const operation, const Indices &arguments, const double value) {
    // The inverse tells 0 and -0 apart.
    const auto [found, is_new] =
      known_.try_emplace({operation, arguments, value, 1. / value}, nodes_.size());
    if (is_new)
      nodes_.push_back({operation, arguments, value, operation == nullptr});
    return found->second;
  }
  Index number(const double value) {
    return node(nullptr, {}, value);
  }
  Index add(const std::string &name, const Index a, const Index b = zero, const Index c = zero) {
    const Operation &operation = *find_operation(name);
    if (operation.kind == Kind::definition)
      return read(operation.in_a, {{"a", a}, {"b", b}, {"c", c}});
    const double value = operation.value(nodes_[a].value, nodes_[b].value, nodes_[c].value);
    if (operation.kind == Kind::choice && nodes_[a].is_fixed)
      return nodes_[a].value != 0. ? b : c;
    if (operation.kind == Kind::power && b == number(1.))
      return a;
    for (const auto &[factor, other] : {std::pair(a, b), {b, a}})
      if (operation.kind == Kind::product && factor == number(1.))
        return other;
    if (nodes_[a].is_fixed && nodes_[b].is_fixed && nodes_[c].is_fixed && !std::isnan(value))
      return number(value);
    return node(&operation, {{a, b, c}}, 0.);
  }

  /** Returns the given parts and those that they are computed from, in their order. */
  std::vector<Index> needed_by(const std::vector<Index> &results) const {
    std::vector<bool> is_needed(nodes_.size());
    for (const Index i : results)
      is_needed[i] = true;
    for (Index i = nodes_.size() - 1; i >= zero; --i)
      if (is_needed[i])
        for (const Index argument : nodes_[i].arguments)
          is_needed[argument] = true;
    std::vector<Index> parts;
    for (Index i = zero; i < nodes_.size(); ++i)
      if (is_needed[i])
        parts.push_back(i);
    return parts;
  }

  /** Returns the derivative of a part, which is made at the first call. */
  Index slope(const Index i, const Index d) {
    if (formula_.slopes.size() < nodes_.size())
      formula_.slopes.resize(nodes_.size(), {{unknown, unknown, unknown}});
    if (formula_.slopes[i][d] != unknown)
      return formula_.slopes[i][d];
    const Index derivative = i == d ? number(1.) : differentiate(i, d);
    return formula_.slopes[i][d] = derivative;
  }
  Index differentiate(const Index i, const Index d) {
    if (nodes_[i].operation == nullptr)
      return zero;
    const Operation &operation = *nodes_[i].operation;
    const auto [a, b, c] = nodes_[i].arguments;
    const Index in_a = operation.in_a == nullptr ? zero : slope(a, d), in_b = slope(b, d),
                in_c = slope(c, d);
    Index sum = zero;
    if (operation.kind == Kind::choice)
      sum = in_b == in_c ? in_b : add("?", a, in_b, in_c);
    for (const auto &[text, inner] : {std::pair(operation.in_a, in_a), {operation.in_b, in_b}})
      if (text != nullptr && inner != zero) {
        const Index factor = read(text, {{"a", a}, {"b", b}, {"f", i}});
        const Index term = add("_times", factor, inner);
        sum = sum == zero ? term : add("+", sum, term);
      }
    if (operation.kind == Kind::zero_step)
      nodes_[i].is_fixed |= nodes_[in_a].is_fixed && nodes_[in_a].value != 0.;
    else if (operation.is_step() && d == 0 && formula_.switches.size() < last_bit) {
      nodes_[i].bit = formula_.switches.size();
      formula_.switches.push_back(i);
    }
    return sum;
  }

  /** Reads a whole text. @param names the parts that it may name. */
  Index read(const char *const text, const Names &names) {
    const auto outer = std::make_tuple(text_, at_, names_);
    text_ = at_ = text;
    names_ = &names;
    const Index i = read_choice();
    if (!take("") || *at_ != '\0')
      refuse("an operator");
    std::tie(text_, at_, names_) = outer;
    return i;
  }
  Index read_choice() {
    const Index condition = read_operators(1);
    if (!take("?"))
      return condition;
    const Index yes = read_choice();
    expect(":", "an operator or ':'");
    return add("?", condition, yes, read_choice());
  }
  /** Reads operators of a level and above. */
  Index read_operators(const unsigned int level) {
    if (level == 6)
      return read_signed();
    Index a = read_operators(level + 1);
    bool is_comparison = false;
    for (auto operation = operations().begin(); operation != operations().end();)
      if (operation->precedence == level && take(operation->name)) {
        if (is_comparison)
          throw std::invalid_argument("it compares the answer of a comparison; a<x<b is written "
                                      "(a<x) && (x<b)");
        is_comparison = level == 3;
        a = add(operation->name, a, read_operators(level + 1));
        operation = operations().begin();
      } else
        ++operation;
    return a;
  }
  Index read_signed() {
    if (++depth_ > 500)
      throw std::invalid_argument("more than 500 parentheses or powers stand in one another");
    const bool is_negative = take("-");
    if (!is_negative)
      take("+");
    Index a = read_operand();
    if (take("^"))
      a = add("^", a, read_signed());
    --depth_;
    return is_negative ? add("*", number(-1.), a) : a;
  }
  Index read_operand() {
    if (take("(")) {
      const Index a = read_choice();
      expect(")", "an operator or ')'");
      return a;
    }
    if (std::strspn(at_, "0123456789.") > 0) {
      char *end = nullptr;
      const double value = std::strtod(at_, &end);
      const bool is_hexadecimal = at_[0] == '0' && (at_[1] == 'x' || at_[1] == 'X');
      if (end == at_ || std::isinf(value) || is_hexadecimal)
        refuse("a decimal number below 1.8e308");
      at_ = end;
      return number(value);
    }
    const std::string name(at_, std::strspn(at_, word));
    if (at_[name.size()] == '(' && is_function(name)) {
      at_ += name.size() + 1;
      return read_arguments(name);
    }
    const Index part = part_of(name);
    if (part == unknown)
      refuse(name.empty()        ? "a number, a name or '('"
             : is_function(name) ? quote(name + "(")
                                 : "a known name");
    at_ += name.size();
    return part;
  }
  /** Returns the part that a name stands for; unknown if there is none. */
  Index part_of(const std::string &name) {
    if (const auto found = names_->find(name); found != names_->end())
      return found->second;
    if (const auto definition = definitions_.find(name); definition != definitions_.end()) {
      const auto [found, is_new] = known_names_.try_emplace(name, zero);
      if (is_new)
        found->second = read(definition->second.c_str(), known_names_);
      return found->second;
    }
    for (const Constants *const constants : {&constants_, &known_constants()})
      if (const auto found = constants->find(name); found != constants->end())
        return number(found->second);
    return unknown;
  }
  /** Returns whether the text may call a function of this name; texts of operations() call all. */
  bool is_function(const std::string &name) const {
    return definitions_.count(name) > 0 || is_derivative(name) ||
           (names_ == &known_names_ ? is_known_function(name) : find_operation(name) != nullptr);
  }
  /** Returns whether a text with definitions names a derivative: dx, dy or dz. */
  bool is_derivative(const std::string &name) const {
    return !definitions_.empty() && name.size() == 2 && name[0] == 'd';
  }
  /** Reads the arguments of a function and its ')'. */
  Index read_arguments(const std::string &name) {
    const auto definition = definitions_.find(name);
    const Operation *const operation =
      definition == definitions_.end() ? find_operation(name) : nullptr;
    const bool takes_any = operation != nullptr && operation->n_arguments == 0;
    Indices parts = {{zero, zero, zero}};
    Index n = 0;
    if (!take(")")) {
      do {
        const Index part = read_choice();
        if (takes_any)
          parts[0] = n == 0 ? part : add(name, parts[0], part);
        else if (n < parts.size())
          parts[n] = part;
        ++n;
      } while (take(","));
      expect(")", "an operator, ',' or ')'");
    }
    if (operation != nullptr && is_known_function(name) &&
        (takes_any ? n == 0 : n != operation->n_arguments))
      throw std::invalid_argument(
        "found " + std::to_string(n) + " arguments of " + quote(name) + ", expected " +
        (takes_any ? "one or more" : std::to_string(operation->n_arguments)));
    const auto [a, b, c] = parts;
    if (definition != definitions_.end()) {
      Names names = known_names_;
      for (const auto &[argument, part] : {std::pair("a", a), {"b", b}, {"c", c}})
        names[argument] = part;
      return read(definition->second.c_str(), names);
    }
    if (operation == nullptr)
      return slope(a, name[1] - 'x');
    return !takes_any ? add(name, a, b, c) : name == "avg" ? add("/", a, number(n)) : a;
  }

  /** The characters of names. */
  static constexpr const char *word =
    "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_";

  const Constants &constants_;
  const Definitions &definitions_;
  Formula &formula_;
  std::vector<Node> &nodes_;
  /** How often read_signed() has called itself: each time takes a part of the stack. */
  unsigned int depth_ = 0;
  /** The text being read, and where its rest begins. */
  const char *text_ = nullptr, *at_ = nullptr;
  /** The names of the coordinates and of definitions that have been read. */
  Names known_names_;
  /** The names that the text being read may use. */
  const Names *names_ = nullptr;
  std::map<std::tuple<const Operation *, Indices, double, double>, Index> known_;
};
} // namespace FormulaParts
} // namespace Signorini
