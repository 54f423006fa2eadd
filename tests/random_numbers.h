// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/lac/vector.h>

/** Numbers in [-1, 1) that are the same on every machine. */
class RandomNumbers {
public:
  explicit RandomNumbers(const unsigned int seed)
    : state_(seed) {}

  double operator()() {
    state_ = 6364136223846793005ULL * state_ + 1442695040888963407ULL;
    return static_cast<double>(state_ >> 11U) / 4503599627370496. - 1.;
  }
  dealii::Vector<double> vector(const unsigned int n) {
    dealii::Vector<double> values(n);
    for (double &value : values)
      value = (*this)();
    return values;
  }

private:
  unsigned long long state_;
};
