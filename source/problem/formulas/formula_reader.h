// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/text.h>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string>
#include <tuple>

#include "formula_tree.h"

namespace Signorini {
namespace FormulaParts {
/** Reads a formula with the precedence of muParser: ?:, ||, &&, comparisons, + -, * /, signs, ^. */
class Reader {
public:
  Reader(const std::string &text, const Constants &constants, const Definitions &definitions,
         const unsigned int dim, Formula &formula)
    : constants_(constants)
    , definitions_(definitions)
    , formula_(formula)
    , nodes_(formula.nodes) {
    constants_.insert({{"pi", std::acos(-1.)}, {"_pi", std::acos(-1.)}, {"_e", std::exp(1.)}});
    number(0.);
    for (Index d = 0; d < dim; ++d)
      known_names_[std::string(1, "xyz"[d])] = d;
    for (const std::string &part : split_list(text, ';'))
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
  static constexpr Index zero = 3, unknown = -1;

  bool take(const char *const token) {
    at_ += std::strspn(at_, " \t\n\r");
    const std::size_t size = std::strlen(token);
    const bool found = std::strncmp(at_, token, size) == 0;
    at_ += found ? size : 0;
    return found;
  }
  void expect(const bool condition) const {
    if (!condition)
      throw std::invalid_argument("unknown formula");
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
    for (const Operation &operation : operations())
      if (name == operation.name) {
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
    expect(false);
    return zero;
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
        const Index term = add("times", factor, inner);
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
  Index read(const char *text, std::map<std::string, Index> names) {
    std::swap(at_, text);
    names_.swap(names);
    const Index i = read_choice();
    expect(take("") && *at_ == '\0');
    std::swap(at_, text);
    names_.swap(names);
    return i;
  }
  Index read_choice() {
    const Index condition = read_operators(1);
    if (!take("?"))
      return condition;
    const Index yes = read_choice();
    expect(take(":"));
    return add("?", condition, yes, read_choice());
  }
  /** Reads operators of a level and above. */
  Index read_operators(const unsigned int level) {
    if (level == 6)
      return read_signed();
    Index a = read_operators(level + 1);
    for (auto operation = operations().begin(); operation != operations().end();)
      if (operation->precedence == level && take(operation->name)) {
        a = add(operation->name, a, read_operators(level + 1));
        operation = operations().begin();
      } else
        ++operation;
    return a;
  }
  Index read_signed() {
    if (take("-"))
      return add("*", number(-1.), read_signed());
    if (take("+"))
      return read_signed();
    const Index a = read_operand();
    return take("^") ? add("^", a, read_signed()) : a;
  }
  Index read_operand() {
    if (take("(")) {
      const Index a = read_choice();
      expect(take(")"));
      return a;
    }
    if (std::strspn(at_, "0123456789.") > 0) {
      char *end = nullptr;
      const double value = std::strtod(at_, &end);
      at_ = end;
      return number(value);
    }
    const std::string name(
      at_, std::strspn(at_, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_"));
    at_ += name.size();
    if (take("("))
      return read_function(name);
    if (names_.count(name) > 0)
      return names_[name];
    if (const auto definition = definitions_.find(name); definition != definitions_.end()) {
      const auto [found, is_new] = known_names_.try_emplace(name, zero);
      if (is_new)
        found->second = read(definition->second.c_str(), known_names_);
      return found->second;
    }
    expect(constants_.count(name) > 0);
    return number(constants_[name]);
  }
  Index read_function(const std::string &name) {
    Index a = read_choice(), n = 1;
    if (name == "max" || name == "min" || name == "sum" || name == "avg")
      for (; take(","); ++n)
        a = add(name, a, read_choice());
    else {
      const Index b = take(",") ? read_choice() : zero, c = take(",") ? read_choice() : zero;
      const auto definition = definitions_.find(name);
      if (definition != definitions_.end()) {
        std::map<std::string, Index> names = known_names_;
        for (const auto &[argument, part] : {std::pair("a", a), {"b", b}, {"c", c}})
          names[argument] = part;
        a = read(definition->second.c_str(), names);
      } else if (!definitions_.empty() && name.size() == 2 && name[0] == 'd')
        a = slope(a, name[1] - 'x');
      else
        a = add(name, a, b, c);
    }
    expect(take(")"));
    return name == "avg" ? add("/", a, number(n)) : a;
  }

  Constants constants_;
  const Definitions &definitions_;
  Formula &formula_;
  std::vector<Node> &nodes_;
  const char *at_ = nullptr;
  /** The names that the text being read may use, and those of the coordinates and of definitions
   * that have been read. */
  std::map<std::string, Index> names_, known_names_;
  std::map<std::tuple<const Operation *, Indices, double, double>, Index> known_;
};
} // namespace FormulaParts
} // namespace Signorini
