// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/solvers/contact/dual_problem.h>

#include <set>
#include <stdexcept>

/** Hands out columns of a matrix and remembers which: what was asked for once is kept. */
class ColumnsOnDemand final : public Signorini::ComplianceOperator
{
public:
  explicit ColumnsOnDemand(const Matrix &from)
    : from_(from)
    , kept_(from.m(), from.n())
  {
  }

  unsigned int size() const override
  {
    return from_.m();
  }
  Vector apply(const Vector &P) const override
  {
    Vector product(size());
    for (unsigned int j = 0; j < size(); ++j)
      if (P[j] != 0.)
      {
        keep(j);
        for (unsigned int i = 0; i < size(); ++i)
          product[i] += kept_(i, j) * P[j];
      }
    return product;
  }
  Vector diagonal() const override
  {
    throw std::logic_error("the whole diagonal costs all columns");
  }
  Matrix columns(const Indices &numbers) const override
  {
    Matrix found(size(), numbers.size());
    for (unsigned int k = 0; k < numbers.size(); ++k)
    {
      keep(numbers[k]);
      for (unsigned int i = 0; i < size(); ++i)
        found(i, k) = kept_(i, numbers[k]);
    }
    return found;
  }
  const Matrix &dense() const override
  {
    throw std::logic_error("all of C costs all columns");
  }
  bool is_explicit() const override
  {
    return false;
  }

  /** In ascending order. */
  const std::set<unsigned int> &asked() const
  {
    return asked_;
  }
  const Matrix &kept() const
  {
    return kept_;
  }

private:
  void keep(const unsigned int j) const
  {
    if (asked_.insert(j).second)
      for (unsigned int i = 0; i < size(); ++i)
        kept_(i, j) = from_(i, j);
  }

  const Matrix &from_;
  mutable Matrix kept_;
  mutable std::set<unsigned int> asked_;
};
