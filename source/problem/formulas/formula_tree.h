// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/problem/formulas/formula.h>

#include <boost/numeric/interval.hpp>

#include <array>
#include <string>
#include <vector>

namespace Signorini {
namespace FormulaParts {
namespace lib = boost::numeric::interval_lib;
using Interval =
  boost::numeric::interval<double,
                           lib::policies<lib::save_state_nothing<lib::rounded_transc_exact<double>>,
                                         lib::checking_base<double>>>;
inline bool is_zero(const Interval &a) {
  return singleton(a) && zero_in(a);
}

using Index = unsigned int;
using Indices = std::array<Index, 3>;

/** The kinds of operations. */
enum class Kind {
  /** Stands for another formula of a, b and c. */
  definition,
  /** Is smooth where it is defined. */
  smooth,
  product,
  power,
  /** Jumps where a changes its sign. */
  sign_step,
  /** Jumps where a reaches another integer. */
  integer_step,
  /** Differs from zero where a vanishes. */
  zero_step,
  /** Returns b or c. */
  choice
};

/** An operator or a function of a, b and c. */
struct Operation {
  const char *name;
  Kind kind;
  /** The formula that a definition stands for; of others the derivatives in a and b, as formulas
   * that may also name the value f. */
  const char *in_a, *in_b = nullptr;
  /** The precedence of an operator; 0 of functions. */
  unsigned int precedence = 0;
  /** The number of arguments of a known function; 0 if it takes any, two after the other. */
  unsigned int n_arguments = 1;
  double (*value)(double, double, double) = nullptr;
  void (*values)(const double *, const double *, const double *, std::size_t, double *) = nullptr;
  Interval (*bounds)(const Interval &, const Interval &, const Interval &) = nullptr;

  bool is_step() const {
    return kind == Kind::sign_step || kind == Kind::integer_step || kind == Kind::zero_step;
  }
};

/** Returns all operations. Their texts alone call those whose name begins with '_'. */
const std::vector<Operation> &operations();

/** Returns the operation of a name; nullptr if there is none. */
const Operation *find_operation(const std::string &name);

/** Returns whether every formula may call a function of this name. */
bool is_known_function(const std::string &name);

/** Returns the constants that every formula may name. */
const Constants &known_constants();

constexpr unsigned int last_bit = 63;

/** A part of a formula: an operation on earlier parts, or a number. */
struct Node {
  const Operation *operation;
  Indices arguments;
  double value;
  /** Whether the part has this value everywhere but on lines: numbers, and the zero_step of an
   * argument that vanishes on lines only. */
  bool is_fixed;
  /** The bit of its switch; the last one stands for all switches without number. */
  unsigned int bit = last_bit;
};

/** The parts of a formula: three coordinates, zero, those of its value, and derivatives. */
struct Formula {
  std::vector<Node> nodes = std::vector<Node>(3);
  Index root = 0, n_values = 0;
  /** The formulas of the text; the root is the first one. */
  std::vector<Index> roots = {};
  /** The derivatives of all that the value needs. */
  std::vector<Indices> slopes = {};
  /** The parts that the formulas and their derivatives need, but for coordinates. */
  std::vector<Index> for_values = {}, for_gradients = {};
  /** The steps that have a number. */
  std::vector<Index> switches = {};
};
} // namespace FormulaParts
} // namespace Signorini
