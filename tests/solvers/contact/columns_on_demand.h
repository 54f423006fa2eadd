// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/solvers/contact/dual_problem.h>

#include <set>
#include <stdexcept>

/** Hands out columns of a matrix and remembers which: columns are kept. */
class ColumnsOnDemand final : public Signorini::DenseCompliance {
public:
  explicit ColumnsOnDemand(const Matrix &from)
    : DenseCompliance(Matrix(from.m(), from.n()))
    , from_(from) {}

  Vector diagonal() const override {
    throw std::logic_error("the whole diagonal costs all columns");
  }
  const Matrix &dense() const override {
    throw std::logic_error("all of C costs all columns");
  }
  bool is_explicit() const override {
    return false;
  }

  /** In ascending order. */
  const std::set<unsigned int> &asked() const {
    return asked_;
  }

private:
  void require(const Indices &numbers) const override {
    for (const unsigned int j : numbers)
      if (asked_.insert(j).second)
        for (unsigned int i = 0; i < size(); ++i)
          C_(i, j) = from_(i, j);
  }

  const Matrix &from_;
  mutable std::set<unsigned int> asked_;
};
